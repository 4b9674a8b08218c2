// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Scene.h"

#include <gmock/gmock.h>

#include <set>

#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class SceneTest : public testing::Test {
 protected:
  SceneTest() { folder_.writeModel("small", kSmallModel); }
  static std::string include(const std::string& rest) {
    return "<include><uri>model://small</uri>" + rest + "</include>";
  }
  std::string errorsWithModel(const std::string& from, const std::string& to) const {
    folder_.writeModel("small", replaced(kSmallModel, from, to));
    return folder_.errorsOf(worldAround(include("")));
  }
  SceneFolder folder_;
};

TEST_F(SceneTest, theShippedSceneHasOneRobotOnTheField) {
  const auto scene = shippedScene();
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->robots().size(), 1U);
  EXPECT_EQ(scene->robots()[0].name, "red1");
  EXPECT_EQ(scene->robots()[0].description, "ers210");
}

TEST_F(SceneTest, aModelIsParsedOnceHoweverOftenItIsIncluded) {
  std::string includes;
  for (int i = 0; i < 8; ++i) {
    includes +=
        include("<name>m" + std::to_string(i) + "</name><pose>" + std::to_string(i) + " 0 0 0 0 0</pose>");
  }
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(includes)));
  ASSERT_TRUE(scene) << describe(scene.error());
  std::set<const ModelDescription*> types;
  for (const ModelInstance& model : (*scene)->contents().world.models) types.insert(model.type.get());
  EXPECT_EQ((*scene)->contents().world.models.size(), 8U);
  EXPECT_EQ(types.size(), 1U);
}

TEST_F(SceneTest, includesInCommentsAreNone) {
  const std::string world =
      worldAround("<!-- <include> --><!--x--><include>\n<uri>model://small</uri></include>");
  EXPECT_EQ(folder_.errorsOf(world), "");
  EXPECT_EQ(folder_.errorsOf(worldAround("<!-- <include><uri>model://none</uri></include> -->")), "");
}

TEST_F(SceneTest, aModelMayStandInTheWorldItself) {
  const std::string model =
      replaced(replaced(kSmallModel, "<?xml version=\"1.0\"?>", ""), "<model", "<world name='w'><model");
  EXPECT_EQ(folder_.errorsOf(replaced(model, "</model>", "</model></world>")), "");
}

TEST_F(SceneTest, robotsWearTheirTeamsColor) {
  const std::string palette =
      "<robotcontrol:palette><robotcontrol:color name=\"blue\">0 0 "
      "90</robotcontrol:color></robotcontrol:palette>";
  folder_.writeModel("small", replaced(kSmallModel, "<robotcontrol:color>red", "<robotcontrol:color>team"));
  const std::string red = include("<robotcontrol:team>red</robotcontrol:team>");
  const std::string blue =
      include("<name>other</name><pose>1 0 0 0 0 0</pose><robotcontrol:team>blue</robotcontrol:team>");
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(palette + red + blue)));
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto& instances = (*scene)->contents().renderScene->instances;
  ASSERT_EQ(instances.size(), 2U);
  EXPECT_EQ(instances[0].color, (robotlink::Rgb{200, 0, 0}));
  EXPECT_EQ(instances[1].color, (robotlink::Rgb{0, 0, 90}));
  EXPECT_EQ(instances[0].colorName, "red");
  EXPECT_EQ(instances[1].colorName, "blue");
  EXPECT_EQ(instances[0].mesh, instances[1].mesh) << "equal shapes share a mesh";
}

TEST_F(SceneTest, aCameraMayHaveVignetting) {
  const auto withCamera = [](const std::string& lens) {
    return "<sensor name=\"eye\" type=\"camera\"><update_rate>25</update_rate><camera>"
           "<horizontal_fov>1</horizontal_fov><image><width>8</width><height>6</height></image>" +
           lens + "</camera></sensor><sensor name=\"touch\"";
  };
  const std::string lens =
      "<robotcontrol:vignetting>0.4</robotcontrol:vignetting>"
      "<robotcontrol:vignetting_tint>0.1</robotcontrol:vignetting_tint>";
  for (const auto& [text, expected] :
       {std::pair(std::string(), LensVignetting()), std::pair(lens, LensVignetting{0.4, 0.1})}) {
    folder_.writeModel("small", replaced(kSmallModel, "<sensor name=\"touch\"", withCamera(text)));
    const auto scene = Scene::load(folder_.write("world.sdf", worldAround(include(""))));
    ASSERT_TRUE(scene) << describe(scene.error());
    const auto simulation = Simulation::create(*scene, {});
    ASSERT_TRUE(simulation) << simulation.error().describe();
    ASSERT_EQ((*simulation)->cameras().size(), 1U);
    EXPECT_EQ((*simulation)->cameras()[0].model.vignetting, expected);
  }
  folder_.writeModel(
      "small", replaced(kSmallModel, "<sensor name=\"touch\"", withCamera(replaced(lens, "0.4", "1.4"))));
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(include(""))));
  ASSERT_TRUE(scene) << describe(scene.error());
  ASSERT_EQ((*scene)->leftOut().size(), 1U);
  EXPECT_EQ((*scene)->leftOut()[0].what, "<robotcontrol:vignetting>");
  EXPECT_EQ((*scene)->leftOut()[0].why, "vignetting must be between 0 and 1, not 1.4");
}

TEST_F(SceneTest, aFileThatCannotBeReadIsAnError) {
  const auto scene = Scene::load("/nowhere/world.sdf");
  ASSERT_FALSE(scene);
  EXPECT_THAT(describe(scene.error()), StartsWith("/nowhere/world.sdf"));
}

TEST_F(SceneTest, brokenXmlHasItsLine) {
  EXPECT_THAT(folder_.errorsOf("<sdf version=\"1.9\">\n<world name=\"w\">\n</sdf>"),
              StartsWith("world.sdf:2: this is not well-formed XML: a closing tag does not match"));
  EXPECT_THAT(folder_.errorsOf(""),
              StartsWith("world.sdf:1: this is not well-formed XML: the file is empty"));
  std::string deep;
  for (int i = 0; i < 10'000; ++i) deep += "<a>";
  EXPECT_THAT(folder_.errorsOf(deep),
              StartsWith("world.sdf:1: this is not well-formed XML: tags are nested too deeply"));
}

TEST_F(SceneTest, brokenIncludesHaveTheirLine) {
  EXPECT_THAT(folder_.errorsOf(worldAround("<include><uri>model://smal</uri></include>")),
              StartsWith("world.sdf:3: test: there is no model 'model://smal'; name the folder"));
  EXPECT_EQ(folder_.errorsOf(worldAround(include("") + "\n" + include(""))),
            "world.sdf:4: there is another model 'small'");
  EXPECT_THAT(folder_.errorsOf(worldAround(include("<pose>1 2 3</pose>"))),
              HasSubstr("world.sdf:3: test: <pose> must be 6 finite numbers"));
  EXPECT_EQ(folder_.errorsOf(worldAround(include("<pose>1e9 0 0 0 0 0</pose>"))),
            "world.sdf:3: a pose must be finite and at most 100 km away");
  EXPECT_EQ(folder_.errorsOf(worldAround(include("<robotcontrol:team>mauve</robotcontrol:team>"))),
            "world.sdf:3: no palette has the color 'mauve'");
}

TEST_F(SceneTest, anIncludedFileWithoutAModelIsRefused) {
  folder_.writeModel("small", "<sdf version=\"1.9\"><world name=\"w\"/></sdf>");
  EXPECT_THAT(folder_.errorsOf(worldAround(include(""))), HasSubstr("describes no model"));
}

TEST_F(SceneTest, aFileWithoutAWorldAndAModelIsRefused) {
  EXPECT_THAT(folder_.errorsOf("<sdf version=\"1.9\"/>"), HasSubstr("the file must describe a world"));
}

TEST_F(SceneTest, aModelAloneStandsOnAFloor) {
  const auto scene = Scene::load(folder_.write("small.sdf", kSmallModel));
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto& models = (*scene)->contents().world.models;
  ASSERT_EQ(models.size(), 2U);
  EXPECT_EQ(models[0].name, "floor");
  EXPECT_NEAR(models[1].poseInWorld.translation().z(), 0.05, 1e-9) << "half of its foot's box";
}

TEST_F(SceneTest, modelsAreFoundInTheFoldersThatAreNamed) {
  folder_.write("library/tree/model.sdf", replaced(kSmallModel, "\"small\"", "\"tree\""));
  const auto world =
      folder_.write("world.sdf", worldAround("<include><uri>\n model://tree \n</uri></include>"));
  EXPECT_FALSE(Scene::load(world));
  const auto scene = Scene::load(world, {}, {}, {folder_.path() / "library"});
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ((*scene)->contents().world.models.at(0).name, "tree");
}

TEST_F(SceneTest, aModelThatIncludesItselfIsRefused) {
  folder_.writeModel("small", replaced(kSmallModel, "<link name=\"foot\">",
                                       "<include><uri>model://small</uri></include><link name=\"foot\">"));
  EXPECT_THAT(folder_.errorsOf(worldAround(include(""))), HasSubstr("the model includes itself"));
}

TEST_F(SceneTest, errorsOfAllFilesComeTogether) {
  folder_.writeModel("other", replaced(kSmallModel, "<mass>1.5", "<mass>heavy"));
  folder_.writeModel("small", replaced(kSmallModel, "relative_to=\"foot\"", "relative_to=\"toe\""));
  const std::string errors = folder_.errorsOf(
      worldAround(include("") + "<include><uri>model://other</uri></include>\n<light name='l' type='point'>"
                                "<intensity>1000</intensity></light>"));
  EXPECT_THAT(errors, HasSubstr("models/other/model.sdf:7: small/foot: <mass>"));
  EXPECT_THAT(errors, HasSubstr("models/small/model.sdf:14: small/arm: there is no frame"));
  EXPECT_THAT(errors, HasSubstr("world.sdf:4: test/l: a light's intensity"));
}

TEST_F(SceneTest, whatOnlyResolvingFindsHasItsLineToo) {
  const std::string file = "models/small/model.sdf:";
  EXPECT_THAT(errorsWithModel("relative_to=\"foot\"", "relative_to=\"toe\""), StartsWith(file + "14: "));
  EXPECT_EQ(errorsWithModel("<robotcontrol:color>red", "<robotcontrol:color>gold"),
            file + "11: small/foot/sole: no palette has the color 'gold'");
  EXPECT_THAT(errorsWithModel("<effort>2</effort>", ""),
              StartsWith(file + "19: small/hip: a servo's <effort> must be between 1e-09 and 1000, not "));
  EXPECT_THAT(errorsWithModel("<parent>foot</parent>", "<parent>arm</parent>"), StartsWith(file));
}

TEST_F(SceneTest, aRobotThatStartsInsideAnotherModelCannotBeSimulated) {
  folder_.writeModel("small",
                     replaced(kSmallModel, "<link name=\"foot\">",
                              "<robotcontrol:robot>ers210</robotcontrol:robot><link name=\"foot\">"));
  const auto scene = Scene::load(folder_.write(
      "world.sdf",
      worldAround(include("") + "\n" + include("<name>other</name><pose>0.05 0 0 0 0 0</pose>"))));
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto simulation = Simulation::create(*scene, {});
  ASSERT_FALSE(simulation);
  EXPECT_THAT(simulation.error().describe(), HasSubstr("world.sdf:3: 'small' starts inside 'other'"));
}

TEST_F(SceneTest, otherModelsThatStartInsideEachOtherAreNoted) {
  const auto scene = Scene::load(folder_.write(
      "world.sdf",
      worldAround(include("") + "\n" + include("<name>other</name><pose>0.05 0 0 0 0 0</pose>"))));
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto simulation = Simulation::create(*scene, {});
  ASSERT_TRUE(simulation) << simulation.error().describe();
  ASSERT_FALSE((*simulation)->overlaps().empty());
  EXPECT_EQ((*simulation)->overlaps()[0].what, "'small' starts inside 'other'");
  EXPECT_EQ((*simulation)->overlaps()[0].where.line, 3);
  EXPECT_THAT((*simulation)->modelsTouching("small"), testing::ElementsAre("other"));
}

}  // namespace
}  // namespace simcore
