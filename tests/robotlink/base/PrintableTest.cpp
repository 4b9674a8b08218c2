// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Printable.h"

#include <gtest/gtest.h>

namespace robotlink {
namespace {

TEST(Printable, whatPeopleWriteStaysAsItIs) {
  for (const char* text : {"", "red1", "M\xC3\xBCnchen \xC2\xA0 \xE2\x82\xAC"}) {
    EXPECT_EQ(printable(text), text);
    EXPECT_EQ(printableLines(text), text);
  }
}

TEST(Printable, controlCharactersDoNothingToATerminal) {
  EXPECT_EQ(printable("a\x1B[2Jb\x07\x7F"), "a?[2Jb??");
  EXPECT_EQ(printable("a\xC2\x9B"
                      "2Jb"),
            "a?2Jb")
      << "the same, as one character";
  EXPECT_EQ(printable("a\x9B\xC2"), "a??") << "no UTF-8";
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
}

TEST(Printable, aLineIsOneAndLinesAreIndented) {
  EXPECT_EQ(printable("a\r\nb\tc"), "a  b c");
  EXPECT_EQ(printableLines("a\nb\tc\x1B"), "a\nb\tc?");
  EXPECT_EQ(printableLines("a\nb", "  "), "a\n  b");
}

TEST(Printable, markupShowsTheTextThatItWasMadeOf) {
  EXPECT_EQ(escapedMarkup("x < 3 && \"y\" > z\n"), "x &lt; 3 &amp;&amp; &quot;y&quot; &gt; z&#10;");
  EXPECT_EQ(escapedMarkup("&amp;"), "&amp;amp;");
}

}  // namespace
}  // namespace robotlink
