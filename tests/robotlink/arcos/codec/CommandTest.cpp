// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "robotlink/arcos/codec/ArcosCommandCatalog.h"
#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

std::string encoded(const Command& command) {
  return toHex(encode(toPacket(command)));
}

std::string hex(std::string_view text) {
  return toHex(hexBytes(text));
}

Command decoded(std::uint8_t id, std::string_view data) {
  const auto command = toCommand({id, hexBytes(data)});
  EXPECT_TRUE(command);
  return command.value_or(Command{});
}

TEST(CommandTest, whatRealClientsSentIsSentAlike) {
  EXPECT_EQ(encoded(command(CommandId::kPulse)), hex("FA FB 03 00 00 00"));
  EXPECT_EQ(encoded(command(CommandId::kSync1)), hex("FA FB 03 01 00 01"));
  EXPECT_EQ(encoded(command(CommandId::kSync2)), hex("FA FB 03 02 00 02"));
  EXPECT_EQ(encoded(command(CommandId::kVel, 250)), hex("FA FB 06 0B 3B FA 00 05 3B"));
  EXPECT_EQ(encoded(command(CommandId::kMove, -500)), hex("FA FB 06 08 1B F4 01 FC 1C"));
  EXPECT_EQ(encoded(command(CommandId::kRvel, 10)), hex("FA FB 06 15 3B 0A 00 1F 3B"));
  EXPECT_EQ(encoded(command(CommandId::kVel2, joined({-5, 5}))), hex("FA FB 06 20 1B FB 04 1B 1F"));
  EXPECT_EQ(encoded(command(CommandId::kSimMessage, "hello")),
            hex("FA FB 0B EE 2B 05 68 65 6C 6C 6F 00 C5 6E"));
  // The manual's example of DIGOUT.
  EXPECT_EQ(encode({30, {27, 25, 9}}), (Bytes{250, 251, 6, 30, 27, 25, 9, 55, 36}));
}

TEST(CommandTest, integersComeWithTheirSign) {
  EXPECT_EQ(integerArgument(decoded(8, "1B F4 01")), -500);
  EXPECT_EQ(integerArgument(decoded(11, "3B FA 00")), 250);
  EXPECT_EQ(integerArgument(decoded(11, "3B FF FF")), 65535);
  EXPECT_EQ(split(integerArgument(decoded(32, "1B FB 04"))), (BytePair{-5, 5}));
  for (int high = -128; high < 128; high += 17) {
    for (int low = -128; low < 128; low += 5) {
      const BytePair pair{static_cast<std::int8_t>(high), static_cast<std::int8_t>(low)};
      const auto back = toCommand(toPacket(command(CommandId::kVel2, joined(pair))));
      ASSERT_TRUE(back);
      EXPECT_EQ(split(integerArgument(*back)), pair);
    }
  }
}

TEST(CommandTest, missingArgumentsAreZeroOrWhatARequestMeans) {
  EXPECT_EQ(decoded(18, ""), command(CommandId::kConfig));
  EXPECT_EQ(integerArgument(decoded(18, ""), 1), 1);
  EXPECT_EQ(integerArgument(decoded(4, "")), 0);
  EXPECT_EQ(integerArgument(decoded(4, "3B"), 1), 0);
  EXPECT_EQ(integerArgument(decoded(4, "3B 07"), 1), 7);
}

TEST(CommandTest, stringsComeInEveryFormThatClientsUse) {
  EXPECT_EQ(stringArgument(decoded(238, "2B 05 68656C6C6F 00")), "hello");  // length and NUL
  EXPECT_EQ(stringArgument(decoded(238, "2B 05 68656C6C6F")), "hello");     // length alone
  EXPECT_EQ(stringArgument(decoded(238, "2B 68656C6C6F 00")), "hello");     // NUL alone
  EXPECT_EQ(stringArgument(decoded(238, "2B 68656C6C6F")), "hello");        // neither
  EXPECT_EQ(stringArgument(decoded(238, "2B")), "");
  EXPECT_EQ(stringArgument(decoded(3, "2B 03 00 01 02 00")), std::string("\0\1\2", 3));
  const Command tail = decoded(238, "2B 02 6162 00 0708");
  EXPECT_EQ(tail.extra, (Bytes{7, 8}));
}

TEST(CommandTest, dataOfUnknownFormIsKept) {
  const Command command = decoded(224, "00 E8030000 00000000 00000000");
  EXPECT_EQ(command.argument.index(), 0U);
  EXPECT_EQ(command.extra.size(), 13U);
  EXPECT_EQ(encoded(command), hex("FA FB 10 E0 00 E8030000 00000000 00000000 C8 03"));
  const Command laser = decoded(230, "3B 02 00 01");
  EXPECT_EQ(integerArgument(laser), 2);
  EXPECT_EQ(laser.extra, (Bytes{1}));
}

TEST(CommandTest, argumentsThatDoNotFitAreReported) {
  EXPECT_TRUE(check(command(CommandId::kVel, -65535)));
  const auto large = check(command(CommandId::kVel, 70000));
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().text, "the argument of VEL is 70000; it must be between -65535 and 65535");
  EXPECT_EQ(integerArgument(*toCommand(toPacket(command(CommandId::kVel, 70000)))), 65535);

  EXPECT_TRUE(check(command(CommandId::kTty2, std::string(kMaxSentString, 'x'))));
  EXPECT_FALSE(check(command(CommandId::kTty2, std::string(kMaxSentString + 1, 'x'))));
  EXPECT_FALSE(check(command(CommandId::kTty2, std::string(5000, 'x'))));
  EXPECT_FALSE(check(Command{1, {}, Bytes(5000, 1)}));
  EXPECT_FALSE(encode(toPacket(command(CommandId::kTty2, std::string(5000, 'x')))).empty());
  EXPECT_FALSE(encode(toPacket(Command{1, std::string(200, 'x'), Bytes(5000, 1)})).empty());
  Bytes endless(kMaxData, 0xFF);
  endless[0] = 0x2B;
  EXPECT_FALSE(toCommand({42, endless}));
}

TEST(CommandTest, theTableNamesEveryCommandOnce) {
  std::set<int> numbers;
  std::set<std::string> names;
  for (const CommandInfo& info : commandCatalog()) {
    EXPECT_TRUE(numbers.insert(info.id).second) << info.name;
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
    EXPECT_EQ(findCommand(info.id), &info);
    EXPECT_EQ(std::string_view(info.summary).back(), '.') << info.name;
  }
  EXPECT_EQ(nameOf(32), "VEL2");
  EXPECT_EQ(nameOf(111), "command 111");
  EXPECT_EQ(findCommand(std::uint8_t{111}), nullptr);
}

}  // namespace
}  // namespace robotlink::arcos
