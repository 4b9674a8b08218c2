// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/LaserService.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "robotlink/arcos/codec/LaserPacket.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A laser of five readings, from -90 to 90 degrees, that sees 8 m.
class LaserServiceTest : public testing::Test {
 protected:
  bool obey(CommandId id, int argument) { return laser_.obey(command(id, argument)); }
  /// The ranges of a scan, mm.
  std::vector<int> scan(const std::vector<double>& ranges) const {
    std::vector<int> readings;
    for (const Packet& packet : laser_.packets(ranges, {}, false)) {
      const auto part = decode<LaserPacket>(packet);
      EXPECT_TRUE(part);
      if (!part) continue;
      EXPECT_EQ(part->first, readings.size());
      EXPECT_EQ(int{part->total}, laser_.readings());
      for (const auto& reading : part->readings) readings.push_back(reading.rangeMm);
    }
    return readings;
  }

  static ServerSettings::Laser device() {
    ServerSettings::Laser device;
    device.maximum = 8;
    return device;
  }
  LaserService laser_{device()};
};

TEST_F(LaserServiceTest, itIsOffUntilItIsSwitchedOn) {
  EXPECT_FALSE(laser_.isOn());
  EXPECT_THAT(scan({1, 2, 3}), IsEmpty());
  EXPECT_TRUE(obey(CommandId::kSimLaserEnable, 1));
  EXPECT_TRUE(laser_.isOn());
  EXPECT_EQ(laser_.readings(), 181);
  EXPECT_TRUE(obey(CommandId::kSimLaserEnable, 0));
  EXPECT_FALSE(laser_.isOn());
}

TEST_F(LaserServiceTest, aCoarseScanHasTheNearestReadingOfTheDevice) {
  obey(CommandId::kSimLaserEnable, 1);
  obey(CommandId::kSimLaserResolution, 4500);
  EXPECT_THAT(scan({1, 2, 3, 4, 5}), ElementsAre(1000, 2000, 3000, 4000, 5000));
  obey(CommandId::kSimLaserResolution, 3000);
  EXPECT_THAT(scan({1, 2, 3, 4, 5}), ElementsAre(1000, 2000, 2000, 3000, 4000, 4000, 5000));
  obey(CommandId::kSimLaserStart, -45);
  obey(CommandId::kSimLaserEnd, 20);
  EXPECT_THAT(scan({1, 2, 3, 4, 5}), ElementsAre(2000, 3000, 3000));
}

TEST_F(LaserServiceTest, whatHasNoEchoIsAtTheMaximum) {
  obey(CommandId::kSimLaserEnable, 1);
  obey(CommandId::kSimLaserResolution, 4500);
  EXPECT_THAT(scan({std::numeric_limits<double>::infinity(), std::nan(""), -1, 9, 8}),
              ElementsAre(8000, 8000, 0, 8000, 8000));
}

TEST_F(LaserServiceTest, aFieldOfViewStaysInThatOfTheDevice) {
  obey(CommandId::kSimLaserStart, -1000);
  obey(CommandId::kSimLaserEnd, 1000);
  EXPECT_EQ(laser_.readings(), 181);
  obey(CommandId::kSimLaserStart, 50);
  obey(CommandId::kSimLaserEnd, -50);
  EXPECT_EQ(laser_.readings(), 1) << "from right to left there is only the first";
}

TEST_F(LaserServiceTest, aResolutionHasLimits) {
  obey(CommandId::kSimLaserResolution, 1);
  EXPECT_EQ(laser_.readings(), 1801) << "a tenth of a degree";
  obey(CommandId::kSimLaserResolution, 32000);
  EXPECT_EQ(laser_.readings(), 3) << "a quarter of a turn";
  for (const int nonsense : {0, -100}) {
    EXPECT_TRUE(obey(CommandId::kSimLaserResolution, nonsense));
    EXPECT_EQ(laser_.readings(), 3) << nonsense;
  }
}

TEST_F(LaserServiceTest, anOddResolutionEndsBeforeTheEnd) {
  obey(CommandId::kSimLaserResolution, 3100);
  EXPECT_EQ(laser_.readings(), 6) << "180 / 31 is 5.8";
  obey(CommandId::kSimLaserEnd, 20);
  obey(CommandId::kSimLaserResolution, 110);
  EXPECT_EQ(laser_.readings(), 101) << "1.1 degrees divide 110, whatever is lost by rounding";
}

TEST_F(LaserServiceTest, aLongScanIsSplitWithoutGaps) {
  obey(CommandId::kSimLaserEnable, 2);
  const std::vector<Packet> packets = laser_.packets(std::vector<double>(181, 1.5), {}, true);
  ASSERT_EQ(packets.size(), 6U);
  const auto last = decode<LaserPacket>(packets.back());
  ASSERT_TRUE(last);
  EXPECT_EQ(last->first, 160);
  EXPECT_EQ(last->readings.size(), 21U);
  EXPECT_EQ(last->flags, 1) << "the robot moved";
  EXPECT_TRUE(last->extended);
}

TEST_F(LaserServiceTest, theOdometryOfAScanWrapsAround) {
  obey(CommandId::kSimLaserEnable, 1);
  const auto packets = laser_.packets(std::vector<double>{1}, {40, -1.25, radians(-30.0)}, false);
  const auto part = decode<LaserPacket>(packets.at(0));
  ASSERT_TRUE(part);
  EXPECT_EQ(part->xMm, 40000 - 65536);
  EXPECT_EQ(part->yMm, -1250);
  EXPECT_EQ(part->headingDeg, -30);
}

TEST_F(LaserServiceTest, aDeviceOfOneReadingShowsItInAllDirections) {
  obey(CommandId::kSimLaserEnable, 1);
  obey(CommandId::kSimLaserResolution, 9000);
  EXPECT_THAT(scan({2.5}), ElementsAre(2500, 2500, 2500));
  EXPECT_THAT(scan({}), IsEmpty());
}

TEST_F(LaserServiceTest, oldCommandsThatMayMeanOthersAreLeftToThese) {
  EXPECT_FALSE(obey(CommandId::kLegacyLaserEnd, 1)) << "a request of gripper packets";
  EXPECT_FALSE(obey(CommandId::kLegacyLaserEnable, 5)) << "an analog port";
  EXPECT_FALSE(obey(CommandId::kVel, 100));
  EXPECT_FALSE(laser_.isOn());
  EXPECT_TRUE(obey(CommandId::kLegacyLaserStart, 0));
  EXPECT_TRUE(obey(CommandId::kLegacyLaserEnd, 1)) << "directly behind its start it is an end";
  EXPECT_EQ(laser_.readings(), 2);
  EXPECT_FALSE(obey(CommandId::kLegacyLaserEnd, 2));
  EXPECT_EQ(laser_.readings(), 2);
}

TEST_F(LaserServiceTest, itIsRestoredWithItsWholeField) {
  obey(CommandId::kSimLaserEnable, 2);
  obey(CommandId::kSimLaserStart, 0);
  obey(CommandId::kSimLaserResolution, 200);
  obey(CommandId::kLegacyLaserStart, 0);
  laser_.restore();
  EXPECT_FALSE(laser_.isOn());
  EXPECT_EQ(laser_.readings(), 181);
  EXPECT_FALSE(obey(CommandId::kLegacyLaserEnd, 1)) << "no end follows";
}

TEST_F(LaserServiceTest, withoutALaserNothingIsForIt) {
  LaserService none(std::nullopt);
  EXPECT_FALSE(none.obey(command(CommandId::kSimLaserEnable, 1)));
  EXPECT_FALSE(none.isOn());
  EXPECT_THAT(none.packets(std::vector<double>{1}, {}, false), IsEmpty());
}

}  // namespace
}  // namespace robotlink::arcos
