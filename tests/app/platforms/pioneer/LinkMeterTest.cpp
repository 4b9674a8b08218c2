// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/LinkMeter.h"

#include <gtest/gtest.h>

#include <array>

using app::LinkMeter;
using robotlink::Instant;
using std::chrono::milliseconds;

namespace {

/// Its frame has ten bytes.
const robotlink::arcos::Packet kPacket{11, {0x3B, 1, 2, 3}};
const std::array<std::uint8_t, 10> kBytes{};

robotcontrol::LinkStatus statusOf(LinkMeter& meter, Instant now) {
  robotcontrol::LinkStatus status;
  meter.fill(status, now);
  return status;
}

}  // namespace

TEST(LinkMeterTest, ratesAndGapsAreThoseOfTheLastSeconds) {
  LinkMeter meter;
  Instant now;
  for (int i = 0; i < 100; ++i) {
    now += milliseconds(i == 90 ? 400 : 100);
    meter.packet(true, kPacket, kBytes, now);
    meter.cycle(now);
    if (i % 2 == 0) meter.packet(false, kPacket, {}, now);
  }
  const auto status = statusOf(meter, now);
  EXPECT_NEAR(status.packets_per_second(), 9.5, 1);
  EXPECT_NEAR(status.bytes_per_second(), 95, 10);
  EXPECT_NEAR(status.commands_per_second(), 4.8, 1);
  EXPECT_NEAR(status.longest_gap(), 0.4, 1e-9);
  EXPECT_EQ(status.packets(), 100U);
  EXPECT_NEAR(statusOf(meter, now + std::chrono::seconds(10)).packets_per_second(), 0, 1e-9);
}

TEST(LinkMeterTest, silenceIsAGapUntilTheConnectionBeginsAnew) {
  LinkMeter meter;
  meter.cycle(Instant(milliseconds(100)));
  EXPECT_NEAR(statusOf(meter, Instant(milliseconds(1100))).longest_gap(), 1.0, 1e-9);
  meter.restart();
  EXPECT_EQ(statusOf(meter, Instant(milliseconds(2000))).longest_gap(), 0);
}

TEST(LinkMeterTest, aFloodOfCyclesIsNotRememberedForEver) {
  LinkMeter meter;
  meter.cycle({});
  meter.cycle(Instant(milliseconds(500)));
  EXPECT_NEAR(statusOf(meter, Instant(milliseconds(500))).longest_gap(), 0.5, 1e-9);
  for (int i = 0; i < 20000; ++i) meter.cycle(Instant(milliseconds(500)));
  EXPECT_EQ(statusOf(meter, Instant(milliseconds(500))).longest_gap(), 0);
}

TEST(LinkMeterTest, packetsAreKeptOnlyWhileSomebodyWantsThemAndNeverTooMany) {
  LinkMeter meter;
  meter.packet(true, kPacket, kBytes, {});
  EXPECT_EQ(meter.takePackets({}), nullptr);
  meter.setKeeping(true);
  for (int i = 0; i < 3000; ++i) meter.packet(i % 2 == 0, kPacket, kBytes, {});
  meter.damage(kBytes, {});
  const auto packets = meter.takePackets({});
  ASSERT_NE(packets, nullptr);
  EXPECT_EQ(packets->packets_size(), 2000);
  EXPECT_EQ(packets->dropped(), 1001U);
  EXPECT_TRUE(packets->packets(0).from_robot());
  EXPECT_FALSE(packets->packets(1).from_robot());
  EXPECT_EQ(meter.takePackets({}), nullptr);
}

TEST(LinkMeterTest, packetsAreKeptWithTheBytesThatTheyHadOrWouldHave) {
  LinkMeter meter;
  meter.setKeeping(true);
  meter.packet(true, kPacket, kBytes, {});
  meter.packet(false, kPacket, {}, {});
  const auto packets = meter.takePackets({});
  ASSERT_EQ(packets->packets_size(), 2);
  EXPECT_EQ(packets->packets(0).bytes(), std::string(10, '\0'));
  const auto frame = robotlink::arcos::encode(kPacket);
  EXPECT_EQ(packets->packets(1).bytes(), std::string(frame.begin(), frame.end()));
}

TEST(LinkMeterTest, whatWasDroppedCountsForItsConnectionOnly) {
  LinkMeter meter;
  meter.setKeeping(true);
  for (int i = 0; i < 2001; ++i) meter.packet(true, kPacket, kBytes, {});
  EXPECT_EQ(meter.takePackets({})->dropped(), 1U);
  meter.packet(true, kPacket, kBytes, {});
  EXPECT_EQ(meter.takePackets({})->dropped(), 1U) << "in all";
  meter.restart();
  meter.packet(true, kPacket, kBytes, {});
  EXPECT_EQ(meter.takePackets({})->dropped(), 0U);
}
