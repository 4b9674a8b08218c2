// SPDX-License-Identifier: GPL-3.0-or-later
// Images of all formats through a table, by plain and by vector code.
#include <gtest/gtest.h>

#include <random>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

using robotlink::Image;
using robotlink::ImageView;
using robotlink::PixelFormat;
using Instructions = ColorTable::Instructions;

/// Neighboring cells are of different classes, so that a wrong index shows.
ColorTable colorful() {
  ColorTable table;
  std::mt19937 random(1);
  for (int y = 0; y < ColorTable::kCells; ++y) {
    for (int cb = 0; cb < ColorTable::kCells; ++cb) {
      for (int cr = 0; cr < ColorTable::kCells; ++cr)
        table.setCell(y, cb, cr, static_cast<std::uint8_t>(random() % 256));
    }
  }
  return table;
}

Image noise(int width, int height, PixelFormat format) {
  Image image(width, height, format);
  std::mt19937 random(static_cast<unsigned>(width));
  for (auto& byte : image.data) byte = static_cast<std::uint8_t>(random());
  return image;
}

class ClassifyTest : public testing::TestWithParam<PixelFormat> {
 protected:
  const ColorTable table_ = colorful();
};

TEST_P(ClassifyTest, eachPixelIsOfTheClassOfItsColor) {
  for (const int width : {2, 30, 32, 34, 36, 66, 98, 320}) {
    const Image image = noise(width, 4, GetParam());
    for (const auto instructions : {Instructions::kPlain, Instructions::kFastest}) {
      Image classes;
      table_.classify(image.view(), classes, instructions);
      ASSERT_EQ(classes.data.size(), static_cast<std::size_t>(width) * 4);
      for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < width; ++x) {
          ASSERT_EQ(classes.row(y)[x], table_.classOf(robotlink::pixelYCbCr(image.view(), x, y)))
              << x << "," << y << " of " << width;
        }
      }
    }
  }
}

TEST_P(ClassifyTest, rowsMayHaveGapsAndNothingBehindTheLastIsRead) {
  constexpr int kWidth = 70, kHeight = 6, kGap = 13;
  const Image image = noise(kWidth, kHeight, GetParam());
  const int step = image.step() + kGap, rows = robotlink::rowsOf(GetParam(), kHeight);
  // Exactly as large as it must be: the address sanitizer sees more.
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(step) * static_cast<std::size_t>(rows - 1) +
                                  static_cast<std::size_t>(image.step()));
  for (int y = 0; y < rows; ++y)
    std::copy_n(image.row(y), image.step(), bytes.data() + static_cast<std::ptrdiff_t>(y) * step);
  Image classes, expected;
  table_.classify({kWidth, kHeight, step, GetParam(), bytes.data()}, classes);
  table_.classify(image.view(), expected, Instructions::kPlain);
  EXPECT_EQ(classes, expected);
}

INSTANTIATE_TEST_SUITE_P(Formats, ClassifyTest,
                         testing::Values(PixelFormat::kYuyv, PixelFormat::kUyvy, PixelFormat::kNv12,
                                         PixelFormat::kRgb8, PixelFormat::kBgr8),
                         [](const auto& test) { return std::string(robotlink::encodingName(test.param)); });

TEST(Classify, anOddRgbWidthIsClassifiedToItsEnd) {
  const ColorTable table = colorful();
  const Image image = noise(101, 3, PixelFormat::kRgb8);
  Image classes;
  table.classify(image.view(), classes);
  for (int x = 0; x < 101; ++x)
    EXPECT_EQ(classes.row(2)[x], table.classOf(robotlink::pixelYCbCr(image.view(), x, 2)));
}

TEST(Classify, theVectorCodeIsUsedWhereTheProcessorHasIt) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this processor has no AVX2";
  for (const PixelFormat format : robotlink::kPixelFormats) {
    EXPECT_EQ(avx2ClassifyRow(format) == nullptr, format == PixelFormat::kMono8);
  }
}

}  // namespace
}  // namespace colortool
