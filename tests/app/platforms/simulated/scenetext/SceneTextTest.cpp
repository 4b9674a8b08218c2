// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/scenetext/SceneText.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "robotlink/base/AtomicFile.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string kBox =
    "<sdf version=\"1.9\">\n<model name=\"box\">\n<static>true</static>\n<link name=\"box\">\n"
    "<collision name=\"c\"><geometry><box><size>1 1 1</size></box></geometry></collision>\n"
    "</link>\n</model>\n</sdf>\n";

std::string world(const std::string& contents) {
  return "<sdf version=\"1.9\">\n<world name=\"w\">\n" + contents + "\n</world>\n</sdf>\n";
}

std::string found(const std::vector<SceneTextFinding>& findings) {
  std::string text;
  for (const auto& one : findings) text += (one.isWarning ? "warning " : "") + one.error.describe() + "\n";
  return text;
}

class SceneTextTest : public testing::Test {
 protected:
  std::string check(const std::string& text, const std::string& name = "room.sdf") {
    return found(checkSceneText(text, folder_.path() / name));
  }
  const TestFolder folder_;
};

TEST_F(SceneTextTest, aTextNeedNotBeSavedToBeChecked) {
  EXPECT_EQ(check(world("")), "");
  const std::string wrong = check(world("<gravity>0 0</gravity>"));
  EXPECT_THAT(wrong, HasSubstr((folder_.path() / "room.sdf").string() + ":3"));
  EXPECT_THAT(wrong, HasSubstr("<gravity>"));
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "room.sdf"));
}

TEST_F(SceneTextTest, modelsBesideTheFileAreFoundAndTheirErrorsNameThem) {
  folder_.write("models/box/model.sdf", kBox);
  folder_.write("other/model.sdf", kBox);
  EXPECT_EQ(check(world("<include><uri>model://box</uri></include>"
                        "<include><uri>other</uri><name>b</name><pose>3 0 0 0 0 0</pose></include>")),
            "");
  folder_.write("models/box/model.sdf",
                "<sdf version=\"1.9\">\n<model name=\"box\">\n<lnk/>\n</model></sdf>");
  EXPECT_THAT(check(world("<include><uri>model://box</uri></include>")),
              HasSubstr("models/box/model.sdf:2: box: the model 'box' has no <link>"));
}

TEST_F(SceneTextTest, aModelAloneIsChecked) {
  EXPECT_EQ(check(kBox, "model.sdf"), "");
  std::string wrong = kBox;
  wrong.replace(wrong.find("<size>1 1 1"), 11, "<size>1 1");
  const std::string text = check(wrong, "model.sdf");
  EXPECT_THAT(text, HasSubstr((folder_.path() / "model.sdf").string() + ":5"));
  EXPECT_THAT(text, Not(HasSubstr("robotcontrol-scene")));
}

TEST_F(SceneTextTest, modelsThatStartInsideEachOtherAreAnError) {
  folder_.write("box/model.sdf", kBox);
  EXPECT_THAT(check(world("<include><uri>model://burger</uri></include>\n"
                          "<include><uri>model://box</uri></include>")),
              HasSubstr("starts inside"));
}

TEST_F(SceneTextTest, whatIsForOtherSimulatorsIsAWarning) {
  EXPECT_THAT(check(world("<!-- <plugin/> -->\n<plugin name=\"p\" filename=\"f\"/>")),
              HasSubstr("warning " + (folder_.path() / "room.sdf").string() + ":4"));
}

TEST_F(SceneTextTest, aTextThatIsNoXmlAndAMapAreChecked) {
  EXPECT_THAT(check("<sdf"), HasSubstr("XML"));
  EXPECT_THAT(check(""), HasSubstr("empty"));
  EXPECT_THAT(check("nonsense", "house.map"), HasSubstr("house.map"));
}

TEST_F(SceneTextTest, theModelsOfAFileAreThoseBesideItAndTheShippedOnes) {
  folder_.write("models/box/model.sdf", kBox);
  const auto models = sceneModels(folder_.path() / "room.sdf");
  const auto box = std::ranges::find(models, "box", &SceneModelFile::name);
  ASSERT_NE(box, models.end());
  EXPECT_FALSE(box->isRobot);
  const auto robot = std::ranges::find(models, "p3at", &SceneModelFile::name);
  ASSERT_NE(robot, models.end());
  EXPECT_TRUE(robot->isRobot);
  EXPECT_EQ(sceneModelFile("model://box", folder_.path() / "room.sdf"), box->file);
  EXPECT_EQ(sceneModelFile("model://p3at", folder_.path() / "room.sdf"), robot->file);
  EXPECT_FALSE(sceneModelFile("model://nothing", folder_.path() / "room.sdf").has_value());
}

TEST_F(SceneTextTest, aNewRoomHasNoErrorsWhateverRobotIsInIt) {
  const auto file = folder_.path() / "room.sdf";
  for (const auto& model : sceneModels(file)) {
    if (!model.isRobot) continue;
    const auto text = newRoomText({.name = "hall", .doorway = true, .robot = model.name}, file);
    ASSERT_TRUE(text.has_value()) << model.name << ": " << text.error().describe();
    EXPECT_EQ(check(*text), "") << model.name;
    EXPECT_THAT(*text, HasSubstr("model://" + model.name));
    EXPECT_EQ(text->find('@'), std::string::npos);
  }
  const auto empty = newRoomText({}, file);
  ASSERT_TRUE(empty.has_value());
  EXPECT_EQ(check(*empty), "");
}

TEST_F(SceneTextTest, newObjectsOfAllKindsStandInARoomWithoutErrors) {
  const auto file = folder_.path() / "room.sdf";
  const std::string room = newRoomText({}, file).value_or("");
  for (const char* kind : {"box", "ball", "cylinder", "wall", "lamp", "camera", "burger", "sliding_door"}) {
    const auto object = newObjectText(kind, "thing", 1, -1, file);
    ASSERT_TRUE(object.has_value()) << kind << ": " << object.error().describe();
    EXPECT_EQ(object->find('@'), std::string::npos) << kind;
    std::string text = room;
    text.insert(text.find("  </world>"), *object);
    EXPECT_EQ(check(text), "") << kind;
  }
  EXPECT_FALSE(newObjectText("unicorn", "u", 0, 0, file).has_value());
  EXPECT_FALSE(newObjectText("box", "b", 1e9, 0, file).has_value());
}

TEST_F(SceneTextTest, aDoorInTheDoorwayIsShutAlsoIfItIsSomeCentimetersBeside) {
  const auto file = folder_.path() / "room.sdf";
  for (const double y : {-0.04, 0.0, 0.04}) {
    std::string text = newRoomText({.doorway = true}, file).value_or("");
    text.insert(text.find("  </world>"), newObjectText("sliding_door", "door", 0, y, file).value_or(""));
    const auto scene = simcore::Scene::load(folder_.write("room.sdf", text));
    ASSERT_TRUE(scene.has_value()) << robotlink::describe(scene.error());
    const auto simulation = simcore::Simulation::create(*scene, {});
    ASSERT_TRUE(simulation.has_value());
    for (int i = 0; i < 250; ++i) (*simulation)->step();
    ASSERT_EQ((*simulation)->doors().size(), 1U);
    EXPECT_FALSE((*simulation)->isDoorOpen(0)) << y;
  }
}

TEST_F(SceneTextTest, whatIsLeftOutOfTheTextIsAWarningThatSaysWhatThatMeans) {
  const std::string told =
      check(world("<physics type='ode'><max_step_size>0.001</max_step_size></physics>\n"
                  "<audio><device>default</device></audio>"));
  EXPECT_THAT(told, HasSubstr("warning"));
  EXPECT_THAT(told, HasSubstr("room.sdf:4"));
}

TEST_F(SceneTextTest, aRoomThatMakesNoSenseIsRefused) {
  const auto file = folder_.path() / "room.sdf";
  EXPECT_FALSE(newRoomText({.name = "a b"}, file).has_value());
  EXPECT_FALSE(newRoomText({.width = 0.5}, file).has_value());
  EXPECT_FALSE(newRoomText({.robot = "nobody"}, file).has_value());
}

}  // namespace
}  // namespace app
