// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/StrokeList.h"

#include <gtest/gtest.h>

namespace colortool {
namespace {

robotlink::Errors errorsOf(std::string_view text) {
  const auto list = parseStrokeList(text, "strokes.csv");
  return list ? robotlink::Errors{} : list.error();
}

TEST(StrokeList, isReadInAnyOrderOfColumns) {
  const auto list = parseStrokeList(
      "class,image,radius,note,x,y\r\norange,000.png,3,by hand,10.5,20\n\nbackground,\"a.png\",0,,0,239\n",
      "f");
  ASSERT_TRUE(list) << robotlink::describe(list.error());
  ASSERT_EQ(list->size(), 2U);
  EXPECT_EQ(list->front(), (DiscStroke{"000.png", "orange", 10.5, 20, 3}));
  EXPECT_EQ(list->back(), (DiscStroke{"a.png", "background", 0, 239, 0}));
}

TEST(StrokeList, allThatIsWrongIsToldWithItsPlace) {
  const auto errors = errorsOf(
      "image,class,x,y,radius\na.png,orange,ten,2,3\na.png,,1,2,3\na.png,orange,1,2,-3\na.png,orange\n");
  ASSERT_EQ(errors.size(), 4U);
  EXPECT_EQ(errors[0].describe(), "strokes.csv:2:14: 'ten' is not a number; x is expected here");
  EXPECT_EQ(errors[1].where, (robotlink::FilePosition{"strokes.csv", 3, 7}));
  EXPECT_EQ(errors[2].where.column, 18);
  EXPECT_EQ(errors[3].where.line, 5);
}

TEST(StrokeList, numbersMustBeFinite) {
  EXPECT_EQ(errorsOf("image,class,x,y,radius\na.png,orange,nan,inf,1e999\n").size(), 3U);
}

TEST(StrokeList, withoutItsHeaderItIsNone) {
  for (const char* text : {"", "\n\n", "a.png,orange,1,2,3\n", "image,class,x,y\n"}) {
    const auto errors = errorsOf(text);
    ASSERT_EQ(errors.size(), 1U) << text;
    EXPECT_NE(errors[0].text.find("image,class,x,y,radius"), std::string::npos);
  }
}

TEST(StrokeList, aFileOfRubbishIsNotToldLineByLine) {
  std::string text = "image,class,x,y,radius\n";
  for (int i = 0; i < 10'000; ++i) text += "\x01\x02,,,\n";
  EXPECT_LE(errorsOf(text).size(), 20U);
}

}  // namespace
}  // namespace colortool
