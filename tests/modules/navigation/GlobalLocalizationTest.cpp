// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that know nothing of where they are wander in maps of real buildings.
#include <gtest/gtest.h>

#include "Ride.h"
#include "modules/driving/Wanderer.h"
#include "modules/navigation/MonteCarloLocalizer.h"

namespace modules {
namespace {

struct Outcome {
  double error = 0;           ///< m, at the end
  double dishonest = 0;       ///< s, with an error of more than 1 m and a deviation of less than 0.3 m
  double firstDeviation = 0;  ///< m, after the first measurement
};

robotlink::Pose2 freePlace(const FlatWorld& world, const ReachableSpace& space, std::uint64_t seed) {
  robotlink::Random random(seed, 5);
  robotlink::Pose2 place = space.draw(random);
  while (world.distance(Outline{}, place) < 0.15) place = space.draw(random);
  return place;
}

/// Wanders from some free place; `carried`: it is put elsewhere after half of the time.
Outcome wander(const robotlink::GroundMap& map, std::uint64_t seed, double seconds, bool laser,
               bool carried = false) {
  const FlatWorld world(map);
  MonteCarloLocalizer::Options options;
  options.seed = seed;
  MonteCarloLocalizer localizer(map, options);
  const robotlink::Pose2 start = freePlace(world, localizer.freeSpace(), seed);
  Ride ride(world, {.start = start, .laser = laser, .seed = seed}, Avoidance::kVectorField);
  Wanderer wanderer({.seed = seed});
  robotlink::Pose2 last;
  Outcome outcome;
  const auto step = [&](auto points) {
    const RollingRobot& robot = ride.robot();
    localizer.move(last.inverse() * robot.odometry());
    last = robot.odometry();
    std::vector<RangeBeam> beams = robot.beams();
    if (laser) std::erase_if(beams, [](const RangeBeam& beam) { return beam.openingAngle > 0; });
    localizer.see(beams);
    const PoseEstimate& estimate = localizer.estimate();
    outcome.error = (estimate.robotInField.translation() - robot.pose().translation()).norm();
    if (robot.time() == 0) outcome.firstDeviation = estimate.positionDeviation;
    if (outcome.error > 1 && estimate.positionDeviation < 0.3) outcome.dishonest += RollingRobot::kCycle;
    return wanderer.decide(points, robot.odometry(), robot.time());
  };
  ride.run(carried ? 0.5 * seconds : seconds, step);
  if (carried) {
    ride.robot().carry(freePlace(world, localizer.freeSpace(), seed + 100));
    ride.run(0.5 * seconds, step);
  }
  return outcome;
}

TEST(GlobalLocalization, aMinuteInTheOfficeTellsWhereItIs) {
  const robotlink::GroundMap map = sharedMap("office.map");
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/office.map";
  int found = 0;
  double dishonest = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Outcome outcome = wander(map, seed, 60, true);
    found += outcome.error < 0.3 ? 1 : 0;
    dishonest += outcome.dishonest;
    EXPECT_GT(outcome.firstDeviation, 1) << seed;
  }
  EXPECT_GE(found, 9);
  EXPECT_LT(dishonest, 10);
}

TEST(GlobalLocalization, sonarsTellIt) {
  const robotlink::GroundMap map = sharedMap("office.map");
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/office.map";
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) found += wander(map, seed, 120, false).error < 0.3 ? 1 : 0;
  EXPECT_GE(found, 4);
}

TEST(GlobalLocalization, aRobotThatIsCarriedOffFindsItselfAgain) {
  const robotlink::GroundMap map = sharedMap("office.map");
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/office.map";
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    found += wander(map, seed, 120, true, true).error < 0.3 ? 1 : 0;
  EXPECT_GE(found, 4);
}

TEST(GlobalLocalization, twoMinutesInALargeBuildingTellIt) {
  const robotlink::GroundMap map = sharedMap("columbia.map");
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/columbia.map";
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) found += wander(map, seed, 120, true).error < 0.3 ? 1 : 0;
  EXPECT_GE(found, 4);
}

}  // namespace
}  // namespace modules
