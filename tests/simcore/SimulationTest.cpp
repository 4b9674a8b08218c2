// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Simulation.h"

#include <gmock/gmock.h>

#include "simcore/Scene.h"

namespace simcore {
namespace {

TEST(Simulation, aRobotStandsForTenSeconds) {
  const auto scene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf");
  ASSERT_TRUE(scene) << describe(scene.error());
  auto sim = Simulation::create(*scene, {});
  ASSERT_TRUE(sim) << sim.error().describe();
  Simulation& s = **sim;
  const double height = s.modelPose("red1")->translation().z();
  for (int i = 0; i < 2500; ++i) s.step();
  const Pose3 pose = *s.modelPose("red1");
  EXPECT_NEAR(pose.translation().z(), height, 0.002);
  EXPECT_GT(pose.linear()(2, 2), 0.999);
}

}  // namespace
}  // namespace simcore
