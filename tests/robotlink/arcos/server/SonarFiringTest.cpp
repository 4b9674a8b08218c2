// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/SonarFiring.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace {

using namespace robotlink;
using robotlink::arcos::SonarFiring;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto ms(int count) {
  return Instant(std::chrono::milliseconds(count));
}

TEST(SonarFiringTest, oneDiscOfEachArrayFiresEvery40Ms) {
  SonarFiring sonars(16);
  EXPECT_THAT(sonars.due(ms(0)), ElementsAre(0, 8));
  EXPECT_THAT(sonars.due(ms(36)), IsEmpty());
  EXPECT_THAT(sonars.due(ms(40)), ElementsAre(1, 9));
  EXPECT_THAT(sonars.due(ms(82)), ElementsAre(2, 10)) << "a late step does not shift the rounds";
  EXPECT_THAT(sonars.due(ms(120)), ElementsAre(3, 11));
}

TEST(SonarFiringTest, everyDiscFiresOnceIn320Ms) {
  SonarFiring sonars(16);
  std::map<int, int> shots;
  for (int time = 0; time < 320; time += 4) {
    for (const int disc : sonars.due(ms(time))) ++shots[disc];
  }
  ASSERT_EQ(shots.size(), 16U);
  for (const auto& [disc, count] : shots) EXPECT_EQ(count, 1) << disc;
}

TEST(SonarFiringTest, arraysAreSwitchedTogetherOrByNumber) {
  SonarFiring sonars(16);
  sonars.enable(0);
  EXPECT_THAT(sonars.due(ms(0)), IsEmpty());
  sonars.enable(1 | 2 << 1);
  EXPECT_TRUE(sonars.isOn(1));
  EXPECT_FALSE(sonars.isOn(0));
  EXPECT_THAT(sonars.all(), ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
  sonars.enable(1);
  EXPECT_TRUE(sonars.isOn(0));
  sonars.enable(0 | 1 << 1);
  EXPECT_FALSE(sonars.isOn(0));
  EXPECT_TRUE(sonars.isOn(1));
  EXPECT_FALSE(sonars.isOn(2)) << "there is no third array";
  sonars.enable(-1);
  sonars.enable(12345);
}

TEST(SonarFiringTest, aSequenceIsFollowedArrayByArray) {
  SonarFiring sonars(16);
  sonars.setSequence("\x03\x03\x01\x10");  // discs 2, 2 and 0 of the first array, 15 of the second
  EXPECT_THAT(sonars.due(ms(0)), ElementsAre(2, 15));
  EXPECT_THAT(sonars.due(ms(40)), ElementsAre(2, 15));
  EXPECT_THAT(sonars.due(ms(80)), ElementsAre(0, 15));
  EXPECT_THAT(sonars.all(), ElementsAre(0, 2, 15));
  sonars.setSequence("");
  EXPECT_THAT(sonars.all(), IsEmpty());
  std::string fives(200, '\x05');
  fives.push_back('\xFF');
  sonars.setSequence(fives);
  EXPECT_THAT(sonars.all(), ElementsAre(4));
  sonars.restore();
  EXPECT_EQ(sonars.all().size(), 16U);
}

TEST(SonarFiringTest, thePeriodStaysWithinItsLimits) {
  SonarFiring sonars(8);
  sonars.setPeriod(Duration(0));
  EXPECT_THAT(sonars.due(ms(0)), ElementsAre(0));
  EXPECT_THAT(sonars.due(ms(2)), ElementsAre(1));
  sonars.setPeriod(std::chrono::hours(1));
  EXPECT_THAT(sonars.due(ms(4)), ElementsAre(2));
  EXPECT_THAT(sonars.due(ms(124)), ElementsAre(3));
}

TEST(SonarFiringTest, afterALongPauseOnlyTheLastRoundFires) {
  SonarFiring sonars(8);
  sonars.due(ms(0));
  EXPECT_THAT(sonars.due(ms(100000)), ElementsAre(1));
  EXPECT_THAT(sonars.due(ms(100004)), IsEmpty());
}

}  // namespace
