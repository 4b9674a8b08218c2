// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/TableTrainer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/colortool/SampleFixture.h"

using namespace colortool;

namespace {

ColorTable freshTable(const Samples& samples) {
  TableTrainer trainer;
  return trainer.train(samples);
}

}  // namespace

TEST(TableTrainer, learnsWhatTheStrokesShow) {
  const ColorTable table = freshTable(quarterSamples());
  const ColorImage image = quarters();
  EXPECT_EQ(table.classOf(image.at(3, 3)), 1);
  EXPECT_EQ(table.classOf(image.at(36, 3)), 2);
  EXPECT_EQ(table.classOf(image.at(3, 28)), 3);
  EXPECT_EQ(table.classOf(image.at(36, 28)), ColorClasses::kNone);
}

TEST(TableTrainer, theTableDoesNotDependOnTheWayToIt) {
  std::mt19937 random(3);
  const ColorImage image = quarters(), darker = quarters(40, 30, 30);
  TableTrainer trainer;
  Samples samples = quarterSamples();
  trainer.train(samples);
  for (int step = 0; step < 40; ++step) {
    switch (random() % 5) {
      case 0:
      case 1:
        addStroke(samples, placeOf("b"), random() % 2 == 0 ? image : darker,
                  disc(image, static_cast<double>(random() % 40), static_cast<double>(random() % 30)),
                  {static_cast<std::uint8_t>(random() % 4), random() % 4 == 0,
                   0.5 + static_cast<double>(random() % 3)});
        break;
      case 2:
        removeStrokes(samples, {1 + random() % 8});
        break;
      case 3:
        restate(samples, {1 + random() % 8}, {static_cast<std::uint8_t>(random() % 4), false, 1});
        break;
      case 4:
        samples.settings.votes.radius = 6 + static_cast<double>(random() % 5);
        break;
    }
    ASSERT_EQ(trainer.train(samples), freshTable(samples)) << "step " << step;
  }
}

TEST(TableTrainer, eachMethodKnowsTheBall) {
  Samples samples = quarterSamples();
  for (const auto method :
       {TrainingMethod::kVotes, TrainingMethod::kGaussians, TrainingMethod::kSupportVectors}) {
    samples.settings.method = method;
    EXPECT_EQ(freshTable(samples).classOf({140, 60, 200}), 1) << static_cast<int>(method);
  }
}

TEST(TableTrainer, whatMustNotBeIsNot) {
  Samples samples = quarterSamples();
  const ColorImage image = quarters();
  ASSERT_EQ(freshTable(samples).classOf({150, 62, 196}), 1) << "near the ball's orange";
  addStroke(samples, placeOf("a"), image, disc(image, 12, 8), {1, true, 10});
  EXPECT_EQ(freshTable(samples).classOf({150, 62, 196}), ColorClasses::kNone);
}

TEST(TableTrainer, whatNoSampleSpeaksForIsTakenOutIfThatIsWanted) {
  // What is sampled as orange is taken by green, but for a rim that must not be green.
  Samples samples = emptySamples();
  const auto touch = [&](robotlink::YCbCr color, const StrokeMeaning& meaning) {
    ColorImage image(20, 20);
    std::ranges::fill(image.pixels, color);
    addStroke(samples, placeOf("a"), image, disc(image, 10, 10), meaning);
  };
  touch({140, 80, 180}, {1, false, 1});
  touch({140, 80, 180}, {2, false, 3});
  touch({140, 92, 168}, {2, true, 3});
  const robotlink::YCbCr rim{140, 88, 172};
  samples.settings.cleanUp = {false, false};
  ASSERT_EQ(freshTable(samples).classOf(rim), 1);
  ASSERT_EQ(freshTable(samples).classOf({140, 80, 180}), 2);
  samples.settings.cleanUp = {true, true};
  const ColorTable cleaned = freshTable(samples);
  EXPECT_EQ(cleaned.classOf(rim), ColorClasses::kNone);
  EXPECT_EQ(cleaned.classOf({140, 80, 180}), 2);
}

TEST(TableTrainer, correctionsCountAsSoonAsTheyAreSwitchedOn) {
  Samples samples = quarterSamples();
  ColorCorrection brighter;
  brighter.channels[0] = {1, 60};
  samples.corrections = {{"nao", brighter}};
  TableTrainer trainer;
  const ColorTable before = trainer.train(samples);
  samples.settings.correctCameras = true;
  EXPECT_NE(trainer.train(samples), before);
  EXPECT_EQ(trainer.table(), freshTable(samples));
  samples.settings.correctCameras = false;
  EXPECT_EQ(trainer.train(samples), before);
}

TEST(TableTrainer, marginsSayWhereATableIsUnsure) {
  TableTrainer trainer;
  Samples samples = quarterSamples();
  trainer.train(samples);
  const auto margins = trainer.margins();
  ASSERT_EQ(margins.size(), ColorTable::kCellCount);
  EXPECT_GT(margins[ColorTable::cellOf({140, 60, 200})], 200) << "in the middle of orange";
  EXPECT_EQ(margins[ColorTable::cellOf({20, 20, 20})], 255) << "far from everything: surely none";
  int least = 255;
  for (int cr = 128; cr < 200; cr += 4)
    least = std::min<int>(
        least, margins[ColorTable::cellOf({140, static_cast<std::uint8_t>(128 - (cr - 128) * 68 / 72),
                                           static_cast<std::uint8_t>(cr)})]);
  EXPECT_LT(least, 128) << "on the way out of it";
}
