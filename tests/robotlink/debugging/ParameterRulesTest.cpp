// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/ParameterRules.h"

#include <gtest/gtest.h>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"

namespace robotlink {
namespace {

// The fields of a cube: its pose (1), in it the position (1), in it x (1); its color (3), in it the red (1).
const ParameterField kX{1, 1, 1};

TEST(ParameterRules, aRangeIsDescribedInWords) {
  EXPECT_EQ((ParameterRange{1, 50, false}.describe()), "between 1 and 50");
  EXPECT_EQ((ParameterRange{0, 0.5, true}.describe()), "more than 0 and at most 0.5");
  EXPECT_EQ((ParameterRange{.minimum = 0, .above = true}.describe()), "more than 0");
  EXPECT_EQ((ParameterRange{.minimum = 2}.describe()), "at least 2");
}

TEST(ParameterRules, aRangeHasItsEndsUnlessItBeginsAboveOne) {
  const ParameterRange closed{1, 2, false}, open{1, 2, true};
  EXPECT_TRUE(closed.has(1) && closed.has(2) && open.has(2) && open.has(1.001));
  EXPECT_FALSE(closed.has(0.999) || closed.has(2.001) || open.has(1) || open.has(2.001));
}

TEST(ParameterRules, numbersAreReadAndSetInMessagesOfAMessage) {
  foxglove::CubePrimitive cube;
  EXPECT_EQ(numberIn(cube, kX), std::nullopt);
  setNumber(cube, kX, 2.5);
  EXPECT_EQ(cube.pose().position().x(), 2.5);
  EXPECT_EQ(numberIn(cube, kX), 2.5);
  clearNumber(cube, kX);
  EXPECT_EQ(numberIn(cube, kX), std::nullopt);
  EXPECT_EQ(nameOf(cube, kX), "pose.position.x");
}

TEST(ParameterRules, integersAreTakenToo) {
  robotcontrol::KeyMode mode;
  const ParameterField n(2);
  setNumber(mode, n, 7);
  EXPECT_EQ(mode.n(), 7U);
  EXPECT_EQ(numberIn(mode, n), 7);
  mode.set_kind(robotcontrol::KeyMode::ALWAYS);
  EXPECT_EQ(numberIn(mode, 1), std::nullopt) << "an enumerator is no number";
  EXPECT_EQ(numberIn(mode, 9), std::nullopt) << "there is no such field";
}

}  // namespace
}  // namespace robotlink
