// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/AuxiliarySerial.h"

#include <gtest/gtest.h>

namespace robotlink::arcos {
namespace {

std::string textOfPacket(const AuxSerialPacket& packet) {
  return {packet.bytes.begin(), packet.bytes.end()};
}

TEST(AuxiliarySerial, sendsAsManyBytesAsWereAskedForOnceTheyAreThere) {
  AuxiliarySerial line;
  line.receive("abc");
  EXPECT_FALSE(line.take()) << "nobody asked";
  line.ask(5);
  EXPECT_FALSE(line.take());
  line.receive("defg");
  const auto packet = line.take();
  ASSERT_TRUE(packet);
  EXPECT_EQ(textOfPacket(*packet), "abcde");
  EXPECT_EQ(packet->port, 1);
  EXPECT_FALSE(line.take()) << "each request is answered once";
  line.ask(2);
  EXPECT_EQ(textOfPacket(line.take().value()), "fg");
}

TEST(AuxiliarySerial, dropsWhatIsOldAndWhatIsFlushed) {
  AuxiliarySerial line;
  line.receive(std::string(AuxiliarySerial::kMaxWaiting, 'a') + "z");
  line.ask(200);
  EXPECT_EQ(textOfPacket(line.take().value()), std::string(200, 'a'));
  line.ask(0);
  line.ask(1);
  EXPECT_FALSE(line.take()) << "flushed";
  line.receive("x");
  line.ask(-3);
  EXPECT_FALSE(line.take());
  line.receive("y");
  line.ask(1000);
  EXPECT_FALSE(line.take());
}

TEST(AuxiliarySerial, aPositionIsASentenceOfNmea) {
  // 48 degrees 7.038 minutes north, 11 degrees 31 minutes east; the checksum is the exclusive or of all
  // between $ and *.
  const GlobalPosition munich{48 + 7.038 / 60, 11 + 31.0 / 60, 545.4};
  const auto time = std::chrono::hours(12) + std::chrono::minutes(35) + std::chrono::milliseconds(19250);
  const std::string text = ggaSentence(munich, time);
  EXPECT_EQ(text.substr(0, text.find('*')),
            "$GPGGA,123519.25,4807.0380,N,01131.0000,E,1,08,1.0,545.4,M,0.0,M,,");
  unsigned sum = 0;
  for (const char c : text.substr(1, text.find('*') - 1)) sum ^= static_cast<unsigned char>(c);
  EXPECT_EQ(std::stoul(text.substr(text.find('*') + 1, 2), nullptr, 16), sum);
  EXPECT_TRUE(text.ends_with("\r\n"));
}

TEST(AuxiliarySerial, minutesAreNeverSixtyAndWestAndSouthAreNamed) {
  const std::string text = ggaSentence({-33.99999999999, -0.5, -1}, std::chrono::hours(25));
  EXPECT_EQ(text.substr(0, text.find(",1,08")), "$GPGGA,010000.00,3400.0000,S,00030.0000,W");
}

}  // namespace
}  // namespace robotlink::arcos
