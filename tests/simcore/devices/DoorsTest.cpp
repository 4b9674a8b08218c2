// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Doors.h"

#include <gmock/gmock.h>

#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

using testing::HasSubstr;

constexpr int kSecond = 250;  // steps

const std::string kLidar = R"(<sensor name="eye" type="lidar"><pose>0 0 0.5 0 0 0</pose>
    <lidar><scan><horizontal><samples>1</samples><min_angle>0</min_angle><max_angle>0</max_angle></horizontal></scan>
    <range><min>0.05</min><max>5</max></range></lidar></sensor>)";

/// A gate at (0, 3) whose leaf slides or turns, and whose frame has a sensor that looks along x.
std::string gate(const std::string& sensor, const std::string& door, const std::string& type = "prismatic",
                 const std::string& servo = "<robotcontrol:servo/>") {
  return R"(<model name="gate"><pose>0 3 0 0 0 0</pose>
    <link name="frame"><inertial><mass>5</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>
      <collision name="plate"><pose>0.5 0 0.03 0 0 0</pose><geometry><box><size>0.4 0.4 0.02</size></box></geometry></collision>)" +
         sensor + R"(</link>
    <joint name="ground" type="fixed"><parent>world</parent><child>frame</child></joint>
    <link name="leaf"><pose>0 1 1 0 0 0</pose><inertial><mass>2</mass><inertia><ixx>0.5</ixx><iyy>0.5</iyy><izz>0.5</izz></inertia></inertial>
      <collision name="leaf"><geometry><box><size>0.05 0.9 1.9</size></box></geometry></collision></link>
    <joint name="rail" type=")" +
         type + R"("><parent>frame</parent><child>leaf</child><axis><xyz>0 0 1</xyz>
      <limit><lower>0</lower><upper>1.2</upper><effort>200</effort><velocity>2</velocity></limit></axis>)" +
         servo + door + "</joint></model>";
}

const std::string kDoor = R"(<robotcontrol:door sensor="eye"><robotcontrol:below>2</robotcontrol:below>
    <robotcontrol:open>1</robotcontrol:open><robotcontrol:seconds>1</robotcontrol:seconds></robotcontrol:door>)";

void pass(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

double leafOf(const Simulation& simulation) {
  return simulation.readTruth("gate/rail/position").value_or(std::vector<double>{-1}).front();
}

/// The errors of a scene with a gate.
std::string errorsOf(const std::string& model) {
  const SceneFolder folder;
  const auto scene = Scene::load(folder.write("gate.sdf", worldAround(model)));
  return scene ? "" : robotlink::describe(scene.error());
}

TEST(DoorsTest, aDoorOpensForWhatIsNearAndClosesAfterItsTime) {
  for (const char* type : {"prismatic", "revolute"}) {
    const auto simulation = cartWith("", "", gate(kLidar, kDoor, type));
    ASSERT_TRUE(simulation);
    pass(*simulation, kSecond);
    EXPECT_NEAR(leafOf(*simulation), 0, 0.01) << type << ": nobody is near";
    EXPECT_FALSE(simulation->isDoorOpen(0));
    ASSERT_TRUE(simulation->placeModel("cart", {3, 3, 0}, ModelPosture{.height = 0.5}));
    pass(*simulation, kSecond / 5);
    EXPECT_FALSE(simulation->isDoorOpen(0)) << "still too far away";
    // The sensor is 0.5 m above the ground, where the falling cart is for a moment.
    ASSERT_TRUE(simulation->placeModel("cart", {1.5, 3, 0}, ModelPosture{.height = 0.5}));
    pass(*simulation, static_cast<int>(Doors::kLookSteps));
    EXPECT_TRUE(simulation->isDoorOpen(0)) << type;
    ASSERT_TRUE(simulation->placeModel("cart", {-5, 0, 0}, ModelPosture{.height = 0.05}));
    pass(*simulation, kSecond - static_cast<int>(Doors::kLookSteps) - 2);
    EXPECT_TRUE(simulation->isDoorOpen(0));
    EXPECT_NEAR(leafOf(*simulation), 1, 0.02) << type;
    pass(*simulation, 2 * static_cast<int>(Doors::kLookSteps));
    EXPECT_FALSE(simulation->isDoorOpen(0)) << type << ": after a second";
    pass(*simulation, kSecond);
    EXPECT_NEAR(leafOf(*simulation), 0, 0.01) << type;
  }
}

TEST(DoorsTest, aDoorStaysOpenWhileSomebodyIsThere) {
  const auto simulation =
      cartWith("", "", gate(kLidar, kDoor) + solidAt("pillar", "1.2 3 0.5 0 0 0", "0.2 0.2 1"));
  ASSERT_TRUE(simulation);
  pass(*simulation, 3 * kSecond);
  EXPECT_TRUE(simulation->isDoorOpen(0));
  simulation->moveDoor(0, false);
  EXPECT_FALSE(simulation->isDoorOpen(0));
  pass(*simulation, static_cast<int>(Doors::kLookSteps));
  EXPECT_TRUE(simulation->isDoorOpen(0)) << "it opens again";
}

TEST(DoorsTest, sonarsAndPlatesOpenDoors) {
  const std::string sonar = R"(<sensor name="eye" type="sonar"><pose>0 0 0.5 0 0 0</pose>
      <sonar><min>0.05</min><max>4</max><radius>0.5</radius></sonar></sensor>)";
  const std::string plate =
      R"(<sensor name="eye" type="contact"><contact><collision>plate</collision></contact></sensor>)";
  for (const auto& [sensor, height] : {std::pair{sonar, 0.5}, std::pair{plate, 0.092}}) {
    const auto simulation = cartWith("", "", gate(sensor, kDoor));
    ASSERT_TRUE(simulation);
    pass(*simulation, kSecond / 2);
    EXPECT_FALSE(simulation->isDoorOpen(0)) << sensor;
    ASSERT_TRUE(simulation->placeModel("cart", {0.6, 3, 0}, ModelPosture{.height = height})) << sensor;
    pass(*simulation, kSecond / 5);
    EXPECT_TRUE(simulation->isDoorOpen(0)) << sensor;
  }
}

TEST(DoorsTest, commandsOpenAndCloseADoorThatHasNoSensor) {
  const auto simulation = cartWith(
      "", "", gate("", "<robotcontrol:door><robotcontrol:open>1</robotcontrol:open></robotcontrol:door>"));
  ASSERT_TRUE(simulation);
  ASSERT_EQ(simulation->doors().size(), 1U);
  EXPECT_EQ(simulation->doors()[0].info.path, "gate/rail/door");
  ASSERT_TRUE(simulation->write("gate/rail/door", std::vector<double>{1}));
  pass(*simulation, 2 * kSecond);
  EXPECT_NEAR(leafOf(*simulation), 1, 0.02);
  ASSERT_TRUE(simulation->write("gate/rail/door", std::vector<double>{0}));
  pass(*simulation, 2 * kSecond);
  EXPECT_NEAR(leafOf(*simulation), 0, 0.01);
  ASSERT_TRUE(simulation->write("gate/rail/door", std::vector<double>{1}));
  pass(*simulation, 5 * kSecond);
  EXPECT_NEAR(leafOf(*simulation), 0, 0.01) << "it closes after 3 s, without a command";
  simulation->moveDoor(0, true);
  simulation->reset(1);
  EXPECT_FALSE(simulation->isDoorOpen(0));
}

TEST(DoorsTest, anObstacleHoldsALeafThatIsWeak) {
  const auto simulation =
      cartWith("", "",
               gate("", "<robotcontrol:door><robotcontrol:open>1</robotcontrol:open></robotcontrol:door>") +
                   solidAt("beam", "0 4 2.3 0 0 0", "1 1 0.1"));
  ASSERT_TRUE(simulation);
  simulation->moveDoor(0, true);
  pass(*simulation, 2 * kSecond);
  EXPECT_NEAR(leafOf(*simulation), 0.3, 0.03);
  const auto state = simulation->read("gate/rail/door");
  ASSERT_TRUE(state);
  EXPECT_EQ(state->front(), 0) << "it is not where it shall be";
}

TEST(DoorsTest, aDoorThatCannotWorkIsAnErrorWithItsPlace) {
  EXPECT_EQ(errorsOf(gate(kLidar, kDoor)), "");
  EXPECT_THAT(errorsOf(gate("", kDoor)), HasSubstr("the model has no sensor 'eye'"));
  EXPECT_THAT(errorsOf(gate("", kDoor)), HasSubstr("gate.sdf:"));
  EXPECT_THAT(errorsOf(gate(kLidar, kDoor, "prismatic", "")), HasSubstr("needs a <robotcontrol:servo>"));
  const auto with = [&](const char* inDoor) {
    return errorsOf(
        gate(kLidar, "<robotcontrol:door sensor='eye'>" + std::string(inDoor) + "</robotcontrol:door>"));
  };
  EXPECT_THAT(with("<robotcontrol:below>1</robotcontrol:below>"), HasSubstr("needs <robotcontrol:open>"));
  EXPECT_THAT(with("<robotcontrol:open>1</robotcontrol:open>"), HasSubstr("needs <robotcontrol:below>"));
  EXPECT_THAT(with("<robotcontrol:open>7</robotcontrol:open><robotcontrol:below>1</robotcontrol:below>"),
              HasSubstr("open"));
  EXPECT_THAT(with("<robotcontrol:open>1</robotcontrol:open><robotcontrol:ajar>1</robotcontrol:ajar>"),
              HasSubstr("there is no <robotcontrol:ajar>"));
}

TEST(DoorsTest, anOpenDoorStaysOpenWhereTheSceneIsEdited) {
  const std::string door =
      gate("", "<robotcontrol:door><robotcontrol:open>1</robotcontrol:open></robotcontrol:door>");
  const auto simulation = cartWith("", "", door);
  ASSERT_TRUE(simulation);
  simulation->moveDoor(0, true);
  pass(*simulation, 2 * kSecond);
  const SceneFolder folder;
  const auto edited =
      Scene::load(folder.write("edited.sdf", worldAround(door + solidAt("box", "5 5 5 0 0 0", "1 1 1"))));
  ASSERT_TRUE(edited);
  ASSERT_TRUE(simulation->continueIn(*edited));
  EXPECT_TRUE(simulation->isDoorOpen(0));
  pass(*simulation, kSecond / 2);
  EXPECT_NEAR(leafOf(*simulation), 1, 0.02);
  pass(*simulation, 3 * kSecond);
  EXPECT_NEAR(leafOf(*simulation), 0, 0.01) << "it closes after its time";
}

TEST(DoorsTest, doorsMoveAlikeWithTheSameSeed) {
  std::uint64_t digests[2] = {};
  for (std::uint64_t& digest : digests) {
    const auto simulation =
        cartWith("", "", gate(kLidar, kDoor) + solidAt("pillar", "1.2 3 0.5 0 0 0", "0.2 0.2 1"));
    ASSERT_TRUE(simulation);
    pass(*simulation, kSecond);
    digest = simulation->digest();
  }
  EXPECT_EQ(digests[0], digests[1]);
}

}  // namespace
}  // namespace simcore
