// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/CrossValidation.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "colortool/training/TableTrainer.h"
#include "tests/colortool/SampleFixture.h"

namespace colortool {
namespace {

/// Two strokes in each quarter of an image.
Samples twiceQuarterSamples() {
  Samples samples = quarterSamples();
  merge(samples, [] {
    Samples more = emptySamples();
    const ColorImage image = quarters(40, 30, 8);
    addStroke(more, placeOf("b"), image, disc(image, 8, 7), {1});
    addStroke(more, placeOf("b"), image, disc(image, 30, 7), {2});
    addStroke(more, placeOf("b"), image, disc(image, 8, 22), {3});
    addStroke(more, placeOf("b"), image, disc(image, 30, 22), {0});
    return more;
  }());
  return samples;
}

double rightOf(const StrokeQuality& quality, std::uint64_t stroke) {
  for (const StrokeScore& score : quality.strokes) {
    if (score.stroke == stroke) return score.right;
  }
  ADD_FAILURE() << "stroke " << stroke << " is not scored";
  return -1;
}

constexpr std::array<std::uint8_t, 3> kBrightnesses = {1, 2, 3};

TEST(CrossValidation, strokesOfLikeColorsPredictEachOther) {
  Samples samples = twiceQuarterSamples();
  for (const auto method :
       {TrainingMethod::kVotes, TrainingMethod::kGaussians, TrainingMethod::kSupportVectors}) {
    samples.settings.method = method;
    const auto quality = crossValidate(samples);
    ASSERT_TRUE(quality.has_value());
    EXPECT_DOUBLE_EQ(quality->evaluation.meanRecall(), 1) << static_cast<int>(method);
    EXPECT_DOUBLE_EQ(quality->evaluation.falseColor(kBrightnesses), 0);
    EXPECT_EQ(quality->evaluation.labeled(1), 2 * StrokeQuality::kStroke);
    EXPECT_EQ(quality->strokesOf, (std::vector<int>{2, 2, 2, 2}));
    EXPECT_EQ(quality->strokes.size(), 8U);
    EXPECT_TRUE(quality->alone.empty());
  }
}

TEST(CrossValidation, aClassWithASingleStrokeIsToldApart) {
  Samples samples = twiceQuarterSamples();
  removeStrokes(samples, {6});  // the second of green
  const auto quality = crossValidate(samples);
  EXPECT_EQ(quality->alone, std::vector<std::uint8_t>{2});
  EXPECT_DOUBLE_EQ(quality->evaluation.recall(2), 0);
  EXPECT_DOUBLE_EQ(quality->evaluation.recall(1), 1);
  EXPECT_DOUBLE_EQ(quality->evaluation.meanRecall(), 2.0 / 3);
}

TEST(CrossValidation, theStrokeThatIsWrongStandsOut) {
  Samples samples = twiceQuarterSamples();
  const ColorImage image = quarters();
  // An orange stroke in the green, of little weight: all others say otherwise.
  const std::uint64_t wrong = addStroke(samples, placeOf("a"), image, disc(image, 25, 10), {1, false, 0.2});
  const auto quality = crossValidate(samples);
  EXPECT_DOUBLE_EQ(rightOf(*quality, wrong), 0);
  EXPECT_EQ(quality->evaluation.count(1, 2), StrokeQuality::kStroke) << "its weight does not count";
  for (std::uint64_t id = 1; id < wrong; ++id) EXPECT_DOUBLE_EQ(rightOf(*quality, id), 1) << id;
}

TEST(CrossValidation, whatMustNotBeIsFalseColorIfItIsFoundAllTheSame) {
  Samples samples = twiceQuarterSamples();
  const ColorImage image = quarters();
  const std::uint64_t orange = addStroke(samples, placeOf("a"), image, disc(image, 12, 7), {1, true, 0.2}),
                      notGreen = addStroke(samples, placeOf("a"), image, disc(image, 8, 22), {2, true});
  const auto quality = crossValidate(samples);
  EXPECT_DOUBLE_EQ(rightOf(*quality, orange), 0);
  EXPECT_DOUBLE_EQ(rightOf(*quality, notGreen), 1) << "it is white";
  EXPECT_EQ(quality->evaluation.count(0, 1), StrokeQuality::kStroke);
  EXPECT_EQ(quality->evaluation.count(0, 3), 0U);
  EXPECT_EQ(quality->evaluation.labeled(0), 4 * StrokeQuality::kStroke)
      << "two strokes of background, and two must-not-be";
}

/// Noisy strokes of all kinds, so that scores are anything from 0 to 1.
Samples noisySamples() {
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0, 14);
  ColorImage image = quarters(60, 40);
  for (robotlink::YCbCr& pixel : image.pixels) {
    for (std::uint8_t* value : {&pixel.y, &pixel.cb, &pixel.cr})
      *value = static_cast<std::uint8_t>(std::clamp(*value * 0.5 + 60 + noise(random), 0.0, 255.0));
  }
  Samples samples = emptySamples();
  for (int i = 0; i < 16; ++i) {
    const int x = static_cast<int>(random() % 60), y = static_cast<int>(random() % 40);
    const auto colorClass = static_cast<std::uint8_t>(y < 20 ? (x < 30 ? 1 : 2) : (x < 30 ? 3 : 0));
    addStroke(samples, placeOf("a"), image, disc(image, x, y),
              {colorClass, i % 5 == 4, 0.5 + static_cast<double>(random() % 3)});
  }
  ColorCorrection correction;
  correction.vignetting.luma = {-0.2, 0};
  correction.channels[1].offset = 3;
  samples.corrections = {{"nao", correction}};
  samples.settings.correctVignetting = samples.settings.correctCameras = true;
  samples.settings.votes.radius = 5;
  return samples;
}

TEST(CrossValidation, eachStrokeIsScoredWithTheTableOfAllOthers) {
  const Samples samples = noisySamples();
  const auto quality = crossValidate(samples);
  ASSERT_EQ(quality->strokes.size(), samples.strokes.size());
  double least = 1, most = 0;
  for (const StrokePtr& stroke : samples.strokes) {
    Samples others = samples;
    std::erase(others.strokes, stroke);
    TableTrainer trainer;
    const ColorTable& table = trainer.train(others);
    int right = 0;
    for (const StrokeCell& cell : strokeCells(samples, *stroke)) {
      const bool same = table.cells()[cell.cell] == stroke->colorClass;
      right += same != stroke->mustNotBe ? static_cast<int>(cell.pixels) : 0;
    }
    const double expected = right / static_cast<double>(stroke->colors.size());
    EXPECT_DOUBLE_EQ(rightOf(*quality, stroke->id), expected) << "stroke " << stroke->id;
    least = std::min(least, expected);
    most = std::max(most, expected);
  }
  EXPECT_LT(least, 0.6);
  EXPECT_GT(most, 0.9);
}

TEST(CrossValidation, methodsThatLearnFromScratchDoSoFiveTimes) {
  Samples samples = noisySamples();
  samples.settings.method = TrainingMethod::kGaussians;
  int asked = 0;
  const auto quality = crossValidate(samples, [&] { return ++asked > 0; });
  EXPECT_EQ(asked, 5);
  std::uint64_t scored = 0;
  for (int label = 0; label < 4; ++label) scored += quality->evaluation.labeled(label);
  std::uint64_t strokes = 0;
  for (const StrokePtr& stroke : samples.strokes)
    strokes += stroke->mustNotBe && stroke->colorClass == 0 ? 0 : 1;
  EXPECT_EQ(scored, strokes * StrokeQuality::kStroke) << "each stroke once";
}

TEST(CrossValidation, aLargeStrokeCountsNoMoreThanASmallOne) {
  Samples samples = twiceQuarterSamples();
  const ColorImage image = quarters();
  // Nearly all of the green, said to be white, against two right strokes of white.
  addStroke(samples, placeOf("a"), image, rectangleArea(40, 30, {22, 1}, {38, 13}), {3, false, 0.1});
  const auto quality = crossValidate(samples);
  EXPECT_NEAR(quality->evaluation.recall(3), 2.0 / 3, 1e-9);
  EXPECT_EQ(quality->strokesOf[3], 3);
}

/// If pixels counted, its own would outnumber all others.
TEST(CrossValidation, aHugeGreenStrokeOverTheWallLowersTheQuality) {
  Samples samples = twiceQuarterSamples();
  EXPECT_DOUBLE_EQ(crossValidate(samples)->evaluation.meanRecall(), 1);
  const ColorImage image = quarters(400, 300);
  addStroke(samples, placeOf("c"), image, rectangleArea(400, 300, {210, 160}, {390, 290}), {2});
  const Evaluation after = crossValidate(samples)->evaluation;
  EXPECT_NEAR(after.recall(2), 2.0 / 3, 1e-9) << "the other strokes know it to be wall";
  EXPECT_NEAR(after.meanRecall(), 8.0 / 9, 1e-9);
  EXPECT_EQ(after.count(0, 2), after.labeled(0)) << "the wall is green now";
}

TEST(CrossValidation, aSingleStrokeOfTheBackgroundSaysNothingOfFalseColors) {
  const auto quality = crossValidate(quarterSamples());
  EXPECT_EQ(quality->alone, (std::vector<std::uint8_t>{0, 1, 2, 3}));
}

TEST(CrossValidation, anotherTableIsScoredByTheStrokesAsItIs) {
  const Samples samples = twiceQuarterSamples();
  TableTrainer trainer;
  EXPECT_DOUBLE_EQ(scoreStrokes(samples, trainer.train(samples)).meanRecall(), 1);
  EXPECT_DOUBLE_EQ(scoreStrokes(samples, ColorTable()).meanRecall(), 0);
}

TEST(CrossValidation, itCanBeGivenUp) {
  int asked = 0;
  EXPECT_FALSE(crossValidate(twiceQuarterSamples(), [&] { return ++asked < 3; }).has_value());
  EXPECT_EQ(asked, 3);
}

TEST(CrossValidation, withoutStrokesThereIsNothingToSay) {
  const auto quality = crossValidate(emptySamples());
  EXPECT_TRUE(quality->strokes.empty());
  EXPECT_TRUE(quality->alone.empty());
  EXPECT_DOUBLE_EQ(quality->evaluation.meanRecall(), 0);
}

}  // namespace
}  // namespace colortool
