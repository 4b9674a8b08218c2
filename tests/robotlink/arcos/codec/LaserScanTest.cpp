// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/LaserScan.h"

#include <gtest/gtest.h>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

LaserPacket part(std::uint16_t first, std::uint16_t count, std::uint16_t total = 181) {
  LaserPacket packet;
  packet.total = total;
  packet.first = first;
  for (std::uint16_t i = 0; i < count; ++i) {
    packet.readings.push_back(
        {static_cast<std::uint16_t>(1000 + first + i), static_cast<std::uint8_t>(i), {}});
  }
  return packet;
}

class LaserScanTest : public ::testing::Test {
 protected:
  std::optional<LaserScan> take(const LaserPacket& packet) {
    now += 1ms;
    return assembler.take(packet, &information, now);
  }
  LaserScanAssembler assembler;
  StandardInformation information;
  Instant now{};
};

TEST_F(LaserScanTest, partsMakeAScan) {
  information.xMm = 10;
  information.heading4096 = 1024;
  EXPECT_FALSE(take(part(0, 100)));
  information.xMm = 50;  // it is stamped with where it began
  const auto scan = take(part(100, 81));
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->rangesMm.size(), 181U);
  for (std::size_t i = 0; i < 181; ++i) EXPECT_EQ(scan->rangesMm[i], 1000 + i);
  EXPECT_EQ(scan->reflectances[101], 1);
  EXPECT_EQ(scan->takenAt, Instant(1ms));
  EXPECT_EQ(scan->xMm, 10);
  EXPECT_EQ(scan->headingDeg, 90);
  EXPECT_EQ(assembler.incompleteScans(), 0U);
}

TEST_F(LaserScanTest, aMissingPartCostsOneScan) {
  take(part(0, 32));
  EXPECT_FALSE(take(part(64, 117)));
  EXPECT_FALSE(take(part(96, 85)));
  EXPECT_EQ(assembler.incompleteScans(), 1U);
  take(part(0, 100));
  EXPECT_FALSE(take(part(0, 100)));  // the end of the last one was missing
  EXPECT_EQ(assembler.incompleteScans(), 2U);
  EXPECT_TRUE(take(part(100, 81)));
}

TEST_F(LaserScanTest, aPartThatComesTwiceIsHeededOnce) {
  take(part(0, 32));
  take(part(32, 32));
  take(part(32, 32));
  const auto scan = take(part(64, 117));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->rangesMm.size(), 181U);
  EXPECT_EQ(scan->rangesMm[180], 1180);
}

TEST_F(LaserScanTest, partsOfAnotherScanDoNotFit) {
  take(part(0, 32));
  EXPECT_FALSE(take(part(32, 32, 361)));
  EXPECT_EQ(assembler.incompleteScans(), 1U);
  take(part(0, 32));
  LaserPacket other = part(32, 149);
  other.device = 1;
  EXPECT_FALSE(take(other));
}

TEST_F(LaserScanTest, moreReadingsThanTheScanHasAreLeftOut) {
  const auto scan = take(part(0, 32, 10));
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->rangesMm.size(), 10U);
}

TEST_F(LaserScanTest, plainPacketsSayWhereTheRobotWas) {
  LaserPacket plain = part(0, 2, 2);
  plain.extended = false;
  plain.xMm = -7;
  plain.headingDeg = 45;
  const auto scan = take(plain);
  ASSERT_TRUE(scan);
  EXPECT_EQ(scan->xMm, -7);
  EXPECT_EQ(scan->headingDeg, 45);
  EXPECT_TRUE(LaserScanAssembler().take(part(0, 2, 2), nullptr, now));
}

}  // namespace
}  // namespace robotlink::arcos
