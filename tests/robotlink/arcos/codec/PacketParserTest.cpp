// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/PacketParser.h"

#include <gtest/gtest.h>

#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

const Packet kVelocity{11, {0x3B, 0xFA, 0x00}};
const Packet kPulse{0, {}};

Bytes operator+(Bytes left, const Bytes& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

/// "11 0" for two packets, "[no packet: 0102]" for damage.
std::string findAll(PacketParser& parser) {
  std::string text;
  while (const auto found = parser.next()) {
    if (!text.empty()) text += ' ';
    if (const auto* packet = std::get_if<Packet>(&*found)) {
      text += std::to_string(packet->id);
    } else {
      const auto& damage = std::get<DamagedBytes>(*found);
      text += std::string("[") + describe(damage.kind) + ": " + toHex(damage.bytes) + "]";
    }
  }
  return text;
}

std::string findAll(const Bytes& bytes) {
  PacketParser parser;
  parser.push(bytes);
  return findAll(parser);
}

TEST(PacketParserTest, aPacketComesByteByByte) {
  PacketParser parser;
  const Bytes bytes = encode(kVelocity);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_FALSE(parser.next());
    parser.push(std::span(bytes).subspan(i, 1));
    EXPECT_TRUE(parser.isPartial());
  }
  const auto found = parser.next();
  ASSERT_TRUE(found);
  EXPECT_EQ(std::get<Packet>(*found), kVelocity);
  EXPECT_FALSE(parser.isPartial());
  EXPECT_EQ(parser.counters(), (PacketParser::Counters{1, 0, 0}));
}

TEST(PacketParserTest, severalPacketsComeAtOnce) {
  EXPECT_EQ(findAll(encode(kVelocity) + encode(kPulse) + encode(kVelocity)), "11 0 11");
}

TEST(PacketParserTest, garbageIsSkipped) {
  // What some clients write to a radio modem first.
  EXPECT_EQ(findAll(hexBytes("574D53320D") + encode(kPulse)), "[no packet: 574d53320d] 0");
  EXPECT_EQ(findAll(hexBytes("FA FA") + encode(kPulse) + hexBytes("FB") + encode(kPulse)),
            "[no packet: fafa] 0 [no packet: fb] 0");
}

TEST(PacketParserTest, aWrongChecksumCostsOnePacket) {
  Bytes damaged = encode(kVelocity);
  damaged[5] ^= 0x10U;
  PacketParser parser;
  parser.push(damaged + encode(kPulse));
  EXPECT_EQ(findAll(parser), "[wrong checksum: fafb060b3bea00053b] 0");
  EXPECT_EQ(parser.counters(), (PacketParser::Counters{1, 1, 9}));
}

TEST(PacketParserTest, impossibleCountsAreNoPackets) {
  for (const char* count : {"00", "02", "FA", "FF"}) {
    EXPECT_EQ(findAll(hexBytes(std::string("FA FB ") + count) + encode(kPulse)),
              "[impossible length: fafb" + toHex(hexBytes(count)) + "] 0");
  }
  EXPECT_EQ(findAll(hexBytes("FA FB FA FB 03 00 00 00")), "[impossible length: fafb] 0");
}

TEST(PacketParserTest, aLyingCountCostsNoPacketsBehindIt) {
  Bytes lying = encode(kVelocity);
  lying[2] = 20;
  EXPECT_EQ(findAll(lying + encode(kPulse) + encode(kVelocity) + encode(kPulse)),
            "[wrong checksum: fafb140b3bfa00053b] 0 11 0");
}

TEST(PacketParserTest, silenceEndsAPacket) {
  PacketParser parser;
  const Bytes beginning = {0xFA, 0xFB, 0x20, 0x01, 0x02};
  parser.push(beginning + encode(kPulse));
  EXPECT_EQ(findAll(parser), "");
  parser.dropPartial();
  EXPECT_EQ(findAll(parser), "[end of packet missing: fafb200102] 0");
  EXPECT_FALSE(parser.isPartial());

  // What comes after the silence is not given up.
  parser.push(beginning);
  parser.dropPartial();
  parser.push(std::span(beginning).first(4));
  EXPECT_EQ(findAll(parser), "[end of packet missing: fafb200102]");
  EXPECT_TRUE(parser.isPartial());
}

TEST(PacketParserTest, everyByteIsInOnePacketOrDamage) {
  Bytes all;
  for (unsigned i = 0; i < 20000; ++i) {
    all.push_back(static_cast<std::uint8_t>(i * i * 2654435761U >> 13U));
    if (i % 97 == 0) all = all + encode(kVelocity);
    if (i % 211 == 0) all = all + Bytes{0xFA, 0xFB};
  }
  PacketParser parser;
  Bytes back;
  std::size_t packets = 0;
  const auto drain = [&] {
    while (const auto found = parser.next()) {
      const auto* packet = std::get_if<Packet>(&*found);
      back = back + (packet ? encode(*packet) : std::get<DamagedBytes>(*found).bytes);
      packets += packet ? 1U : 0U;
    }
  };
  for (std::size_t i = 0; i < all.size(); i += 13) {
    parser.push(std::span(all).subspan(i, std::min<std::size_t>(13, all.size() - i)));
    drain();
  }
  parser.dropPartial();
  drain();
  EXPECT_EQ(back, all);
  EXPECT_EQ(packets, 207U);
  EXPECT_EQ(parser.counters().skippedBytes, all.size() - 207 * 9);
}

TEST(PacketParserTest, aFloodThatNobodyReadsIsBounded) {
  PacketParser parser;
  const Bytes flood(10000, 0x55);
  for (int i = 0; i < 20; ++i) parser.push(flood);
  EXPECT_EQ(parser.counters().skippedBytes, 200000 - PacketParser::kMaxBuffered);
  parser.push(encode(kPulse));
  while (const auto found = parser.next()) {
    const auto* damage = std::get_if<DamagedBytes>(&*found);
    EXPECT_TRUE(!damage || damage->bytes.size() <= 256U);
  }
  EXPECT_EQ(parser.counters(), (PacketParser::Counters{1, 0, 200000}));
  parser.push(flood);
  parser.clear();
  EXPECT_FALSE(parser.isPartial());
}

}  // namespace
}  // namespace robotlink::arcos
