// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyClock.h"

#include <gtest/gtest.h>

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;

class BodyClockTest : public testing::Test {
 protected:
  /// Hears times of the body for a while, each after `delay`.
  void hearFor(robotlink::Duration time, robotlink::Duration delay, double speed = 1) {
    for (robotlink::Duration passed{0}; passed < time; passed += 8ms) {
      local_.advance(8ms);
      body_ += robotlink::fromSeconds(0.008 * speed);
      clock_.hear(body_ - delay);
    }
  }

  robotlink::ManualClock local_;
  BodyClock clock_{local_};
  Instant body_{100s};
};

TEST_F(BodyClockTest, itGoesByTheTimesOfTheBody) {
  hearFor(3s, 0ms);
  EXPECT_EQ(clock_.now(), body_);
  EXPECT_EQ(clock_.heard(), body_);
  EXPECT_EQ(clock_.shift(), 0s);
}

TEST_F(BodyClockTest, duringACutItGoesOnAsRealTimeDoes) {
  hearFor(1s, 0ms);
  local_.advance(20s);
  EXPECT_EQ(clock_.now(), body_ + 20s);
  body_ += 20s;
  hearFor(2s, 0ms);
  EXPECT_EQ(clock_.now(), body_);
}

TEST_F(BodyClockTest, aDelayThatGrowsIsFollowedWithoutGoingBack) {
  hearFor(2s, 10ms);
  const Instant before = clock_.now();
  hearFor(100ms, 400ms);
  EXPECT_GE(clock_.now(), before);
  hearFor(4s, 400ms);
  EXPECT_EQ(clock_.now(), body_ - 400ms);
}

TEST_F(BodyClockTest, aBodyThatIsSlowerThanRealTimeIsFollowed) {
  hearFor(10s, 0ms, 0.5);
  EXPECT_LT(clock_.now() - body_, 1100ms);
  EXPECT_GE(clock_.now(), body_);
}

TEST_F(BodyClockTest, aBodyThatIsStartedAnewContinues) {
  hearFor(2s, 0ms);
  const Instant before = clock_.now();
  body_ = Instant(0s);
  hearFor(2s, 0ms);
  EXPECT_EQ(clock_.now(), body_ + clock_.shift());
  EXPECT_GE(clock_.now(), before + 1900ms);
  EXPECT_LE(clock_.now(), before + 2100ms);
}

TEST_F(BodyClockTest, absurdTimesOfABodyDoNotOverflow) {
  Instant before;
  for (int i = 0; i < 20; ++i) {
    for (const Instant time : {Instant::max(), Instant::min(), Instant(1s)}) {
      clock_.hear(time);
      EXPECT_GE(clock_.now(), before);
      before = clock_.now();
    }
  }
  EXPECT_LT(before, Instant(24h * 365 * 150));
}

}  // namespace
}  // namespace app
