// SPDX-License-Identifier: GPL-3.0-or-later
// Acting by hand on what moves, and the forces in a world.
#include <gmock/gmock.h>

#include <cmath>

#include "simcore/Simulation.h"
#include "tests/simcore/SensorScenes.h"

namespace simcore {
namespace {

using robotlink::Vector3;
using testing::ElementsAre;
using testing::HasSubstr;

/// The cart of 4 kg on the ground, and a box of 1 kg in the air.
std::unique_ptr<Simulation> withBox() {
  return cartWith("", "", R"(<model name="box"><pose>0 2 1 0 0 0</pose><link name="body">
      <inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>
      <collision name="c"><geometry><box><size>0.2 0.2 0.2</size></box></geometry></collision></link></model>)");
}

Vector3 centerOf(const Simulation& simulation, const std::string& model) {
  return simulation.modelPose(model)->translation();
}

void advanceBy(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) simulation.step();
}

TEST(SimulationHands, whatIsThrownFliesAParabola) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->throwModel("box", {1, 0, 2}, {0, 0, 3}));
  advanceBy(*simulation, 50);
  const Vector3 place = centerOf(*simulation, "box");
  EXPECT_NEAR(place.x(), 0.2, 1e-6);
  EXPECT_NEAR(place.z(), 1 + 2 * 0.2 - 9.81 / 2 * 0.2 * 0.2, 0.005);
  EXPECT_NEAR(robotlink::groundPose(*simulation->modelPose("box")).heading, 0.6, 1e-4);
}

TEST(SimulationHands, whatIsPinnedHangsInTheAirUntilItIsLetGo) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->pin("box", true));
  EXPECT_THAT(simulation->pinned(), ElementsAre("box/link:body"));
  ASSERT_TRUE(simulation->push("box", {100, 0, 0}, {0, 0, 0}, 1));
  advanceBy(*simulation, 250);
  EXPECT_EQ(centerOf(*simulation, "box"), Vector3(0, 2, 1));
  ASSERT_TRUE(simulation->pin("box/link:body", false));
  EXPECT_TRUE(simulation->pinned().empty());
  advanceBy(*simulation, 250);
  EXPECT_NEAR(centerOf(*simulation, "box").z(), 0.1, 0.002);
}

TEST(SimulationHands, aSpringDragsAPointToItsTarget) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->drag("box", {0, 0, 0.1}, {0.5, 1.5, 1.5}));
  EXPECT_THAT(simulation->dragged(), ElementsAre("box/link:body"));
  advanceBy(*simulation, 1500);
  // It hangs at the spring, stretched by its weight.
  const Vector3 grip = *simulation->modelPose("box") * Vector3(0, 0, 0.1);
  EXPECT_NEAR(grip.x(), 0.5, 0.01);
  EXPECT_NEAR(grip.y(), 1.5, 0.01);
  EXPECT_NEAR(grip.z(), 1.5 - 9.81 / std::pow(2 * robotlink::kPi * 2.5, 2), 0.01);
  simulation->release("");
  EXPECT_TRUE(simulation->dragged().empty());
  advanceBy(*simulation, 250);
  EXPECT_LT(centerOf(*simulation, "box").z(), 0.3);
}

TEST(SimulationHands, aPushAddsItsMomentum) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->push("box", {2, 0, 0}, {0, 0, 0}, 0.1));
  advanceBy(*simulation, 50);
  EXPECT_NEAR((*simulation->readTruth("box/true_velocity"))[0], 2 * 0.1 / 1, 1e-9);
}

TEST(SimulationHands, aModelIsTurnedWhereItStandsUnlessSomethingIsInTheWay) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  ASSERT_TRUE(simulation->turnModel("box", 0.5, 0, 0));
  EXPECT_NEAR(robotlink::groundPose(*simulation->modelPose("box")).heading, 0.5, 1e-9);
  EXPECT_EQ(centerOf(*simulation, "box"), Vector3(0, 2, 1));
  const auto refused = simulation->turnModel("cart", 0, 1.5, 0);
  ASSERT_FALSE(refused) << "it would turn into the ground";
  EXPECT_THAT(refused.error().text, HasSubstr("ground"));
}

TEST(SimulationHands, objectsThatForcesDoNotMoveAreRefused) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  EXPECT_THAT(simulation->throwModel("ground", {1, 0, 0}, {0, 0, 0}).error().text, HasSubstr("fixed"));
  EXPECT_THAT(simulation->pin("bix", true).error().text, HasSubstr("box"));
  EXPECT_THAT(simulation->drag("box/link:bode", {0, 0, 0}, {0, 0, 0}).error().text, HasSubstr("body"));
  const double nan = std::nan("");
  EXPECT_FALSE(simulation->throwModel("box", {nan, 0, 0}, {0, 0, 0}));
  EXPECT_FALSE(simulation->drag("box", {0, 0, 0}, {0, nan, 0}));
  EXPECT_FALSE(simulation->push("box", {1e30, 0, 0}, {0, 0, 0}, 1));
  EXPECT_FALSE(simulation->push("box", {1, 0, 0}, {0, 0, 0}, -1));
}

TEST(SimulationHands, whatAJointHoldsAtTheWorldStaysThere) {
  const auto simulation = cartWith("", "", R"(<model name="pendulum"><pose>0 2 1 0 0 0</pose><link name="bob">
      <inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial></link>
      <joint name="pivot" type="revolute"><parent>world</parent><child>bob</child><axis><xyz>1 0 0</xyz></axis>
      </joint></model>)");
  ASSERT_TRUE(simulation);
  for (const auto& done :
       {simulation->placeModel("pendulum", {3, 3, 0}), simulation->turnModel("pendulum", 1, 0, 0),
        simulation->throwModel("pendulum", {0, 1, 0}, {0, 0, 0})}) {
    ASSERT_FALSE(done.has_value());
    EXPECT_EQ(done.error().text, "'pendulum' is fixed to the world");
  }
  EXPECT_EQ(centerOf(*simulation, "pendulum"), Vector3(0, 2, 1));
  EXPECT_TRUE(simulation->push("pendulum", {0, 1, 0}, {0, 0, 0}, 1).has_value()) << "it can swing";
}

TEST(SimulationHands, contactForcesCarryTheWeight) {
  const auto simulation = withBox();
  ASSERT_TRUE(simulation);
  advanceBy(*simulation, 250);
  EXPECT_TRUE(simulation->forces().contacts.empty()) << "nobody reads them";
  simulation->readForces(true);
  advanceBy(*simulation, 1);
  Vector3 onCart = Vector3::Zero(), onBox = Vector3::Zero();
  for (const ContactForce& contact : simulation->forces().contacts) {
    const bool isFirst = contact.second == "ground";
    const std::string& moved = isFirst ? contact.first : contact.second;
    const Vector3 force = isFirst ? contact.force : Vector3(-contact.force);
    EXPECT_NEAR(contact.normal.norm(), 1, 1e-9);
    EXPECT_GE(contact.force.dot(contact.normal), -1e-9) << "contacts do not pull";
    EXPECT_NEAR(contact.point.z(), 0, 0.01);
    if (moved == "cart/link:base") onCart += force;
    if (moved == "box/link:body") onBox += force;
  }
  EXPECT_NEAR(onCart.z(), 4 * 9.81, 0.5);
  EXPECT_NEAR(onBox.z(), 1 * 9.81, 0.2);
}

TEST(SimulationHands, forcesOfHandsAndJointsAreShown) {
  const auto simulation = cartWith("", R"(<link name="arm"><pose>0 0 0.5 0 0 0</pose>
      <inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial></link>
    <joint name="rail" type="prismatic"><parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz>
      <limit><lower>-0.1</lower><upper>0.1</upper><effort>50</effort><velocity>1</velocity></limit></axis>
      <robotcontrol:servo/></joint>)");
  ASSERT_TRUE(simulation);
  advanceBy(*simulation, 100);
  ASSERT_TRUE(simulation->push("cart", {1, 2, 3}, {0.1, 0, 0}, 0.1));
  advanceBy(*simulation, 1);
  const Forces forces = simulation->forces();
  ASSERT_EQ(forces.joints.size(), 1U);
  EXPECT_EQ(forces.joints[0].joint, "cart/joint:rail");
  EXPECT_NEAR(forces.joints[0].force.z(), 0.2 * 9.81, 0.3) << "it carries the arm";
  ASSERT_EQ(forces.hands.size(), 1U);
  EXPECT_EQ(forces.hands[0].link, "cart/link:base");
  EXPECT_EQ(forces.hands[0].force, Vector3(1, 2, 3));
}

}  // namespace
}  // namespace simcore
