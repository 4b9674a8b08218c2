// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/StrokeCells.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/colortool/SampleFixture.h"

namespace colortool {
namespace {

using robotlink::YCbCr;

/// Counted pixel by pixel.
std::map<std::size_t, int> countedCells(const Stroke& stroke) {
  std::map<std::size_t, int> counts;
  for (const YCbCr color : stroke.colors) ++counts[ColorTable::cellOf(color)];
  return counts;
}

/// An image in which no two neighbors are of the same cell.
ColorImage colorful(int width, int height) {
  ColorImage image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixels[static_cast<std::size_t>(y * width + x)] = {static_cast<std::uint8_t>(x * 5 % 256),
                                                               static_cast<std::uint8_t>(y * 7 % 256), 90};
    }
  }
  return image;
}

Stroke rectangleStroke(const ColorImage& image, const StrokeMeaning& meaning) {
  Samples samples = emptySamples();
  addStroke(samples, placeOf("a"), image,
            rectangleArea(image.width, image.height, {0, 0}, {image.width - 1.0, image.height - 1.0}),
            meaning);
  return *samples.strokes.front();
}

void expectEachCellOnce(const std::vector<StrokeCell>& cells, const Stroke& stroke) {
  const auto counted = countedCells(stroke);
  ASSERT_EQ(cells.size(), counted.size());
  auto expected = counted.begin();
  for (const StrokeCell& cell : cells) {
    EXPECT_EQ(cell.cell, expected->first);
    EXPECT_EQ(cell.units, expected->second * ColorVotes::kUnit);
    EXPECT_EQ(static_cast<int>(cell.pixels), expected->second);
    ++expected;
  }
}

TEST(StrokeCells, smallAndLargeStrokesAreCountedAlike) {
  for (const int side : {6, 30, 100}) {
    const Stroke stroke = rectangleStroke(colorful(side, side), {1, false, 1, "rectangle"});
    expectEachCellOnce(strokeCells(emptySamples(), stroke), stroke);
  }
}

TEST(StrokeCells, weightMultipliesAndMustNotBeCountsAgainst) {
  Samples samples = quarterSamples();
  const std::uint64_t id = samples.strokes.front()->id;
  restate(samples, {id}, {1, false, 0.5});
  const auto half = strokeCells(samples, *samples.strokes.front());
  ASSERT_EQ(half.size(), 1U);
  EXPECT_EQ(half.front().units, 29 * ColorVotes::kUnit / 2);
  restate(samples, {id}, {1, true, 2});
  EXPECT_EQ(strokeCells(samples, *samples.strokes.front()).front().units, -29 * ColorVotes::kUnit * 2);
}

TEST(StrokeCells, theCorrectionOfTheCameraComesFirstIfItIsOn) {
  Samples samples = quarterSamples();
  ColorCorrection brighter;
  brighter.channels[0].offset = 40;
  samples.corrections = {{"nao", brighter}};
  const Stroke& orange = *samples.strokes.front();
  EXPECT_EQ(strokeCells(samples, orange).front().cell, ColorTable::cellOf({140, 60, 200}));
  samples.settings.correctCameras = true;
  EXPECT_EQ(strokeCells(samples, orange).front().cell, ColorTable::cellOf({180, 60, 200}));
}

TEST(StrokeCells, addingAndTakingAwayLeavesTheVotesAsTheyWere) {
  const Samples samples = quarterSamples();
  ColorVotes votes(samples.classes.size());
  for (const StrokePtr& stroke : samples.strokes) {
    addTo(votes, strokeCells(samples, *stroke), stroke->colorClass);
  }
  const ColorTable all = votes.update();
  EXPECT_EQ(all.classOf({140, 60, 200}), 1);
  const Stroke& orange = *samples.strokes.front();
  addTo(votes, strokeCells(samples, orange), orange.colorClass, -1);
  EXPECT_EQ(votes.update().classOf({140, 60, 200}), 0);
  addTo(votes, strokeCells(samples, orange), orange.colorClass);
  EXPECT_EQ(votes.update(), all);
}

}  // namespace
}  // namespace colortool
