// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfReader.h"

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfSpec.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SdfReader : public testing::Test {
 protected:
  static const SdfSpec& spec() { return SdfSpec::shared(); }
  std::shared_ptr<const ModelDescription> model(const std::string& text) {
    const std::filesystem::path file = folder_.write("m.sdf", text);
    const SceneFiles files(file, {}, {}, spec(), errors_);
    MeshFiles meshes;
    std::shared_ptr<const ModelDescription> result;
    if (const auto* element = files.model(file))
      result = readSdfModel(*element, "m.sdf", {files, spec(), meshes, errors_, leftOut_});
    for (robotlink::Error& error : errors_) error.where.file = "m.sdf";
    return result;
  }
  WorldDescription world(const std::string& contents) {
    const SceneFiles files(folder_.write("w.sdf", worldAround(contents)), {}, {}, spec(), errors_);
    MeshFiles meshes;
    bool includesRead = false;
    return readSdfWorld({files, spec(), meshes, errors_, leftOut_}, includesRead);
  }
  /// Two more links and joints behind those of the small model.
  static std::string withJoints(const std::string& joints) {
    return replaced(
        kSmallModel, "</link>\n    <joint",
        "</link>\n    <link name=\"hand\"><inertial><mass>0.1</mass></inertial></link>" + joints + "<joint");
  }
  static std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                           const std::string& type = "fixed", const std::string& axis = "") {
    return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent>" + parent + "</parent><child>" +
           child + "</child>" + axis + "</joint>";
  }
  std::vector<std::string> namesOfJoints(const ModelDescription& model) const {
    std::vector<std::string> names;
    for (const auto& one : model.joints) names.push_back(one.name);
    return names;
  }
  std::string errors() const { return describe(errors_); }

  const SceneFolder folder_;
  robotlink::Errors errors_;
  LeftOuts leftOut_;
};

TEST_F(SdfReader, aModelHasItsLinksSolidsAndColors) {
  const auto small = model(kSmallModel);
  ASSERT_TRUE(small) << errors();
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(small->name, "small");
  EXPECT_EQ(small->file, "m.sdf");
  EXPECT_FALSE(small->isStatic);
  EXPECT_FALSE(small->isBall);
  ASSERT_EQ(small->links.size(), 2U);
  EXPECT_EQ(small->links[0].mass, 1.5);
  EXPECT_TRUE(small->links[0].collisions.at(0).shape.size.isApprox(Vector3(0.1, 0.1, 0.1)));
  EXPECT_EQ(small->links[0].visuals.at(0).color, (Rgb{200, 0, 0}));
  EXPECT_EQ(small->links[0].visuals.at(0).colorName, "red");
  EXPECT_NEAR(small->links[1].poseInModel.translation().z(), 0.1, 1e-12);
  ASSERT_EQ(small->sensors.size(), 1U);
  EXPECT_EQ(small->sensors[0].kind, SensorDescription::Kind::kContact);
  EXPECT_EQ(small->sensors[0].link, 1);
}

TEST_F(SdfReader, aHingeHasItsAxisItsLimitsAndItsServo) {
  const auto small = model(kSmallModel);
  ASSERT_TRUE(small) << errors();
  ASSERT_EQ(small->joints.size(), 1U);
  const JointDescription& hip = small->joints[0];
  EXPECT_EQ(hip.kind, JointDescription::Kind::kHinge);
  EXPECT_EQ(hip.parent, 0);
  EXPECT_EQ(hip.child, 1);
  EXPECT_TRUE(hip.axisInModel.isApprox(Vector3::UnitZ()));
  EXPECT_NEAR(hip.anchorInModel.z(), 0.1, 1e-12) << "a joint is where its child is";
  EXPECT_EQ(hip.lower, -1);
  EXPECT_EQ(hip.upper, 1);
  EXPECT_TRUE(hip.servo);
  EXPECT_EQ(hip.maximumSpeed, 3);
  EXPECT_EQ(hip.maximumTorque, 2);
  EXPECT_EQ(hip.initialAngle, 0.5);
}

TEST_F(SdfReader, anAxisIsTurnedIntoTheModelsFrameAndHasLengthOne) {
  const auto turned = model(replaced(replaced(kSmallModel, "0 0 0.1 0 0 0", "0 0 0.1 0 1.5707963267948966 0"),
                                     "0 0 1</xyz>", "0 0 5</xyz>"));
  ASSERT_TRUE(turned) << errors();
  EXPECT_TRUE(turned->joints.at(0).axisInModel.isApprox(Vector3::UnitX(), 1e-9));
}

TEST_F(SdfReader, jointsWithoutLimitsTurnByAFullTurn) {
  const std::string axis = "<axis><xyz>0 1 0</xyz></axis>";
  const auto turning = model(withJoints(joint("wheel", "foot", "hand", "continuous", axis)));
  ASSERT_TRUE(turning) << errors();
  EXPECT_EQ(errors(), "");
  const auto& wheel = turning->joints.at(0).name == "wheel" ? turning->joints[0] : turning->joints.at(1);
  EXPECT_NEAR(wheel.lower, -2 * robotlink::kPi, 1e-12);
  EXPECT_NEAR(wheel.upper, 2 * robotlink::kPi, 1e-12);
  EXPECT_FALSE(wheel.servo);
}

TEST_F(SdfReader, jointsOfParentsComeFirst) {
  const auto chain = model(withJoints(joint("wrist", "arm", "hand")));
  ASSERT_TRUE(chain) << errors();
  EXPECT_EQ(errors(), "");
  EXPECT_THAT(namesOfJoints(*chain), ElementsAre("hip", "wrist"));
  EXPECT_EQ(chain->joints[1].kind, JointDescription::Kind::kFixed);
}

TEST_F(SdfReader, aJointMayHoldALinkInTheWorld) {
  const auto held = model(withJoints(joint("nail", "world", "hand")));
  ASSERT_TRUE(held) << errors();
  EXPECT_EQ(errors(), "");
  EXPECT_EQ(held->joints.at(0).parent, -1);
}

TEST_F(SdfReader, jointsThatCloseACycleComeLast) {
  const auto cycle = model(withJoints(joint("wrist", "arm", "hand") + joint("back", "hand", "foot")));
  ASSERT_TRUE(cycle) << errors();
  ASSERT_EQ(cycle->joints.size(), 3U);
  EXPECT_TRUE(cycle->joints[2].closesCycle);
  EXPECT_FALSE(cycle->joints[0].closesCycle);
}

TEST_F(SdfReader, jointsKeepTheirOrderButForTheirParents) {
  std::string links, joints;
  for (int i = 0; i < 5; ++i) links += "<link name=\"l" + std::to_string(i) + "\"/>";
  // l0 and l1 hang on each other; l4 hangs on l3, and this on l2.
  joints = joint("c", "l3", "l4") + joint("x", "l1", "l0") + joint("y", "l0", "l1") + joint("b", "l2", "l3") +
           joint("a", "foot", "l2");
  const auto ordered = model(replaced(kSmallModel, "<joint", links + joints + "<joint"));
  ASSERT_TRUE(ordered) << errors();
  EXPECT_THAT(namesOfJoints(*ordered), ElementsAre("a", "b", "c", "hip", "y", "x"));
}

TEST_F(SdfReader, aServoClosesNoCycle) {
  model(withJoints(joint("other", "hand", "arm")));
  EXPECT_THAT(errors(), HasSubstr("closes a cycle or gives a link a second parent, so it can have no servo"));
}

TEST_F(SdfReader, aServoNeedsLimitsOfSpeedAndTorque) {
  model(replaced(kSmallModel, "<velocity>3</velocity>", ""));
  EXPECT_THAT(errors(),
              HasSubstr("m.sdf:19: small/hip: a servo's <velocity> must be between 1e-06 and 1000"));
  errors_.clear();
  model(replaced(kSmallModel, "<effort>2</effort>", "<effort>0</effort>"));
  EXPECT_THAT(errors(), HasSubstr("a servo's <effort> must be between 1e-09 and 1000"));
}

TEST_F(SdfReader, aServoBeginsWithinItsLimits) {
  model(replaced(kSmallModel, "_position>0.5<", "_position>1.5<"));
  EXPECT_EQ(errors(), "");
  ASSERT_EQ(leftOut_.size(), 1U);
  EXPECT_EQ(leftOut_[0].what, "<robotcontrol:initial_position>");
  EXPECT_EQ(leftOut_[0].why, "initial_position must be between -1 and 1, not 1.5");
}

TEST_F(SdfReader, limitsStandInTheirOrder) {
  model(replaced(kSmallModel, "<upper>1<", "<upper>-2<"));
  EXPECT_THAT(errors(), HasSubstr("upper must be between -1 and"));
}

TEST_F(SdfReader, homesHaveATeamAndAHeadingWithinATurn) {
  const auto field = model(replaced(kSmallModel, "<link name=\"foot\">",
                                    "<robotcontrol:home team=\"red\">-1.5 0.5 7</robotcontrol:home>"
                                    "<robotcontrol:home>1 2 0</robotcontrol:home><link name=\"foot\">"));
  ASSERT_TRUE(field) << errors();
  EXPECT_EQ(errors(), "");
  ASSERT_EQ(field->homes.size(), 2U);
  EXPECT_EQ(field->homes[0].team, "red");
  EXPECT_EQ(field->homes[0].place.x, -1.5);
  EXPECT_EQ(field->homes[0].place.y, 0.5);
  EXPECT_NEAR(field->homes[0].place.heading, 7 - 2 * robotlink::kPi, 1e-12);
  EXPECT_EQ(field->homes[1].team, "");
}

TEST_F(SdfReader, aHomeOutOfRangeIsLeftOut) {
  const auto field = model(replaced(kSmallModel, "<link name=\"foot\">",
                                    "<robotcontrol:home>1 2000 0</robotcontrol:home>"
                                    "<robotcontrol:home>1 2 0</robotcontrol:home><link name=\"foot\">"));
  ASSERT_TRUE(field) << errors();
  EXPECT_EQ(errors(), "");
  ASSERT_EQ(field->homes.size(), 1U);
  EXPECT_EQ(field->homes[0].place.y, 2);
  ASSERT_EQ(leftOut_.size(), 1U);
  EXPECT_EQ(leftOut_[0].what, "<robotcontrol:home>");
  EXPECT_THAT(leftOut_[0].why, HasSubstr("between -1000 and 1000"));
}

TEST_F(SdfReader, aWorldHasItsSurroundings) {
  const WorldDescription dark = world(
      "<gravity>0 0 -1.6</gravity><scene><ambient>0.25 0.25 0.25 1</ambient>"
      "<background>1 0.5 0 1</background><shadows>true</shadows></scene>"
      "<light name=\"lamp\" type=\"point\"><pose>1 2 3 0 0 0</pose><intensity>2</intensity>"
      "<attenuation><range>10</range><quadratic>0.5</quadratic></attenuation></light>");
  EXPECT_EQ(errors(), "");
  EXPECT_NEAR(dark.gravity.z(), -1.6, 1e-12);
  EXPECT_FLOAT_EQ(dark.ambient, 0.25F);
  EXPECT_EQ(dark.background, (Rgb{255, 128, 0}));
  ASSERT_EQ(dark.lamps.size(), 1U);
  EXPECT_FLOAT_EQ(dark.lamps[0].position.y(), 2.F);
  EXPECT_FLOAT_EQ(dark.lamps[0].intensity, 2.F);
  EXPECT_FLOAT_EQ(dark.lamps[0].attenuation, 0.5F);
}

TEST_F(SdfReader, lampsAreWithinLimits) {
  world("<light name=\"lamp\" type=\"point\"><intensity>1000</intensity></light>");
  EXPECT_THAT(errors(), HasSubstr("a light's intensity must be between 0 and 100"));
}

TEST_F(SdfReader, gravityHasALimit) {
  world("<gravity>0 0 -1001</gravity>");
  EXPECT_THAT(errors(), HasSubstr("gravity must be below 1000 m/s^2"));
}

TEST_F(SdfReader, momentsOfInertiaHaveALimit) {
  model(replaced(kSmallModel, "<iyz>0<", "<iyz>1e300<"));
  EXPECT_THAT(errors(), HasSubstr("m.sdf:6: small/foot"));
  EXPECT_THAT(errors(), HasSubstr("the moments of inertia of 'foot' must be at most 1e12 kg m^2"));
}

TEST_F(SdfReader, aModelInTheWorldHasItsPlaceAndItsLine) {
  const WorldDescription placed =
      world("\n<model name=\"post\"><static>true</static><pose>1 2 0 0 0 0</pose><link name=\"l\"/></model>");
  EXPECT_EQ(errors(), "");
  ASSERT_EQ(placed.models.size(), 1U);
  EXPECT_EQ(placed.models[0].name, "post");
  EXPECT_TRUE(placed.models[0].type->isStatic);
  EXPECT_NEAR(placed.models[0].poseInWorld.translation().y(), 2, 1e-12);
  EXPECT_THAT(placed.models[0].where.file, testing::EndsWith("w.sdf"));
  EXPECT_GT(placed.models[0].where.line, 1);
}

TEST_F(SdfReader, aModelInTheWorldMayBeTurnedByAQuaternionOrDegrees) {
  const auto turned = [&](const std::string& attribute, const std::string& numbers) {
    const WorldDescription placed =
        world("<model name='m'><pose " + attribute + ">" + numbers + "</pose><link name='l'/></model>");
    EXPECT_EQ(errors(), "");
    return Vector3(placed.models.at(0).poseInWorld.linear() * Vector3::UnitX());
  };
  EXPECT_TRUE(turned("rotation_format='quat_xyzw'", "0 0 1 0 0 1 1").isApprox(Vector3::UnitY(), 1e-12));
  EXPECT_TRUE(turned("degrees='true'", "0 0 1 0 0 90").isApprox(Vector3::UnitY(), 1e-12));
}

TEST_F(SdfReader, whatLibsdformatAssertsIsAnErrorWithItsLine) {
  const SceneFolder folder;
  // Not checked before, as SceneFiles does.
  tinyxml2::XMLDocument document;
  document.Parse("<model name='m'>\n<pose rotation_format='x'>0 0 0 0 0 0</pose><link name='l'/></model>");
  const SceneFiles files(folder.write("w.sdf", worldAround("")), {}, {}, spec(), errors_);
  MeshFiles meshes;
  EXPECT_EQ(readSdfModel(*document.RootElement(), "m.sdf", {files, spec(), meshes, errors_, leftOut_}),
            nullptr);
  EXPECT_EQ(errors(), "m.sdf:2: m: libsdformat cannot read this <pose>");
}

TEST_F(SdfReader, afterAHundredErrorsOnlyTheirNumberFollows) {
  std::string frames;
  for (int i = 0; i < 130; ++i)
    frames += "\n<link name='l" + std::to_string(i) + "'><pose relative_to='nowhere::at'/></link>";
  model(replaced(kSmallModel, "<link name=\"foot\">", frames + "<link name=\"foot\">"));
  EXPECT_EQ(errors_.size(), 101U) << errors();
  EXPECT_THAT(errors_.back().text, testing::ContainsRegex("there are [1-9][0-9]+ more errors"));
}

TEST_F(SdfReader, aPoseIsARollThenAPitchThenAYaw) {
  const Pose3 pose = poseFromNumbers({1, 2, 3, 0, 0, robotlink::kPi / 2});
  EXPECT_TRUE(pose.translation().isApprox(Vector3(1, 2, 3)));
  EXPECT_TRUE((pose.linear() * Vector3::UnitX()).isApprox(Vector3::UnitY(), 1e-12));
}

}  // namespace
}  // namespace simcore
