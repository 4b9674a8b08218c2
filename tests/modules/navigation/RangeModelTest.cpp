// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/RangeModel.h"

#include <gtest/gtest.h>

#include "FlatWorld.h"

namespace modules {
namespace {

using robotlink::Pose2;

/// A room of 8 m by 5 m with a wall that juts into it, and what a robot in it measures.
class RangeModelTest : public testing::Test {
 protected:
  static robotlink::GroundMap map() {
    robotlink::GroundMap map = roomMap(8, 5);
    addWall(map, 3, 0, 3, 2);
    return map;
  }
  /// Rays all around, or cones, as they are measured at a pose.
  std::vector<RangeBeam> measured(const Pose2& robot, double openingAngle = 0, double maximum = 12) const {
    std::vector<RangeBeam> beams;
    for (int i = 0; i < 24; ++i) {
      RangeBeam beam;
      beam.sensorInRobot = {0.1, 0, robotlink::normalizedAngle(i * robotlink::kPi / 12)};
      beam.openingAngle = openingAngle;
      beam.maximum = maximum;
      beam.range = std::min(maximum, distances_.range(robot * beam.sensorInRobot, openingAngle, maximum));
      beams.push_back(beam);
    }
    return beams;
  }
  double likelihood(const Pose2& at) const {
    Particle particle;
    particle.x = static_cast<float>(at.x);
    particle.y = static_cast<float>(at.y);
    particle.heading = static_cast<float>(at.heading);
    return model_.logLikelihood(particle);
  }
  /// That no other pose near or far explains the measurements as well as the true one.
  void expectBest(const Pose2& truth) const {
    const double best = likelihood(truth);
    for (const Pose2& other : {Pose2{0.5, 0, 0},
                               {-0.5, 0, 0},
                               {0, 0.5, 0},
                               {0, -0.5, 0},
                               {0, 0, 0.4},
                               {0, 0, -0.4},
                               {0, 0, robotlink::kPi},
                               {3, 1, 1}})
      EXPECT_LT(likelihood(truth * other), best) << other.x << " " << other.y << " " << other.heading;
  }

  const DistanceMap distances_{map(), {}};
  RangeModel model_{distances_, {}};
  const Pose2 truth_{1.5, 1.5, 0.3};
};

TEST_F(RangeModelTest, raysAreLikeliestWhereTheyWereMeasured) {
  EXPECT_TRUE(model_.empty());
  model_.choose(measured(truth_));
  EXPECT_FALSE(model_.empty());
  expectBest(truth_);
  EXPECT_GT(model_.explainedShare(truth_), 0.9);
}

TEST_F(RangeModelTest, conesAreLikeliestWhereTheyWereMeasured) {
  model_.choose(measured(truth_, robotlink::radians(25), 5));
  expectBest(truth_);
  EXPECT_GT(model_.explainedShare(truth_), 0.9);
}

TEST_F(RangeModelTest, raysThatHitNothingSayNothing) {
  auto beams = measured(truth_);
  for (RangeBeam& beam : beams) beam.range = beam.maximum;
  model_.choose(beams);
  EXPECT_TRUE(model_.empty());
}

TEST_F(RangeModelTest, aPoseWhoseRaysWouldPassThroughWallsDoesNotExplainThem) {
  // In front of the wall it sees the wall at 1.4 m. From behind the outer wall a ray of 3.8 m would end
  // there, too.
  RangeBeam ahead;
  ahead.maximum = 12;
  ahead.range = 1.4;
  model_.choose(std::vector{ahead});
  EXPECT_EQ(model_.explainedShare({1.6, 1, 0}), 1);
  ahead.range = 3.83;
  model_.choose(std::vector{ahead});
  EXPECT_EQ(model_.explainedShare({-0.83, 1.02, 0}), 0);
}

TEST_F(RangeModelTest, thingsThatTheMapDoesNotKnowCostLittle) {
  auto beams = measured(truth_);
  model_.choose(beams);
  const double without = likelihood(truth_);
  for (std::size_t i = 0; i < 4; ++i) beams[i].range = 0.3;  // somebody's legs
  model_.choose(beams);
  expectBest(truth_);
  EXPECT_LT(likelihood(truth_), without);
  EXPECT_GT(model_.explainedShare(truth_), 0.7);
}

TEST_F(RangeModelTest, ofManyRaysSomeAreEvenlyChosen) {
  std::vector<RangeBeam> beams;
  for (int i = 0; i < 41; ++i) {  // so that every 24th is another one
    for (const RangeBeam& beam : measured(truth_)) beams.push_back(beam);
  }
  const Pose2 aside = truth_ * Pose2{0.2, 0, 0};
  model_.choose(beams);
  const double many = likelihood(aside);
  model_.choose(measured(truth_));
  // 40 rays at most: as much evidence as these, not 40 times as much.
  EXPECT_NEAR(many / likelihood(aside), 40.0 / 24, 0.5);
}

}  // namespace
}  // namespace modules
