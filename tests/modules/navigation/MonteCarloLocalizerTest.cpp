// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/MonteCarloLocalizer.h"

#include <gtest/gtest.h>

#include "RollingRobot.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;

/// A room that looks different from everywhere.
GroundMap crookedRoom() {
  GroundMap map = roomMap(6, 4);
  addWall(map, 2, 4, 2, 3);
  addWall(map, 4.5, 0, 4.5, 0.7);
  addWall(map, 4.5, 0.7, 6, 0.7);
  return map;
}

double errorOf(const MonteCarloLocalizer& localizer, const RollingRobot& robot) {
  return (localizer.estimate().robotInField.translation() - robot.pose().translation()).norm();
}

/// Drives circles and tells what is measured; with a laser by it alone.
class Circling {
 public:
  Circling(const GroundMap& map, const Pose2& start, bool laser)
      : world_(map), robot_(world_, {.start = start, .laser = laser, .seed = 3}), laser_(laser) {}
  void run(MonteCarloLocalizer& localizer, double seconds) {
    for (const double end = robot_.time() + seconds; robot_.time() < end - 1e-6;) {
      robot_.drive({0.3, 0.5});
      localizer.move(last_.inverse() * robot_.odometry());
      last_ = robot_.odometry();
      std::vector<RangeBeam> beams = robot_.beams();
      if (laser_) std::erase_if(beams, [](const RangeBeam& beam) { return beam.openingAngle > 0; });
      localizer.see(beams);
    }
  }
  RollingRobot& robot() { return robot_; }

 private:
  FlatWorld world_;
  RollingRobot robot_;
  bool laser_;
  Pose2 last_;
};

TEST(MonteCarloLocalizer, isUncertainUntilItHasSeenEnough) {
  const GroundMap map = crookedRoom();
  MonteCarloLocalizer localizer(map, {});
  EXPECT_GT(localizer.estimate().positionDeviation, 1);
  EXPECT_GT(localizer.estimate().headingDeviation, 1);
  Circling circling(map, {3, 1.5, 0}, true);
  circling.run(localizer, 8);
  EXPECT_LT(errorOf(localizer, circling.robot()), 0.1);
  EXPECT_LT(localizer.estimate().positionDeviation, 0.15);
  EXPECT_GT(localizer.fit(), 0.9);
}

TEST(MonteCarloLocalizer, needsFewParticlesOnceItKnows) {
  const GroundMap map = crookedRoom();
  MonteCarloLocalizer::Options options;
  options.particlesPerArea = 400;
  MonteCarloLocalizer localizer(map, options);
  const std::size_t before = localizer.particles().size();
  Circling circling(map, {3, 1.5, 0}, true);
  circling.run(localizer, 8);
  EXPECT_GT(before, 5000U);
  EXPECT_EQ(1200U, localizer.particles().size());
}

TEST(MonteCarloLocalizer, sonarsAreEnoughInARoom) {
  const GroundMap map = crookedRoom();
  MonteCarloLocalizer localizer(map, {});
  Circling circling(map, {3, 1.5, 0}, false);
  circling.run(localizer, 25);
  EXPECT_LT(errorOf(localizer, circling.robot()), 0.25);
}

TEST(MonteCarloLocalizer, keepsToAKnownStart) {
  // In an empty room four poses look the same; who knows the start keeps it.
  const GroundMap map = roomMap(5, 5);
  MonteCarloLocalizer localizer(map, {});
  localizer.startAt({2, 2, 1}, 0.2, 0.1);
  EXPECT_LT(localizer.estimate().positionDeviation, 0.3);
  Circling circling(map, {2.1, 1.9, 1.05}, true);
  circling.run(localizer, 10);
  EXPECT_LT(errorOf(localizer, circling.robot()), 0.1);
}

TEST(MonteCarloLocalizer, saysThatASquareRoomHasFourPossibilities) {
  const GroundMap map = roomMap(5, 5);
  MonteCarloLocalizer localizer(map, {});
  Circling circling(map, {1.5, 1.5, 0}, true);
  circling.run(localizer, 4);
  EXPECT_GT(localizer.estimate().positionDeviation, 0.35);
}

TEST(MonteCarloLocalizer, looksForItselfWhenItIsCarriedOff) {
  GroundMap map = crookedRoom();
  addWall(map, 6, 3.4, 9, 4);
  addWall(map, 9, 4, 9, 0);
  addWall(map, 6, 0, 9, 0);
  addWall(map, 6, 4, 9, 4);
  MonteCarloLocalizer localizer(map, {});
  Circling circling(map, {3, 1.5, 0}, true);
  circling.run(localizer, 8);
  ASSERT_LT(errorOf(localizer, circling.robot()), 0.1);
  circling.robot().carry({7.5, 1.1, 0});
  circling.run(localizer, 1);
  EXPECT_GT(localizer.estimate().positionDeviation, 0.2);
  circling.run(localizer, 20);
  EXPECT_LT(errorOf(localizer, circling.robot()), 0.15);
}

TEST(MonteCarloLocalizer, standingStillMakesItNoSurer) {
  const GroundMap map = roomMap(5, 5);
  MonteCarloLocalizer localizer(map, {});
  const FlatWorld world(map);
  const RollingRobot robot(world, {.start = {1.5, 1.5, 0}});
  EXPECT_TRUE(localizer.see(robot.beams()));
  const double deviation = localizer.estimate().positionDeviation;
  for (int i = 0; i < 100; ++i) {
    localizer.move({});
    EXPECT_FALSE(localizer.see(robot.beams()));
  }
  EXPECT_NEAR(deviation, localizer.estimate().positionDeviation, 0.3);
}

TEST(MonteCarloLocalizer, aMapWithoutWallsLeavesItUncertain) {
  MonteCarloLocalizer localizer(GroundMap{}, {});
  localizer.move({0.1, 0, 0.1});
  const std::vector<RangeBeam> beams{{{}, 1, 5, 0, {}}};
  EXPECT_FALSE(localizer.see(beams));
  EXPECT_GT(localizer.estimate().positionDeviation, 100);
  EXPECT_TRUE(localizer.particles().empty());
}

TEST(MonteCarloLocalizer, theSameSeedGivesTheSameParticles) {
  const GroundMap map = crookedRoom();
  const auto run = [&] {
    MonteCarloLocalizer localizer(map, {});
    Circling circling(map, {3, 1.5, 0}, true);
    circling.run(localizer, 3);
    return localizer.estimate().robotInField;
  };
  EXPECT_EQ(run(), run());
}

TEST(Particles, theHeaviestClusterIsTheEstimateAndTheOthersAreItsDoubt) {
  std::vector<Particle> particles;
  for (int i = 0; i < 70; ++i) particles.push_back({2 + 0.01F * static_cast<float>(i % 7), 1, 3.1F, 0});
  for (int i = 0; i < 30; ++i) particles.push_back({8, 1, -3.1F, 0});
  const PoseEstimate estimate = summarize(particles);
  EXPECT_NEAR(2.03, estimate.robotInField.x, 0.01);
  EXPECT_NEAR(3.1, estimate.robotInField.heading, 0.01);
  EXPECT_NEAR(std::sqrt(0.5 * 0.3 * 36), estimate.positionDeviation, 0.1);
  // Across the turn from pi to -pi it is a small one.
  EXPECT_LT(estimate.headingDeviation, 0.1);
  EXPECT_GT(summarize({}).positionDeviation, 100);
}

TEST(Particles, aWideCloudNeedsMoreOfThem) {
  std::vector<Particle> narrow, wide;
  for (int i = 0; i < 1000; ++i) {
    narrow.push_back({0.0001F * static_cast<float>(i), 0, 0, 0});
    wide.push_back({0.1F * static_cast<float>(i), 0, 0, 0});
  }
  EXPECT_EQ(1, neededParticles(narrow));
  EXPECT_GT(neededParticles(wide), 3000);
}

}  // namespace
}  // namespace modules
