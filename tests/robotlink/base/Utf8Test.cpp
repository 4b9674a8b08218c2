// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Utf8.h"

#include <gtest/gtest.h>

namespace robotlink {
namespace {

TEST(Utf8, textThatIsValidStaysAsItIs) {
  for (const char* text :
       {"", "plain", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEF\xBF\xBF",
        "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "M\xC3\xBCnchen \xE2\x82\xAC"}) {
    EXPECT_EQ(validUtf8(text), text);
  }
}

TEST(Utf8, everyByteThatIsNotPartOfACharacterIsReplaced) {
  EXPECT_EQ(validUtf8("a\x80z"), "a?z") << "a continuation without a start";
  EXPECT_EQ(validUtf8("\xC3z"), "?z") << "a start without its continuation";
  EXPECT_EQ(validUtf8("\xE2\x82"), "??") << "the text ends within a character";
  EXPECT_EQ(validUtf8("\xF5\xFF"), "??") << "no byte of UTF-8";
}

TEST(Utf8, longerFormsThanNecessaryAndValuesThatAreNoneAreReplaced) {
  EXPECT_EQ(validUtf8("\xC0\xAF"), "??") << "a slash in two bytes";
  EXPECT_EQ(validUtf8("\xE0\x9F\xBF"), "???");
  EXPECT_EQ(validUtf8("\xF0\x8F\xBF\xBF"), "????");
  EXPECT_EQ(validUtf8("\xED\xA0\x80"), "???") << "half of a surrogate pair";
  EXPECT_EQ(validUtf8("\xF4\x90\x80\x80"), "????") << "beyond the last character";
}

}  // namespace
}  // namespace robotlink
