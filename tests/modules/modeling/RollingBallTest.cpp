// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/RollingBall.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

/// Speed and way after a time, by small steps of dv/dt = -(deceleration + damping v).
std::pair<double, double> integrated(const RollingBall& ball, double speed, double seconds) {
  constexpr double kStep = 1e-5;
  double way = 0;
  for (double time = 0; time < seconds; time += kStep) {
    const double next = std::max(0.0, speed - (ball.deceleration + ball.damping * speed) * kStep);
    way += 0.5 * (speed + next) * kStep;
    speed = next;
  }
  return {speed, way};
}

TEST(RollingBall, slowsDownAsItsDifferentialEquationSays) {
  for (const RollingBall& ball :
       {RollingBall{0.3, 0}, RollingBall{0, 0.33}, RollingBall{0.1, 0.5}, RollingBall{0, 0}}) {
    for (const double seconds : {0.0, 0.3, 1.0, 4.0}) {
      const auto [speed, way] = integrated(ball, 0.6, seconds);
      EXPECT_NEAR(ball.speedAfter(0.6, seconds), speed, 1e-4) << seconds;
      EXPECT_NEAR(ball.wayAfter(0.6, seconds), way, 1e-4) << seconds;
    }
  }
}

TEST(RollingBall, staysWhereItCameToRest) {
  const RollingBall ball{0.3, 0.2};
  const double rest = ball.secondsToRest(0.5);
  EXPECT_NEAR(ball.speedAfter(0.5, rest), 0, 1e-12);
  EXPECT_EQ(ball.wayAfter(0.5, rest), ball.wayAfter(0.5, 100 * rest));
  EXPECT_EQ(ball.speedAfter(0.5, 100 * rest), ball.speedAfter(0.5, rest));
}

TEST(RollingBall, aBallThatRestsGoesNowhere) {
  for (const RollingBall& ball : {RollingBall{0.3, 0}, RollingBall{0, 0.33}, RollingBall{0, 0}}) {
    EXPECT_EQ(ball.wayAfter(0, 5), 0);
    EXPECT_EQ(ball.speedAfter(0, 5), 0);
  }
  EXPECT_TRUE(std::isinf(RollingBall({0, 0.33}).secondsToRest(1)));
}

TEST(RollingBall, withLittleDampingItRollsAsWithoutIt) {
  const RollingBall none{0.3, 0}, little{0.3, 2e-6};
  EXPECT_NEAR(none.wayAfter(0.6, 1), little.wayAfter(0.6, 1), 1e-5);
  EXPECT_NEAR(none.secondsToRest(0.6), little.secondsToRest(0.6), 1e-5);
}

}  // namespace
}  // namespace modules
