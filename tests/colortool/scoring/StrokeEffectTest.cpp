// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/StrokeEffect.h"

#include <gtest/gtest.h>

#include "colortool/training/TableTrainer.h"
#include "tests/colortool/SampleFixture.h"

namespace colortool {
namespace {

robotlink::Image viewOf(const ColorImage& image) {
  robotlink::Image yuyv(image.width, image.height, robotlink::PixelFormat::kYuyv);
  for (std::size_t i = 0; i + 1 < image.pixels.size(); i += 2) {
    const auto &a = image.pixels[i], &b = image.pixels[i + 1];
    const std::uint8_t bytes[] = {a.y, a.cb, b.y, a.cr};
    std::copy_n(bytes, 4, yuyv.data.begin() + static_cast<std::ptrdiff_t>(2 * i));
  }
  return yuyv;
}

ColorTable tableOf(const Samples& samples) {
  TableTrainer trainer;
  return trainer.train(samples);
}

TEST(StrokeEffect, saysWhatACarelessStrokeTakesFromOtherClasses) {
  Samples samples = quarterSamples();
  const ColorTable before = tableOf(samples);
  const ColorImage image = quarters();
  const PixelArea careless = rectangleArea(40, 30, {24, 3}, {36, 11});
  addStroke(samples, placeOf("a"), image, careless, {3, false, 10});  // the green is white
  const ColorTable after = tableOf(samples);
  const robotlink::Image seen = viewOf(image);
  StrokeEffect effect(before, after);
  effect.add(seen.view(), careless);
  const auto losses = effect.losses();
  ASSERT_EQ(losses.size(), 1U);
  EXPECT_EQ(losses[0].from, 2);
  EXPECT_EQ(losses[0].to, 3);
  EXPECT_DOUBLE_EQ(losses[0].share, 1);
  EXPECT_EQ(losses[0].pixels, 20 * 15 - pixelCount(careless)) << "what the stroke covers is what it says";
}

TEST(StrokeEffect, aGoodStrokeTakesNothing) {
  Samples samples = quarterSamples();
  const ColorTable before = tableOf(samples);
  const ColorImage image = quarters();
  addStroke(samples, placeOf("a"), image, disc(image, 12, 10), {1, false, 1});
  const ColorTable after = tableOf(samples);
  StrokeEffect effect(before, after);
  const robotlink::Image seen = viewOf(image);
  effect.add(seen.view());
  EXPECT_TRUE(effect.losses().empty());
}

TEST(ContestedPixels, areThoseBesideTheLineThatAnotherClassHas) {
  Samples samples = quarterSamples();
  const ColorTable before = tableOf(samples);
  const ColorImage image = quarters();
  // Over the edge of white and wall, and up into the orange.
  const std::uint64_t id =
      addStroke(samples, placeOf("a"), image, rectangleArea(40, 30, {4, 12}, {9, 20}), {3, false, 1});
  const PixelArea contested = contestedPixels(samples, *samples.strokes.back(), before);
  EXPECT_EQ(contested, rectangleArea(40, 30, {4, 12}, {9, 14})) << "the orange";
  erasePart(samples, id, contested);
  EXPECT_EQ(samples.strokes.back()->area, rectangleArea(40, 30, {4, 15}, {9, 20}));
  EXPECT_EQ(samples.strokes.back()->colors.size(), 36U);
}

TEST(ContestedPixels, areThoseThatStrokesKnowWhereTheTableTakesEverythingForOneClass) {
  const ColorImage image = quarters();
  Samples samples;
  samples.classes = quarterSamples().classes;
  addStroke(samples, placeOf("a"), image, disc(image, 12, 10), {1, false, 1});
  const ColorTable before = [] {
    ColorTable all;
    for (int y = 0; y < ColorTable::kCells; ++y) {
      for (int cb = 0; cb < ColorTable::kCells; ++cb) {
        for (int cr = 0; cr < ColorTable::kCells; ++cr) all.setCell(y, cb, cr, 1);
      }
    }
    return all;
  }();
  addStroke(samples, placeOf("a"), image, rectangleArea(40, 30, {4, 12}, {9, 20}), {3, false, 1});
  EXPECT_EQ(contestedPixels(samples, *samples.strokes.back(), before),
            rectangleArea(40, 30, {4, 12}, {9, 14}))
      << "the orange, although the table takes the white for orange, too";
}

TEST(ContestedPixels, thereAreNoneWhereAStrokeIsToCorrectTheTable) {
  Samples samples = quarterSamples();
  const ColorTable before = tableOf(samples);
  const ColorImage image = quarters();
  addStroke(samples, placeOf("a"), image, disc(image, 30, 7), {3, false, 1});
  EXPECT_TRUE(contestedPixels(samples, *samples.strokes.back(), before).empty());
  addStroke(samples, placeOf("a"), image, rectangleArea(40, 30, {4, 12}, {9, 20}), {3, true, 1});
  EXPECT_TRUE(contestedPixels(samples, *samples.strokes.back(), before).empty()) << "it must not be";
}

}  // namespace
}  // namespace colortool
