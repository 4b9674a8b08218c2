// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/Evaluation.h"

#include <gtest/gtest.h>

#include <array>

namespace colortool {
namespace {

TEST(Evaluation, countsWhatIsFoundOfWhatIsThere) {
  Evaluation evaluation(4);
  evaluation.add(1, 1, 90);
  evaluation.add(1, 2, 10);
  evaluation.add(2, 2, 50);
  evaluation.add(2, 0, 50);
  evaluation.add(0, 0, 97);
  evaluation.add(0, 1, 2);
  evaluation.add(0, 3, 1);
  EXPECT_DOUBLE_EQ(evaluation.recall(1), 0.9);
  EXPECT_DOUBLE_EQ(evaluation.recall(2), 0.5);
  EXPECT_DOUBLE_EQ(evaluation.meanRecall(), 0.7) << "class 3 does not occur";
  EXPECT_EQ(evaluation.count(1, 2), 10U);
  const std::array<std::uint8_t, 1> first = {1};
  const std::array<std::uint8_t, 2> both = {1, 3};
  EXPECT_DOUBLE_EQ(evaluation.falseColor(first), 0.02);
  EXPECT_DOUBLE_EQ(evaluation.falseColor(both), 0.03);
}

TEST(Evaluation, passesOverWhatIsNotLabeled) {
  ColorTable table;
  table.setCell(10, 20, 30, 1);
  ColorImage image(4, 1);
  image.pixels = {{40, 80, 120}, {40, 80, 120}, {0, 0, 0}, {40, 80, 120}};
  const std::array<std::uint8_t, 4> labels = {1, Evaluation::kIgnored, 1, 200};
  Evaluation evaluation(2);
  evaluation.add(table, image, labels);
  EXPECT_EQ(evaluation.labeled(1), 2U);
  EXPECT_DOUBLE_EQ(evaluation.recall(1), 0.5);
  EXPECT_EQ(evaluation.labeled(0), 0U);
  EXPECT_EQ(evaluation.recall(0), 0);
}

TEST(ColorImage, takesTheChromaOfItsPair) {
  robotlink::Image pair(2, 1, robotlink::PixelFormat::kYuyv);
  pair.data = {10, 20, 30, 40};
  const ColorImage image = ColorImage::of(pair.view());
  EXPECT_EQ(image.at(0, 0), (robotlink::YCbCr{10, 20, 40}));
  EXPECT_EQ(image.at(1, 0), (robotlink::YCbCr{30, 20, 40}));
}

}  // namespace
}  // namespace colortool
