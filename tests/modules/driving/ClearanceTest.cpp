// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/Clearance.h"

#include <gtest/gtest.h>

#include "modules/driving/PolarView.h"
#include "modules/driving/SpeedLimiter.h"

namespace modules {
namespace {

using robotlink::kPi;
using robotlink::radians;
using robotlink::Vector2;

constexpr Outline kBody{0.3, 0.25};
constexpr Clearance::Options kOptions{0.1, 4.0};

TEST(Clearance, straightAheadItIsTheWayToThePointLessTheMargin) {
  const std::vector<Vector2> points{{1.4, 0}};
  const Clearance clearance(kBody, kOptions, points);
  EXPECT_NEAR(1.0 / 0.5, clearance.freeTime({0.5, 0}), 0.1);
  EXPECT_EQ(4, clearance.freeTime({-0.5, 0}));
  EXPECT_NEAR(1.1, clearance.nearest(), 1e-9);
}

TEST(Clearance, whatIsPassedIsNotInTheWay) {
  const std::vector<Vector2> points{{1.4, 0.37}, {1.4, -0.37}};
  EXPECT_EQ(4, Clearance(kBody, kOptions, points).freeTime({0.5, 0}));
  const std::vector<Vector2> narrow{{1.4, 0.33}};
  EXPECT_LT(Clearance(kBody, kOptions, narrow).freeTime({0.5, 0}), 3);
}

TEST(Clearance, aTurnOnTheSpotIsLimitedByItsCorners) {
  // Nearer than the corners reach, but not than the sides.
  const std::vector<Vector2> points{{0, 0.37}};
  const Clearance clearance(kBody, kOptions, points);
  EXPECT_LT(clearance.freeTime({0, 0.5}), 1.5);
  EXPECT_LT(clearance.freeTime({0, -0.5}), 1.5);
  const std::vector<Vector2> away{{0, 0.52}};
  EXPECT_EQ(4, Clearance(kBody, kOptions, away).freeTime({0, 0.5}));
}

TEST(Clearance, arcsGoAroundCorners) {
  const std::vector<Vector2> points{{1.2, 0}};
  const Clearance clearance(kBody, kOptions, points);
  EXPECT_LT(clearance.freeTime({0.4, 0}), 2.2);
  EXPECT_EQ(4, clearance.freeTime({0.4, 0.8}));
}

TEST(Clearance, fromWhatIsTooNearAlreadyItMayGetAwayButNoNearer) {
  const std::vector<Vector2> points{{0.35, 0}};
  const Clearance clearance(kBody, kOptions, points);
  EXPECT_LT(clearance.freeTime({0.2, 0}), 0.1);
  EXPECT_EQ(4, clearance.freeTime({-0.2, 0}));
}

TEST(Clearance, safeIsWhatItCanStillBrakeFrom) {
  const std::vector<Vector2> points{{1.0, 0}};  // 0.6 m to the margin
  const Clearance clearance(kBody, kOptions, points);
  const DriveLimits limits;                              // 0.3 m/s^2
  EXPECT_TRUE(clearance.safe({0.4, 0}, limits, 0.25));   // 0.1 m + 0.27 m
  EXPECT_FALSE(clearance.safe({0.7, 0}, limits, 0.25));  // 0.18 m + 0.82 m
  const DriveVelocity less = clearance.limited({0.7, 0}, limits, 0.25);
  EXPECT_GT(less.forward, 0.3);
  EXPECT_LT(less.forward, 0.6);
  EXPECT_EQ(0, less.rotation);
}

TEST(PolarView, saysHowFarADiscCouldGo) {
  const std::vector<Vector2> points{{2, 0}, {0, 1}};
  const PolarView view(points, 0.35, 3);
  EXPECT_NEAR(1.65, view.freeAt(0), 1e-9);
  EXPECT_NEAR(0.65, view.freeAt(0.5 * kPi), 1e-9);
  EXPECT_EQ(3, view.freeAt(kPi));
  EXPECT_EQ(3, view.freeAt(radians(45)));
  EXPECT_NEAR(1.65, view.freeAbout(radians(5), radians(6)), 0.05);
  EXPECT_EQ(view.free(-1), view.free(PolarView::kSectors - 1));
}

TEST(PolarView, aGapIsOpenOnlyIfItIsWideEnough) {
  const std::vector<Vector2> wide{{1.5, 0.4}, {1.5, -0.4}}, narrow{{1.5, 0.3}, {1.5, -0.3}};
  EXPECT_EQ(3, PolarView(wide, 0.35, 3).freeAt(0));
  EXPECT_LT(PolarView(narrow, 0.35, 3).freeAt(0), 1.5);
}

TEST(SpeedLimiter, speedsChangeAsFastAsTheMotorsCan) {
  SpeedLimiter limiter;
  const DriveLimits limits{0.7, 1.5, 0.3, 1.0};
  EXPECT_NEAR(0.03, limiter.limit({5, 0}, limits, 0.1).forward, 1e-9);
  for (int i = 0; i < 50; ++i) limiter.limit({5, -9}, limits, 0.1);
  EXPECT_NEAR(0.7, limiter.last().forward, 1e-9);
  EXPECT_NEAR(-1.5, limiter.last().rotation, 1e-9);
  // Braking is twice as hard.
  EXPECT_NEAR(0.64, limiter.limit({0, 0}, limits, 0.1).forward, 1e-9);
  // A pause is no leave to jump.
  EXPECT_NEAR(0.52, limiter.limit({0, 0}, limits, 60).forward, 1e-9);
  EXPECT_NEAR(0.46, limiter.limit({std::nan(""), 0}, limits, 0.1).forward, 1e-9);
}

}  // namespace
}  // namespace modules
