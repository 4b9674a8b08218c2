// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/ParsedMessage.h"

#include <gtest/gtest.h>

#include "robotcontrol/Driving.pb.h"

namespace robotlink {
namespace {

TEST(ParsedMessage, hasItsOwnType) {
  robotcontrol::DriveState state;
  state.set_left_speed(0.25);
  const auto parsed = parsedMessage("robotcontrol.DriveState", state.SerializeAsString());
  const auto* same = dynamic_cast<const robotcontrol::DriveState*>(parsed.get());
  ASSERT_NE(same, nullptr);
  EXPECT_EQ(same->left_speed(), 0.25);
}

TEST(ParsedMessage, isNullIfTypeOrBytesAreWrong) {
  EXPECT_EQ(parsedMessage("robotcontrol.NoSuchType", ""), nullptr);
  EXPECT_EQ(parsedMessage("", ""), nullptr);
  EXPECT_EQ(parsedMessage("robotcontrol.DriveState", "\xff\xff\xff"), nullptr);
}

TEST(ParsedMessage, noBytesAreAMessageOfDefaults) {
  EXPECT_NE(parsedMessage("robotcontrol.DriveState", ""), nullptr);
}

}  // namespace
}  // namespace robotlink
