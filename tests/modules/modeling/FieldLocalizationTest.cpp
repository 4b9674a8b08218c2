// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for both filters of the pose that combine landmarks and lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "modules/modeling/localization/PoseKalmanFilter.h"
#include "tests/modules/modeling/FieldWalk.h"

namespace modules {
namespace {

using robotlink::Pose2;

/// Mean errors of a while, m and rad.
struct Errors {
  double place = 0, heading = 0;
};

template <typename Filter>
class FieldFilter : public testing::Test {
 protected:
  /// Lets the robot walk for some images, and returns the mean errors of the second half.
  Errors walk(FieldWalk& walk, int images) {
    Errors errors;
    const int counted = images / 2;
    for (int i = 0; i < images; ++i) {
      filter_.update(walk.step());
      if (i < images - counted) continue;
      errors.place += placeError(filter_.estimate(), walk.pose()) / counted;
      errors.heading += headingError(filter_.estimate(), walk.pose()) / counted;
    }
    return errors;
  }
  Filter filter_{FieldWalk({}).field(), {}};
};

using Filters = testing::Types<FieldMonteCarlo, PoseKalmanFilter>;
TYPED_TEST_SUITE(FieldFilter, Filters);

TYPED_TEST(FieldFilter, findsTheRobotFromNowhere) {
  FieldWalk walk({-0.8, 0.3, 0.5}, 7);
  const Errors errors = this->walk(walk, 400);
  EXPECT_LT(errors.place, 0.12);
  EXPECT_LT(errors.heading, 0.1);
  EXPECT_LT(this->filter_.estimate().positionDeviation, 0.3);
}

TYPED_TEST(FieldFilter, findsARobotAgainThatWasCarriedAway) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    this->filter_.startAt({1, 0.5, 0}, 0.1);
    FieldWalk walk({1, 0.5, 0}, seed);
    this->walk(walk, 100);
    robotlink::Random random(seed);
    walk.carry({random.uniform(-1.6, 0), random.uniform(-0.9, 0.9), random.uniform(-3, 3)});
    this->walk(walk, 250);
    const bool near = placeError(this->filter_.estimate(), walk.pose()) < 0.3;
    found += near && headingError(this->filter_.estimate(), walk.pose()) < 0.3 ? 1 : 0;
  }
  EXPECT_GE(found, 9);
}

TYPED_TEST(FieldFilter, keepsThePoseByLinesAlone) {
  FieldWalk with({-0.9, -0.4, 0}, 3), without({-0.9, -0.4, 0}, 3);
  for (FieldWalk* walk : {&with, &without}) walk->showLandmarks(false);
  without.showLines(false);
  this->filter_.startAt(with.pose(), 0.05);
  const Errors lines = this->walk(with, 1000);
  this->filter_.startAt(without.pose(), 0.05);
  const Errors nothing = this->walk(without, 1000);
  EXPECT_LT(lines.place, 0.2);
  EXPECT_LT(lines.place, 0.7 * nothing.place);
}

TYPED_TEST(FieldFilter, growsUnsureWithoutAnyMeasurement) {
  FieldWalk walk({0, 0, 0});
  walk.showLandmarks(false);
  walk.showLines(false);
  this->filter_.startAt({0, 0, 0}, 0.02);
  const double before = this->filter_.estimate().positionDeviation;
  this->walk(walk, 100);
  EXPECT_GT(this->filter_.estimate().positionDeviation, 2 * before);
  EXPECT_LT(placeError(this->filter_.estimate(), walk.pose()), 0.15);
}

TYPED_TEST(FieldFilter, staysOnTheField) {
  FieldWalk walk({});
  walk.showLandmarks(false);
  walk.showLines(false);
  this->filter_.startAt({2.05, 1.3, 0.7}, 0.05);
  this->walk(walk, 50);
  EXPECT_LE(std::abs(this->filter_.estimate().robotInField.x), 2.1);
  EXPECT_LE(std::abs(this->filter_.estimate().robotInField.y), 1.35);
}

TYPED_TEST(FieldFilter, isTheSameEveryTime) {
  TypeParam other(FieldWalk({}).field(), {});
  FieldWalk a({0.5, -0.5, 1}, 5), b({0.5, -0.5, 1}, 5);
  for (int i = 0; i < 100; ++i) {
    this->filter_.update(a.step());
    other.update(b.step());
  }
  EXPECT_EQ(this->filter_.estimate().robotInField, other.estimate().robotInField);
}

TEST(PoseKalmanFilter, hasSeveralHypothesesOnlyWhileItIsInDoubt) {
  FieldWalk walk({-0.5, 0.2, 0}, 2);
  PoseKalmanFilter filter(walk.field(), {});
  EXPECT_TRUE(filter.hypotheses().empty());
  EXPECT_GT(filter.estimate().positionDeviation, 1);
  for (int i = 0; i < 300; ++i) filter.update(walk.step());
  ASSERT_FALSE(filter.hypotheses().empty());
  EXPECT_GT(filter.hypotheses().front().weight, 0.8);
  double sum = 0;
  for (const auto& one : filter.hypotheses()) sum += one.weight;
  EXPECT_NEAR(sum, 1, 1e-9);
}

TEST(FieldMonteCarlo, knowsHowWellTheLandmarksFit) {
  FieldWalk walk({-0.5, 0.2, 0}, 2);
  FieldMonteCarlo filter(walk.field(), {});
  filter.startAt(walk.pose(), 0.1);
  for (int i = 0; i < 100; ++i) filter.update(walk.step());
  const double fit = filter.fit();
  EXPECT_GT(fit, 0.35);
  walk.carry({1.2, -0.7, 3});
  double worst = fit;
  for (int i = 0; i < 16; ++i) {
    filter.update(walk.step());
    worst = std::min(worst, filter.fit());
  }
  EXPECT_LT(worst, 0.6 * fit);
}

/// Other robots turn one that pushes them, and its dead reckoning does not know it.
TEST(FieldMonteCarlo, aRobotThatOthersTurnedKnowsItsHeadingAgain) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    FieldWalk walk({1, 0.5, 0}, seed);
    FieldMonteCarlo filter(walk.field(), {});
    filter.startAt(walk.pose(), 0.1);
    for (int i = 0; i < 50; ++i) filter.update(walk.step());
    const Pose2 pose = walk.pose();
    walk.carry({pose.x, pose.y, pose.heading + (seed % 2 == 0 ? 1.2 : -1.2)});
    double error = 9;
    // The head sweeps: there are images without landmarks among these.
    for (int i = 0; i < 16; ++i) {
      filter.update(walk.step());
      error = std::min(error, headingError(filter.estimate(), walk.pose()));
    }
    found += error < 0.2 ? 1 : 0;
  }
  EXPECT_GE(found, 9);
}

/// Lines alone are explained by several places, of which the densest one changes: without keeping to one, the
/// estimate jumps 24 times.
TEST(FieldMonteCarlo, theEstimateDoesNotJumpToAndFro) {
  int jumps = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    FieldWalk walk({0.9, 0.4, 0}, seed);
    FieldMonteCarlo filter(walk.field(), {});
    filter.startAt(walk.pose(), 2.5);
    walk.showLandmarks(false);
    filter.update(walk.step());
    for (int i = 1; i < 200; ++i) {
      const robotlink::Vector2 before = filter.estimate().robotInField.translation();
      filter.update(walk.step());
      jumps += (filter.estimate().robotInField.translation() - before).norm() > 0.5 ? 1 : 0;
    }
  }
  EXPECT_LE(jumps, 18);
}

}  // namespace
}  // namespace modules
