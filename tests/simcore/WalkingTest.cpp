// SPDX-License-Identifier: GPL-3.0-or-later
// No gait, only the question whether the simulated robot could walk: a trot of sine waves, open loop.
#include <gtest/gtest.h>

#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "simcore/physics/Physics.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

constexpr double kPeriod = 0.5;
// The first three servos of each leg follow each other from here: FR, FL, HR, HL.
constexpr std::size_t kFirstLegServo = 6;

/// A leg's offsets from the stance for joints 1 and 3 at a phase.
struct Swing {
  double hip, knee;
};
Swing swing(std::size_t leg, double time) {
  const bool fore = leg < 2, firstPair = leg == 0 || leg == 3;
  const double phase = 2 * robotlink::kPi * time / kPeriod + (firstPair ? 0 : robotlink::kPi);
  const double start = std::min(1.0, time);
  const double lift = std::max(0.0, std::cos(phase)) * 0.5 * start;
  return {(fore ? 1 : -1) * 0.18 * start * std::sin(phase) - lift * 0.5, lift};
}

TEST(Walking, aTrotOfSineWavesMovesTheRobotForward) {
  const auto simulation = std::move(Simulation::create(shippedScene(), {.seed = 1, .noise = false}).value());
  ASSERT_TRUE(simulation->placeModel("ball", {0, 1, 0}));
  std::vector<double> stance;
  for (const Sensor& sensor : simulation->sensors()) stance.push_back(sensor.values[0]);
  double lowest = 1;
  for (int i = 0; i < 2000; ++i) {
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const Swing now = swing(leg, robotlink::seconds(simulation->time()));
      const std::size_t first = kFirstLegServo + 3 * leg;
      simulation->requestAngle(first, stance[first] + now.hip);
      simulation->requestAngle(first + 2, stance[first + 2] + now.knee);
    }
    simulation->step();
    lowest = std::min(lowest, simulation->modelPose("red1")->linear()(2, 2));
  }
  const Pose3 pose = *simulation->modelPose("red1");
  EXPECT_GT(pose.translation().x(), -0.8 + 0.5);
  EXPECT_LT(std::abs(pose.translation().y()), 0.3);
  EXPECT_GT(lowest, std::cos(robotlink::radians(20))) << "it stayed upright";
}

TEST(Walking, violentRequestsDoNotBlowUpTheWorld) {
  const auto simulation = std::move(Simulation::create(shippedScene(), {.seed = 1, .noise = true}).value());
  robotlink::Random random(7);
  for (int i = 0; i < 2000; ++i) {
    for (std::size_t s = 0; i % 25 == 0 && s < simulation->servos().size(); ++s) {
      simulation->requestAngle(
          s, random.uniform(simulation->servos()[s].minimum, simulation->servos()[s].maximum));
    }
    simulation->step();
    for (const Pose3& body : simulation->bodyPoses()) {
      ASSERT_TRUE(body.matrix().allFinite());
      ASSERT_LT(body.translation().norm(), 3.5) << "at step " << i;
      ASSERT_GT(body.translation().z(), -0.02) << "at step " << i;
      ASSERT_LT(body.translation().z(), 0.5) << "at step " << i;
    }
  }
}

TEST(Walking, hingesHoldTogether) {
  Physics physics(shippedScene()->contents().world);
  double gap = 0;
  for (int i = 0; i < 1000; ++i) {
    // Every servo swings fast and with force, so that legs hit the ground and each other's momentum.
    for (std::size_t hinge = 0; hinge < 20; ++hinge) {
      physics.setMotor(hinge, 2.5 * std::sin(0.05 * i + static_cast<double>(hinge % 3)), 1.0);
    }
    physics.step(static_cast<std::uint64_t>(i));
    for (std::size_t hinge = 0; hinge < 20; ++hinge) gap = std::max(gap, physics.anchorGap(hinge));
  }
  EXPECT_LT(gap, 0.003);
  EXPECT_GT(gap, 0);
}

}  // namespace
}  // namespace simcore
