// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/ColorTable.h"

#include <gtest/gtest.h>

#include <array>

namespace colortool {
namespace {

using robotlink::Image;
using robotlink::PixelFormat;

const std::vector<NamedColor> kPalette = {
    {"orange", {255, 105, 0}}, {"carpet", {95, 88, 84}}, {"green", {0, 130, 50}}};

TEST(ColorClasses, areTheChosenNamesInTheChosenOrder) {
  const std::array<std::string_view, 3> names = {"green", "violet", "orange"};
  const ColorClasses classes = ColorClasses::select(kPalette, names);
  ASSERT_EQ(classes.size(), 3);
  EXPECT_EQ(classes.name(0), "none");
  EXPECT_EQ(classes.name(1), "green");
  EXPECT_EQ(classes.index("orange"), 2);
  EXPECT_EQ(classes.index("carpet"), ColorClasses::kNone);
  EXPECT_EQ(classes.shownColor(1), (robotlink::Rgb{0, 130, 50}));
}

TEST(ColorTable, keepsACellForFourValuesOfEachChannel) {
  ColorTable table;
  table.setCell(10, 20, 63, 5);
  EXPECT_EQ(table.classOf({40, 80, 252}), 5);
  EXPECT_EQ(table.classOf({43, 83, 255}), 5);
  EXPECT_EQ(table.classOf({44, 83, 255}), 0);
  EXPECT_EQ(table.cells()[(10U << 12U) | (20U << 6U) | 63U], 5);
}

TEST(ColorTable, classifiesBothPixelsOfAYuyvPairByTheirOwnBrightness) {
  ColorTable table;
  table.setCell(10, 20, 30, 1);
  table.setCell(50, 20, 30, 2);
  Image image(4, 2, PixelFormat::kYuyv);
  image.data = {40, 80, 200, 120, 40, 80, 40, 120, 0, 0, 0, 0, 200, 80, 40, 120};
  Image classes;
  table.classify(image.view(), classes);
  EXPECT_EQ(classes.format, PixelFormat::kMono8);
  EXPECT_EQ(classes.data, (std::vector<std::uint8_t>{1, 2, 1, 1, 0, 0, 2, 1}));
}

TEST(ColorTable, classifiesRgbLikeTheSameColorInYuyv) {
  const robotlink::Rgb orange{255, 105, 0};
  const robotlink::YCbCr color = robotlink::toYCbCr(orange);
  ColorTable table;
  table.setCell(color.y / 4, color.cb / 4, color.cr / 4, 7);
  Image image(1, 1, PixelFormat::kRgb8);
  image.data = {orange.r, orange.g, orange.b};
  Image classes;
  table.classify(image.view(), classes);
  EXPECT_EQ(classes.data, std::vector<std::uint8_t>{7});
}

TEST(ColorTable, takesOverATableOfOtherClassNumbers) {
  std::vector<std::uint8_t> cells(64 * 64 * 64, 0);
  cells[5] = 1;
  cells[6] = 2;
  cells[7] = 200;
  const std::array<std::uint8_t, 3> numbers = {0, 4, 9};
  const ColorTable table = ColorTable::translated(cells, numbers);
  EXPECT_EQ(table.cells()[5], 4);
  EXPECT_EQ(table.cells()[6], 9);
  EXPECT_EQ(table.cells()[7], 0) << "a class that has no number";
  EXPECT_EQ(ColorTable::translated(std::span(cells).first(10), numbers), ColorTable()) << "too few cells";
}

TEST(ColorTable, classifiesNothingInAnEmptyImage) {
  Image classes(3, 3, PixelFormat::kMono8);
  ColorTable().classify({}, classes);
  EXPECT_EQ(classes.width, 0);
  EXPECT_TRUE(classes.data.empty());
}

TEST(ColorTable, showsClassesInTheirColorsAndUnknownOnesAsNone) {
  const std::array<std::string_view, 1> names = {"orange"};
  const ColorClasses classes = ColorClasses::select(kPalette, names);
  Image image(3, 1, PixelFormat::kMono8);
  image.data = {1, 0, 200};
  EXPECT_EQ(shownImage(image.view(), classes).data,
            (std::vector<std::uint8_t>{255, 105, 0, 0, 0, 0, 0, 0, 0}));
}

}  // namespace
}  // namespace colortool
