// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorClasses.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace colortool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ColorClasses classes(const std::vector<std::string>& names) {
  std::vector<NamedColor> colors;
  for (const auto& name : names) colors.push_back({name, {std::uint8_t(10 * colors.size()), 1, 2}});
  return ColorClasses(std::move(colors));
}

TEST(ColorClasses, numberZeroIsNoneAndTheOthersFollow) {
  EXPECT_EQ(ColorClasses().size(), 1);
  EXPECT_EQ(ColorClasses().name(0), "none");
  const ColorClasses two = classes({"orange", "green"});
  EXPECT_EQ(two.size(), 3);
  EXPECT_EQ(two.index("green"), 2);
  EXPECT_EQ(two.shownColor(2).r, 10);
  EXPECT_THAT(two.names(), ElementsAre("orange", "green"));
  EXPECT_EQ(two.colors()[0].name, "orange");
}

TEST(ColorClasses, anUnknownNameIsNone) {
  EXPECT_EQ(classes({"orange"}).index("Orange"), ColorClasses::kNone);
  EXPECT_EQ(classes({"orange"}).index(""), ColorClasses::kNone);
  EXPECT_EQ(classes({"orange"}).index("none"), ColorClasses::kNone);
}

TEST(ColorClasses, thoseBeyondWhatAByteHoldsAreLeftOut) {
  std::vector<std::string> names;
  for (int i = 0; i < 300; ++i) names.push_back("c" + std::to_string(i));
  const ColorClasses most = classes(names);
  EXPECT_EQ(most.size(), ColorClasses::kMax + 1);
  EXPECT_EQ(most.index("c254"), 255);
  EXPECT_EQ(most.index("c255"), ColorClasses::kNone);
}

TEST(ColorClasses, aSelectionHasTheOrderOfItsNamesAndOnlyKnownOnes) {
  const ColorClasses palette = classes({"orange", "green", "white"});
  const std::string_view names[] = {"white", "violet", "orange"};
  EXPECT_THAT(ColorClasses::select(palette.colors(), names).names(), ElementsAre("white", "orange"));
  EXPECT_THAT(ColorClasses::select(palette.colors(), {}).names(), IsEmpty());
}

TEST(ColorClasses, unitedTheyKeepTheFirstsNumbersAndColors) {
  const ColorClasses first = classes({"orange", "green"}), second = classes({"white", "orange", "black"});
  const ColorClasses both = unite(first, second);
  EXPECT_THAT(both.names(), ElementsAre("orange", "green", "white", "black"));
  EXPECT_EQ(both.shownColor(1), first.shownColor(1));
  EXPECT_EQ(unite(first, ColorClasses()), first);
  EXPECT_EQ(unite(ColorClasses(), second), second);
}

TEST(ColorClasses, numbersAreTranslatedByNames) {
  EXPECT_THAT(classNumbers(classes({"orange", "pink", "green"}), classes({"green", "orange"})),
              ElementsAre(0, 2, 0, 1));
  EXPECT_THAT(classNumbers(ColorClasses(), classes({"green"})), ElementsAre(0));
}

TEST(ColorClasses, aNameThatFilesCannotHoldIsRefusedWithTheReason) {
  for (const char* good : {"orange", "sky blue", "grün", "None", "a"})
    EXPECT_EQ(classNameProblem(good), "") << good;
  EXPECT_THAT(classNameProblem(""), HasSubstr("needs a name"));
  EXPECT_THAT(classNameProblem("none"), HasSubstr("'none' stands for pixels of no class"));
  EXPECT_THAT(classNameProblem("background"), HasSubstr("no class"));
  EXPECT_THAT(classNameProblem("two\nlines"), HasSubstr("control characters"));
  EXPECT_THAT(classNameProblem("tab\t"), HasSubstr("control characters"));
  EXPECT_THAT(classNameProblem(" orange"), HasSubstr("space"));
  EXPECT_THAT(classNameProblem("orange "), HasSubstr("space"));
}

}  // namespace
}  // namespace colortool
