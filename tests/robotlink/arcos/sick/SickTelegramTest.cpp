// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/sick/SickTelegram.h"

#include <gtest/gtest.h>

#include "robotlink/base/Geometry.h"

using namespace robotlink::arcos;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// All that is found in bytes that come in pieces.
std::vector<SickTelegram> telegramsIn(SickParser& parser, const Bytes& bytes, std::size_t piece) {
  std::vector<SickTelegram> result;
  for (std::size_t at = 0; at < bytes.size(); at += piece) {
    parser.push(std::span(bytes).subspan(at, std::min(piece, bytes.size() - at)));
    while (const auto found = parser.next()) {
      if (const auto* telegram = std::get_if<SickTelegram>(&*found)) result.push_back(*telegram);
    }
  }
  return result;
}

SickTelegram measured(unsigned head, const std::vector<unsigned>& values) {
  SickTelegram telegram{.command = 0xB0, .data = {}};
  const auto add = [&](unsigned value) {
    telegram.data.push_back(static_cast<std::uint8_t>(value & 0xFFU));
    telegram.data.push_back(static_cast<std::uint8_t>(value >> 8U));
  };
  add(head);
  for (const unsigned value : values) add(value);
  return telegram;
}

}  // namespace

TEST(SickTelegram, bytesAreThoseThatTheDescriptionOfTheLaserPrints) {
  EXPECT_EQ(sickRequest({.command = 0x20, .data = {0x24}}), (Bytes{2, 0, 2, 0, 0x20, 0x24, 0x34, 8}));
  EXPECT_EQ(sickRequest({.command = 0x20, .data = {0x25}}), (Bytes{2, 0, 2, 0, 0x20, 0x25, 0x35, 8}));
  EXPECT_EQ(sickRequest({.command = 0x20, .data = {0x40}}), (Bytes{2, 0, 2, 0, 0x20, 0x40, 0x50, 8}));
  EXPECT_EQ(sickRequest({.command = 0x30, .data = {0x01}}), (Bytes{2, 0, 2, 0, 0x30, 1, 0x31, 0x18}));
  EXPECT_EQ(sickRequest({.command = 0x20, .data = {0, 'S', 'I', 'C', 'K', '_', 'L', 'M', 'S'}}),
            (Bytes{2, 0, 10, 0, 0x20, 0, 'S', 'I', 'C', 'K', '_', 'L', 'M', 'S', 0xBE, 0xC5}));
  EXPECT_EQ(sickRequest({.command = 0x3B, .data = {0xB4, 0, 0x64, 0}}),
            (Bytes{2, 0, 5, 0, 0x3B, 0xB4, 0, 0x64, 0, 0x97, 0x49}));
}

TEST(SickParser, findsTelegramsHoweverTheyAreSplit) {
  const SickTelegram a{.command = 0xA0, .data = {0}, .status = 0x10}, b = measured(3, {100, 200, 300});
  Bytes bytes{0x06};
  for (const auto& telegram : {a, b, a}) {
    const Bytes one = sickReply(telegram);
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  for (const std::size_t piece : {1U, 2U, 7U, 1000U}) {
    SickParser parser;
    EXPECT_EQ(telegramsIn(parser, bytes, piece), (std::vector{a, b, a})) << piece;
    EXPECT_EQ(parser.counters(), (SickParser::Counters{3, 0, 0}));
  }
}

TEST(SickParser, aLostByteOrAWrongChecksumCostsOnlyThatTelegram) {
  const SickTelegram scan = measured(3, {100, 200, 300}), answer{.command = 0xA0, .data = {0}};
  const Bytes first = sickReply(scan), second = sickReply(answer);
  for (std::size_t lost = 0; lost < first.size(); ++lost) {
    Bytes bytes = first;
    bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(lost));
    bytes.insert(bytes.end(), second.begin(), second.end());
    // What follows, so that a length that is too large is noticed.
    for (int i = 0; i < 60; ++i) bytes.insert(bytes.end(), second.begin(), second.end());
    SickParser parser;
    const auto found = telegramsIn(parser, bytes, 5);
    EXPECT_GE(found.size(), 60U) << lost;
    EXPECT_EQ(std::ranges::count(found, scan), 0) << lost;
  }
  Bytes wrong = first;
  wrong[10] ^= 0x20U;
  wrong.insert(wrong.end(), second.begin(), second.end());
  SickParser parser;
  EXPECT_EQ(telegramsIn(parser, wrong, 3), std::vector{answer});
  EXPECT_EQ(parser.counters().checksumErrors, 1U);
}

TEST(SickParser, keepsABoundedNumberOfBytes) {
  SickParser parser;
  const Bytes noise(1 << 20, 0x55);
  parser.push(noise);
  EXPECT_FALSE(parser.next());
  EXPECT_EQ(parser.counters().skippedBytes, noise.size());
}

TEST(SickReadings, areInMetersFromRightToLeft) {
  const auto cm = sickReadings(measured(3, {100, 0xE000U | 250U, 8191}), 13);
  ASSERT_TRUE(cm);
  EXPECT_EQ(cm->startAngle, -0.5 * robotlink::kPi);
  EXPECT_EQ(cm->angleStep, 0.5 * robotlink::kPi);
  EXPECT_EQ(cm->ranges, (std::vector{1.0, 2.5, 0.0})) << "flags are no distance, and 8191 is none";
  const auto mm = sickReadings(measured(0x4000U | 2U, {20'000, 32'760}), 15);
  ASSERT_TRUE(mm);
  EXPECT_EQ(mm->ranges, (std::vector{20.0, 0.0}));
}

TEST(SickReadings, whatIsNoWholeScanIsNone) {
  EXPECT_FALSE(sickReadings(measured(4, {1, 2, 3}), 13)) << "a value is missing";
  EXPECT_FALSE(sickReadings(measured(0x2000U | 2U, {1, 2}), 13)) << "a part of a scan";
  EXPECT_FALSE(sickReadings(measured(1, {1}), 13));
  EXPECT_FALSE(sickReadings(measured(0xC000U | 2U, {1, 2}), 13)) << "an unknown unit";
  EXPECT_FALSE(sickReadings({.command = 0xB0, .data = {1}}, 13));
  EXPECT_FALSE(sickReadings({.command = 0xA0, .data = {2, 0, 0, 0, 0, 0}}, 13));
}
