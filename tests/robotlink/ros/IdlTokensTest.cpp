// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/IdlTokens.h"

#include <gmock/gmock.h>

namespace robotlink::ros {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> tokensOf(std::string_view text) {
  std::vector<std::string> tokens;
  for (IdlTokens rest(text); !rest.current().empty();) tokens.emplace_back(rest.take());
  return tokens;
}

TEST(IdlTokens, wordsAndSymbolsAreTold) {
  EXPECT_THAT(tokensOf("module std_msgs { struct A { sequence<uint8, 4> data; }; };"),
              ElementsAre("module", "std_msgs", "{", "struct", "A", "{", "sequence", "<", "uint8", ",", "4",
                          ">", "data", ";", "}", ";", "}", ";"));
  EXPECT_THAT(tokensOf("std_msgs::msg::Header h"), ElementsAre("std_msgs::msg::Header", "h"));
  EXPECT_THAT(tokensOf("const double x=-1.5e+3;"), ElementsAre("const", "double", "x", "=", "-1.5e+3", ";"));
}

TEST(IdlTokens, aTextIsOneTokenWithItsQuotes) {
  EXPECT_THAT(tokensOf(R"(@unit(value="m // s"))"),
              ElementsAre("@", "unit", "(", "value", "=", "\"m // s\"", ")"));
  EXPECT_THAT(tokensOf(R"("a \" b" c)"), ElementsAre(R"("a \" b")", "c"));
  EXPECT_THAT(tokensOf("\"never closed"), ElementsAre("\"never closed"));
  EXPECT_THAT(tokensOf("\"ends in \\"), ElementsAre("\"ends in \\"));
}

TEST(IdlTokens, whatIsNoDefinitionIsLeftOut) {
  EXPECT_THAT(tokensOf("a // b c\nd"), ElementsAre("a", "d"));
  EXPECT_THAT(tokensOf("a /* b\n c */ d"), ElementsAre("a", "d"));
  EXPECT_THAT(tokensOf("a /* never closed"), ElementsAre("a"));
  EXPECT_THAT(tokensOf("#include \"x.idl\"\n  #pragma once\nb"), ElementsAre("b"));
  EXPECT_THAT(tokensOf("=====\nIDL: a/msg/B\nstruct"), ElementsAre("struct"));
  // These begin a line there; elsewhere they are what they look like.
  EXPECT_THAT(tokensOf("x == y"), ElementsAre("x", "=", "=", "y"));
  EXPECT_THAT(tokensOf(" \n\t "), IsEmpty());
}

TEST(IdlTokens, linesAreCounted) {
  IdlTokens tokens("a\n/* b\n\n */ c\n// d\ne");
  EXPECT_EQ(tokens.line(), 1);
  tokens.take();
  EXPECT_EQ(tokens.line(), 4);
  tokens.take();
  EXPECT_EQ(tokens.current(), "e");
  EXPECT_EQ(tokens.line(), 6);
}

TEST(IdlTokens, onlyTheTokenThatIsMeantIsTaken) {
  IdlTokens tokens("struct A");
  EXPECT_FALSE(tokens.take("module"));
  EXPECT_TRUE(tokens.take("struct"));
  EXPECT_EQ(tokens.take(), "A");
  EXPECT_EQ(tokens.take(), "");
  EXPECT_FALSE(tokens.take("A"));
}

}  // namespace
}  // namespace robotlink::ros
