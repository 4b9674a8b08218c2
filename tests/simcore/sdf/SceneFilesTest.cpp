// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SceneFiles.h"

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "robotlink/base/Geometry.h"
#include "simcore/sdf/SdfSpec.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::AllOf;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;

std::string paletteOf(const std::string& colors) {
  return "<robotcontrol:palette>" + colors + "</robotcontrol:palette>";
}

std::string colorNamed(const std::string& attribute, const std::string& channels) {
  return "\n<robotcontrol:color" + attribute + ">" + channels + "</robotcontrol:color>";
}

class SceneFilesTest : public testing::Test {
 protected:
  void SetUp() override { folder_.writeModel("leg", kSmallModel); }
  SceneFiles read(const std::string& contents, SceneFiles::Texts texts = {}) {
    errors_.clear();
    return {
        folder_.write("world.sdf", worldAround(contents)), {}, std::move(texts), SdfSpec::shared(), errors_};
  }
  /// The errors of a file that is no scene.
  std::string errorsOfText(const std::string& text) {
    errors_.clear();
    const SceneFiles files(folder_.write("world.sdf", text), {}, {}, SdfSpec::shared(), errors_);
    EXPECT_EQ(files.world(), nullptr);
    return describe(errors_);
  }

  const SceneFolder folder_;
  robotlink::Errors errors_;
};

TEST_F(SceneFilesTest, whatIsWrongWithXmlIsSaidInWordsWithItsLine) {
  EXPECT_THAT(errorsOfText(""), HasSubstr("world.sdf:1: this is not well-formed XML: the file is empty"));
  EXPECT_THAT(errorsOfText("<sdf>\n<world>\n</sdf>"), HasSubstr("a closing tag does not match the last"));
  EXPECT_THAT(errorsOfText("<sdf version=1.9></sdf>"), HasSubstr("is not written as name=\"value\""));
  EXPECT_THAT(errorsOfText("<sdf>\n<!-- never closed"), HasSubstr("world.sdf:2: "));
  EXPECT_THAT(errorsOfText("<sdf>\n<!-- never closed"), HasSubstr("a comment is not closed"));
  EXPECT_THAT(errorsOfText("no tags"), HasSubstr("text where only tags may be"));
  std::string deep;
  for (int i = 0; i < 2000; ++i) deep += "<a>";
  EXPECT_THAT(errorsOfText(deep), HasSubstr("tags are nested too deeply"));
}

TEST_F(SceneFilesTest, whatIsWrongWithAUrdfIsSaidWithItsLine) {
  const auto errorsOf = [&](const std::string& contents) {
    const std::string text = errorsOfText("<robot name='r'>\n" + contents + "</robot>");
    return text.substr(text.find("world.sdf"));
  };
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial>";
  const std::string links = "<link name='a'>" + inertial + "</link><link name='b'>" + inertial + "</link>\n";
  const auto joint = [](const std::string& name, const std::string& parent, const std::string& child) {
    return "<joint name='" + name + "' type='fixed'><parent link='" + parent + "'/><child link='" + child +
           "'/></joint>\n";
  };
  EXPECT_EQ(errorsOf(""), "world.sdf:1: r: a URDF needs a <link>");
  EXPECT_EQ(errorsOf("<link name='a'><inertial>\n<mass value='${m}'/></inertial></link>"),
            "world.sdf:3: r/a: the attribute 'value' of <mass> must be a number, not '${m}'");
  EXPECT_EQ(errorsOf("<link name='a'><visual><origin xyz='1 2'/></visual></link>"),
            "world.sdf:2: r/a: the attribute 'xyz' of <origin> must be 3 numbers, not '1 2'");
  EXPECT_EQ(errorsOf("<link name='a'/>\n<link name='a'/>"),
            "world.sdf:3: r/a: the name 'a' appears here twice");
  EXPECT_EQ(errorsOf(links + joint("j", "a", "c")),
            "world.sdf:3: r/j: the joint 'j' names the link 'c', which does not exist");
  EXPECT_EQ(errorsOf(links + "<joint name='j' type='fixed'><parent link='a'/></joint>"),
            "world.sdf:3: r/j: the joint 'j' needs <child link=\"...\"/>");
  EXPECT_EQ(errorsOf(links), "world.sdf:1: r: no joint connects 'a' and 'b'; a URDF is one tree of links");
  EXPECT_EQ(errorsOf(links + joint("j", "a", "b") + joint("k", "b", "a")),
            "world.sdf:1: r: its joints form a cycle; a URDF is one tree of links");
  EXPECT_THAT(errorsOf(links + joint("j", "a", "b") + joint("k", "a", "b")),
              HasSubstr("world.sdf:4: r/k: the link 'b' is also the child of another joint"));
  EXPECT_THAT(errorsOf("<link name='a'/>"),
              HasSubstr("no link is left of this URDF, because links without <inertial> are left out"));
}

TEST_F(SceneFilesTest, aUrdfWhoseConversionWouldTakeAllMemoryIsRefused) {
  std::string links;
  for (int i = 0; i < 800; ++i) links += "<link name='l" + std::to_string(i) + "'/>";
  EXPECT_THAT(errorsOfText("<robot name='r'>" + links + "</robot>"),
              HasSubstr("it has too many links and joints to be converted; write it as SDFormat"));
}

TEST_F(SceneFilesTest, theDetailsOfAnIncludeAreRead) {
  const SceneFiles files = read(R"(<include><uri>model://leg</uri><name>one</name><pose>1 2 3 0 0 0.5</pose>
      <static>true</static><robotcontrol:team>red</robotcontrol:team>
      <robotcontrol:role>keeper</robotcontrol:role>
      <robotcontrol:motion objects="stop">kinematic</robotcontrol:motion></include>
      <include><uri>model://leg</uri></include>)");
  EXPECT_EQ(describe(errors_), "");
  ASSERT_EQ(files.includes().size(), 2U);
  const SceneInclude& one = files.includes()[0];
  EXPECT_EQ(one.name, "one");
  EXPECT_EQ(one.team, "red");
  EXPECT_EQ(one.role, "keeper");
  EXPECT_EQ(one.motion, "kinematic");
  EXPECT_EQ(one.motionAtObjects, "stop");
  EXPECT_EQ(one.isStatic, true);
  EXPECT_THAT(one.pose.value(), ElementsAre(1, 2, 3, 0, 0, 0.5));
  EXPECT_EQ(one.file, folder_ / "models/leg/model.sdf");
  const SceneInclude& other = files.includes()[1];
  EXPECT_EQ(other.isStatic, std::nullopt);
  EXPECT_EQ(other.pose, std::nullopt);
  EXPECT_GT(other.line, one.line);
  EXPECT_NE(files.model(other.file), nullptr);
}

TEST_F(SceneFilesTest, aPoseHasSixNumbersAndNothingElse) {
  for (const char* pose : {"1 2 3", "1 2 3 0 0 0 0", "1 2 3 0 0 x", "1,2,3,0,0,0"}) {
    read("<include><uri>model://leg</uri>\n<pose>" + std::string(pose) + "</pose></include>");
    EXPECT_THAT(describe(errors_), HasSubstr("number")) << pose;
  }
}

TEST_F(SceneFilesTest, aPoseMayHaveDegreesOrAQuaternion) {
  const auto poseOf = [&](const std::string& attributes, const std::string& numbers) {
    const SceneFiles files =
        read("<include><uri>model://leg</uri><pose " + attributes + ">" + numbers + "</pose></include>");
    EXPECT_EQ(describe(errors_), "");
    return files.includes().at(0).pose.value();
  };
  const auto isNear = [](double x) { return DoubleNear(x, 1e-6); };
  const double quarter = robotlink::kPi / 2;
  EXPECT_THAT(poseOf("degrees='true'", "1 2 3 180 0 90"),
              ElementsAre(1, 2, 3, isNear(2 * quarter), isNear(0), isNear(quarter)));
  EXPECT_THAT(poseOf("rotation_format='quat_xyzw'", "1 2 3 0 0 2 2"),
              ElementsAre(1, 2, 3, isNear(0), isNear(0), isNear(quarter)));
  // Roll 0.3, pitch -0.4, yaw 2.
  EXPECT_THAT(poseOf("rotation_format='quat_xyzw'", "0 0 0 0.2444296 0.0171051 0.831478 0.4986039"),
              ElementsAre(0, 0, 0, isNear(0.3), isNear(-0.4), isNear(2)));
  EXPECT_THAT(poseOf("rotation_format='quat_xyzw'", "0 0 0 0 1 0 1"),
              ElementsAre(0, 0, 0, isNear(0), isNear(quarter), isNear(0)));
  EXPECT_THAT(poseOf("rotation_format='quat_xyzw'", "0 0 0 0 0 0 0"), ElementsAre(0, 0, 0, 0, 0, 0));
}

TEST_F(SceneFilesTest, thePaletteIsThatOfTheWorldAndOfAllModels) {
  folder_.writeModel("painted",
                     replaced(kSmallModel, "</robotcontrol:palette>",
                              colorNamed(" name='mint'", "0 255 128") + "</robotcontrol:palette>"));
  const SceneFiles files = read(paletteOf(colorNamed(" name='sky'", " 90 150\n255 ")) +
                                "<include><uri>model://painted</uri></include>");
  EXPECT_EQ(describe(errors_), "");
  EXPECT_THAT(files.palette(), ElementsAre(Key("mint"), Key("red"), Key("sky")));
  EXPECT_EQ(files.palette().at("sky"), (Rgb{90, 150, 255}));
}

TEST_F(SceneFilesTest, aColorNeedsANameAndThreeNumbersOfAByte) {
  for (const char* channels : {"", "1 2", "1 2 256", "-1 2 3", "red", "1 2 blue", "1 2 3 4", "1 2 3.5"}) {
    const SceneFiles files = read(paletteOf(colorNamed(" name='sky'", channels)));
    EXPECT_THAT(describe(errors_), HasSubstr("a color needs a name and three numbers from 0 to 255"))
        << channels;
    EXPECT_TRUE(files.palette().empty()) << channels;
  }
  read(paletteOf(colorNamed("", "1 2 3")));
  EXPECT_NE(describe(errors_), "");
}

TEST_F(SceneFilesTest, aModelOfTheNetworkIsLeftOutWithAWayOut) {
  const SceneFiles files = read("<include><uri>https://models.org/box</uri></include>");
  EXPECT_EQ(describe(errors_), "");
  EXPECT_TRUE(files.includes().empty());
  EXPECT_EQ(files.world()->FirstChildElement("include"), nullptr);
  ASSERT_EQ(files.leftOut().size(), 1U);
  EXPECT_THAT(files.leftOut()[0].what, HasSubstr("https://models.org/box"));
}

TEST_F(SceneFilesTest, aModelThatIsNotFoundHasItsLineAndWhereItWasSearched) {
  const SceneFiles files = read("\n<include><uri>model://arm</uri></include>");
  EXPECT_THAT(describe(errors_), AllOf(HasSubstr("world.sdf:"), HasSubstr("there is no model 'model://arm'"),
                                       HasSubstr("--models"), HasSubstr(folder_.path().string())));
  EXPECT_TRUE(files.includes().empty());
}

TEST_F(SceneFilesTest, aTextCountsInsteadOfTheFileThatIsEdited) {
  const auto edited = std::filesystem::canonical(folder_ / "models/leg/model.sdf");
  const SceneFiles files = read("<include><uri>model://leg</uri></include>",
                                {{edited, replaced(kSmallModel, "<link", "<static>true</static><link")}});
  EXPECT_EQ(describe(errors_), "");
  EXPECT_NE(files.model(files.includes().at(0).file)->FirstChildElement("static"), nullptr);
  const SceneFiles broken = read("<include><uri>model://leg</uri></include>", {{edited, "<sdf"}});
  EXPECT_THAT(describe(errors_), AllOf(HasSubstr("model.sdf:1"), HasSubstr("not well-formed")));
}

TEST_F(SceneFilesTest, theFileOfAnIncludeIsKnownByItsElement) {
  const SceneFiles files = read("<include><uri>model://leg</uri></include>");
  const auto* include = files.world()->FirstChildElement("include");
  ASSERT_NE(include, nullptr);
  ASSERT_NE(files.fileOf(*include), nullptr);
  EXPECT_EQ(*files.fileOf(*include), folder_ / "models/leg/model.sdf");
  EXPECT_EQ(files.fileOf(*files.world()), nullptr);
  EXPECT_EQ(files.model(folder_ / "other.sdf"), nullptr);
}

TEST_F(SceneFilesTest, modelsOfRobotsAreAddedByNameOnly) {
  SceneFiles files = read("");
  const auto added = files.addModel("leg", SdfSpec::shared(), errors_);
  ASSERT_TRUE(added) << describe(errors_);
  EXPECT_NE(files.model(*added), nullptr);
  for (const char* name : {"", ".", "..", "models/leg", "../leg", "/etc", "arm"}) {
    errors_.clear();
    EXPECT_FALSE(files.addModel(name, SdfSpec::shared(), errors_)) << name;
    EXPECT_THAT(describe(errors_), HasSubstr("there is no model '" + std::string(name) + "' to add"));
  }
}

TEST_F(SceneFilesTest, furtherModelsAreAddedByNameFileOrKindOfRobot) {
  folder_.writeModel(
      "walker", replaced(kSmallModel, "<link", "<robotcontrol:robot>quadruped</robotcontrol:robot><link"));
  SceneFiles files = read("");
  const auto addedOf = [&](const std::string& source) {
    return files.addModelOf(source, SdfSpec::shared(), errors_).value_or("none");
  };
  EXPECT_EQ(addedOf("leg"), folder_ / "models/leg/model.sdf");
  EXPECT_EQ(addedOf((folder_ / "models/leg/model.sdf").string()), folder_ / "models/leg/model.sdf");
  EXPECT_EQ(addedOf("quadruped"), folder_ / "models/walker/model.sdf");
  EXPECT_EQ(describe(errors_), "");
  EXPECT_EQ(addedOf("hexapod"), "none");
  EXPECT_THAT(describe(errors_), AllOf(HasSubstr("there is no model 'hexapod'"), HasSubstr("(searched: ")));
}

TEST_F(SceneFilesTest, aFurtherModelThatIsWrongSaysSo) {
  folder_.writeModel("empty", "<sdf version='1.9'/>");
  SceneFiles files = read("");
  (void)files.addModel("empty", SdfSpec::shared(), errors_);
  EXPECT_THAT(describe(errors_), HasSubstr("describes no model"));
}

}  // namespace
}  // namespace simcore
