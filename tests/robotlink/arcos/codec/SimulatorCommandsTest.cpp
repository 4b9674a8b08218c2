// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/SimulatorCommands.h"

#include <gtest/gtest.h>

#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

TEST(SimulatorCommandsTest, truePosesAreSentAsRealClientsDo) {
  const TruePose pose{1000, 0, 0};
  EXPECT_EQ(toHex(encode(toPacket(setTruePose(pose)))),
            toHex(hexBytes("FA FB 10 E0 00 E8030000 00000000 00000000 C8 03")));
  const TruePose other{-70000, 123456, -90};
  const auto back = toCommand(toPacket(setTruePose(other)));
  ASSERT_TRUE(back);
  EXPECT_EQ(truePoseOf(*back), other);
}

TEST(SimulatorCommandsTest, theTypeByteOfAPoseIsIgnored) {
  for (const char* type : {"00", "3B", "1B"}) {
    const auto found = toCommand({224, hexBytes(std::string(type) + "E8030000 FFFFFFFF 5A000000")});
    ASSERT_TRUE(found);
    EXPECT_EQ(truePoseOf(*found), (TruePose{1000, -1, 90})) << type;
  }
  EXPECT_FALSE(truePoseOf(*toCommand({224, hexBytes("00 E8030000 FFFFFFFF 5A0000")})));
}

TEST(SimulatorCommandsTest, controlsComeWithTheirFile) {
  const SimulatorControl load{SimulatorControl::kLoadMap, "maps/office.map"};
  const auto back = toCommand(toPacket(simulatorControl(load)));
  ASSERT_TRUE(back);
  EXPECT_EQ(simulatorControlOf(*back), load);
  EXPECT_EQ(toHex(toPacket(simulatorControl({SimulatorControl::kLoadMap, "a"})).data), "3b0100010061");
  EXPECT_EQ(simulatorControlOf(*toCommand({236, hexBytes("3B 0600")})),
            (SimulatorControl{SimulatorControl::kInfo, ""}));
  EXPECT_FALSE(simulatorControlOf(*toCommand({236, hexBytes("3B 0100 0500 61")})));
  EXPECT_FALSE(simulatorControlOf(*toCommand({236, {}})));
}

}  // namespace
}  // namespace robotlink::arcos
