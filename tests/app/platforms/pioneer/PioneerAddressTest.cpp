// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerAddress.h"

#include <gtest/gtest.h>

using namespace app;
namespace arcos = robotlink::arcos;

namespace {

std::string problemOf(const std::string& text) {
  const auto address = PioneerAddress::parse(text);
  return address ? "" : address.error().text;
}

}  // namespace

TEST(PioneerAddress, isALineWithOptions) {
  const auto plain = PioneerAddress::parse("localhost:8101");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->kind, "p3at");
  EXPECT_FALSE(plain->laser);
  EXPECT_EQ(plain->text(), "tcp://localhost:8101");

  const auto full = PioneerAddress::parse(
      "serial:///dev/ttyUSB0?baud=38400&robot=p3dx&laser-step=0.5&laser-unit=mm&laser=/dev/ttyUSB1");
  ASSERT_TRUE(full) << full.error().text;
  EXPECT_EQ(full->line, arcos::StreamUrl(arcos::SerialAddress{"/dev/ttyUSB0", 38400}));
  EXPECT_EQ(full->kind, "p3dx");
  ASSERT_TRUE(full->laser);
  EXPECT_EQ(*full->laser, arcos::StreamUrl(arcos::SerialAddress{"/dev/ttyUSB1", 38400}));
  EXPECT_TRUE(full->scans.halfDegrees);
  EXPECT_EQ(full->scans.unit, arcos::SickSession::Unit::kMillimeters);
  EXPECT_EQ(full->scans.baud, 38400);
}

TEST(PioneerAddress, theLaserHasASpeedOfItsOwn) {
  const auto address = PioneerAddress::parse("tcp://robot:8101?laser=serial:///dev/ttyUSB1?baud=9600");
  ASSERT_TRUE(address) << address.error().text;
  EXPECT_EQ(address->scans.baud, 9600);
  EXPECT_FALSE(address->scans.fixedSpeed);
  const auto network = PioneerAddress::parse("tcp://robot:8101?laser=tcp://robot:8102");
  ASSERT_TRUE(network) << network.error().text;
  EXPECT_TRUE(network->scans.fixedSpeed);
}

TEST(PioneerAddress, itsTextIsReadAsTheSame) {
  for (const char* text :
       {"tcp://[::1]:8101", "serial:///dev/ttyS0?baud=9600", "tcp://robot:8101?robot=peoplebot",
        "serial:///dev/ttyS0?baud=9600&robot=p3dx&laser-step=0.5&laser=serial:///dev/ttyS1?baud=19200",
        "tcp://robot:8101?laser-unit=mm&laser=tcp://robot:8102"}) {
    const auto address = PioneerAddress::parse(text);
    ASSERT_TRUE(address) << address.error().text;
    EXPECT_EQ(address->text(), text);
  }
}

TEST(PioneerAddress, whatIsWrongIsSaid) {
  EXPECT_NE(problemOf("tcp://robot:8101?speed=3").find("its options are baud, robot"), std::string::npos);
  EXPECT_NE(problemOf("tcp://robot:8101?robot=../x").find("a kind of robot"), std::string::npos);
  EXPECT_NE(problemOf("tcp://robot:8101?laser-step=2").find("laser-step is 1 or 0.5"), std::string::npos);
  EXPECT_NE(problemOf("tcp://robot:8101?laser-unit=m").find("laser-unit is cm or mm"), std::string::npos);
  EXPECT_NE(problemOf("/dev/ttyS0?laser=/dev/ttyS1?baud=115200").find("one of 9600, 19200, 38400 baud"),
            std::string::npos);
  EXPECT_NE(problemOf("tcp://robot:8101?laser=here").find("'here' is not"), std::string::npos);
  EXPECT_NE(problemOf("/dev/ttyS0?baud=38400&laser=/dev/ttyS0").find("at a line of its own"),
            std::string::npos);
  EXPECT_NE(problemOf("tcp://robot:8101?laser="), "");
  EXPECT_NE(problemOf("?"), "");
}
