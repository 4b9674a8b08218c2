// SPDX-License-Identifier: GPL-3.0-or-later
// The Pioneer's gripper: it grips a parcel by friction, and lifts it.
#include <gtest/gtest.h>

#include "tests/simcore/moving/MovingScenes.h"

namespace simcore {
namespace {

constexpr const char* kBlock =
    "<model name='block'><pose>0.275 0 0.05 0 0 0</pose><link "
    "name='block'><inertial><mass>0.3</mass><inertia>"
    "<ixx>0.0004</ixx><iyy>0.0004</iyy><izz>0.0004</izz></inertia></inertial><collision "
    "name='block'><geometry>"
    "<box><size>0.06 0.06 0.1</size></box></geometry></collision></link></model>";

void movePaddles(Simulation& simulation, double position) {
  commandPort(simulation, "p3dxgripper/paddleLeft/request", {position});
  commandPort(simulation, "p3dxgripper/paddleRight/request", {position});
}

double heightOf(const Simulation& simulation, const char* model) {
  return simulation.modelPose(model)->translation().z();
}

TEST(Gripper, gripsABlockAndLiftsItUntilItOpens) {
  const auto simulation = yardWith(including("p3dxgripper") + kBlock);
  runFor(*simulation, 0.2);
  EXPECT_LT(portReading(*simulation, "p3dxgripper/innerBeam"), 0.12) << "the block is in the beam";
  EXPECT_EQ(portReading(*simulation, "p3dxgripper/paddleLeftTouch"), 0);
  movePaddles(*simulation, 0);
  runFor(*simulation, 2);
  EXPECT_EQ(portReading(*simulation, "p3dxgripper/paddleLeftTouch"), 1);
  EXPECT_EQ(portReading(*simulation, "p3dxgripper/paddleRightTouch"), 1);
  EXPECT_NEAR(portReading(*simulation, "p3dxgripper/paddleLeft/position"), 0.03, 0.005);
  commandPort(*simulation, "p3dxgripper/lift/request", {0.08});
  runFor(*simulation, 3);
  EXPECT_NEAR(heightOf(*simulation, "block"), 0.05 + 0.08, 0.012) << "friction holds it";
  const double held = heightOf(*simulation, "block");
  runFor(*simulation, 5);
  EXPECT_NEAR(heightOf(*simulation, "block"), held, 0.01);
  EXPECT_EQ(simulation->read("p3dxgripper/paddleLeft/request").value()[1], 0) << "it has met the block";
  movePaddles(*simulation, 0.1);
  runFor(*simulation, 2);
  EXPECT_LT(heightOf(*simulation, "block"), 0.06) << "it has fallen";
}

TEST(Gripper, beamsSeeNothingWhereNothingIs) {
  const auto simulation = yardWith(including("p3dxgripper"));
  runFor(*simulation, 0.2);
  EXPECT_EQ(portReading(*simulation, "p3dxgripper/innerBeam"), 0.3);
  EXPECT_EQ(portReading(*simulation, "p3dxgripper/outerBeam"), 0.3);
  EXPECT_NEAR(portReading(*simulation, "p3dxgripper/paddleLeft/position"), 0.1, 0.003);
}

}  // namespace
}  // namespace simcore
