// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/TextParts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace robotlink {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) lines.emplace_back(takeLine(text));
  return lines;
}

TEST(TextParts, linesComeWithoutTheirEnds) {
  EXPECT_EQ(linesOf("one\ntwo"), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(linesOf("\n\nthree\r\n"), (std::vector<std::string>{"", "", "three\r"}));
}

TEST(TextParts, aLineBreakAtTheEndBeginsNoLine) {
  EXPECT_EQ(linesOf("one\n"), (std::vector<std::string>{"one"}));
  EXPECT_EQ(linesOf(""), std::vector<std::string>{});
}

TEST(TextParts, aListContainsOnlyWholeTexts) {
  const std::vector<std::string> texts{"red1", "red2"};
  EXPECT_TRUE(contains(texts, "red2"));
  EXPECT_FALSE(contains(texts, "red"));
  EXPECT_FALSE(contains({}, ""));
}

TEST(TextParts, aPartEndsAtItsSeparatorOrWithTheText) {
  std::string_view text = "red1, red2";
  EXPECT_EQ(takePart(text, ','), "red1");
  EXPECT_EQ(text, " red2");
  EXPECT_EQ(takePart(text, ','), " red2");
  EXPECT_EQ(text, "");
  EXPECT_EQ(takePart(text, ','), "");
}

TEST(TextParts, blanksAtTheEndsAreNoneOfAText) {
  EXPECT_EQ(trimmed(" \tred 1 \r"), "red 1");
  EXPECT_EQ(trimmed(" \t\r"), "");
  EXPECT_EQ(trimmed(""), "");
}

TEST(TextParts, partsAreJoinedByASeparator) {
  EXPECT_EQ(joined(std::vector<std::string>{"a", "", "b"}), "a, , b");
  EXPECT_EQ(joined(std::vector<std::string_view>{"", "a"}, "\n"), "\na");
  EXPECT_EQ(joined(std::vector<std::string>{}), "");
}

}  // namespace
}  // namespace robotlink
