// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/correction/CorrectionEstimate.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "colortool/scoring/CrossValidation.h"
#include "tests/colortool/SampleFixture.h"

namespace colortool {
namespace {

using robotlink::YCbCr;

constexpr int kWidth = 320, kHeight = 240;
/// The colors of the classes from 1 on.
constexpr std::array<YCbCr, 3> kColors = {{{140, 60, 200}, {90, 110, 90}, {200, 128, 128}}};

/// A camera that is made like others by `correction`, and pictures of things of one color taken with it.
class SyntheticCamera {
 public:
  SyntheticCamera(std::string name, const ColorCorrection& correction, unsigned seed)
      : name_(std::move(name)), correction_(correction), random_(seed) {}

  double noise = 2;    ///< of a pixel
  double shading = 4;  ///< of a stroke's Y
  std::string lighting;

  /// What the camera makes of a color, at a place.
  YCbCr seen(YCbCr color, int x, int y) {
    const double r2 = squaredImageRadius(x, y, kWidth, kHeight);
    return {value(color.y, correction_.lumaAt(r2)), value(color.cb, correction_.blueAt(r2)),
            value(color.cr, correction_.redAt(r2))};
  }
  void touch(Samples& samples, YCbCr color, const StrokeMeaning& meaning, int x, int y) {
    ColorImage image(kWidth, kHeight);
    color.y = static_cast<std::uint8_t>(color.y + std::lround(shading * normal_(random_)));
    const PixelArea area = disc(image, x, y);
    for (const PixelRun& run : area) {
      for (int at = run.begin; at < run.end; ++at)
        image.pixels[static_cast<std::size_t>(run.y * kWidth + at)] = seen(color, at, run.y);
    }
    addStroke(samples, {0, "image by " + lighting, name_, lighting, 0, 0}, image, area, meaning);
  }
  /// `count` strokes of each class from 1 on, anywhere within this part of the image around its middle.
  void touchAll(Samples& samples, int count, double part = 1, std::size_t classes = kColors.size()) {
    std::uniform_real_distribution<double> place(-part / 2, part / 2);
    for (int i = 0; i < count; ++i) {
      for (std::size_t colorClass = 0; colorClass < classes; ++colorClass) {
        const int y = static_cast<int>(kHeight * (0.5 + place(random_)));
        const int x = static_cast<int>(kWidth * (0.5 + place(random_)));
        touch(samples, kColors[colorClass], {static_cast<std::uint8_t>(colorClass + 1)}, x, y);
      }
    }
  }

 private:
  std::uint8_t value(double ideal, const ChannelLine& line) {
    const double raw = (ideal - line.offset) / line.gain + noise * normal_(random_);
    return static_cast<std::uint8_t>(std::clamp(std::lround(raw), 0L, 255L));
  }
  std::string name_;
  ColorCorrection correction_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

ColorCorrection darkCorners() {
  ColorCorrection correction;
  correction.vignetting = {{-0.35, -0.1}, {9, 3}, {-12, 2}};
  return correction;
}

/// How far two corrections of vignetting are apart: of Y by what it is divided, of Cb and Cr in values.
void expectLike(const ColorCorrection& found, const ColorCorrection& true_, double shade, double tint) {
  for (const double r2 : {0.0, 0.25, 0.5, 0.75, 0.95}) {
    EXPECT_NEAR(1 / found.lumaAt(r2).gain, 1 / true_.lumaAt(r2).gain, shade) << "r^2 = " << r2;
    EXPECT_NEAR(found.blueAt(r2).offset, true_.blueAt(r2).offset, tint) << "r^2 = " << r2;
    EXPECT_NEAR(found.redAt(r2).offset, true_.redAt(r2).offset, tint) << "r^2 = " << r2;
  }
}

bool isNoted(const CorrectionEstimate& estimate, const std::string& words) {
  return std::ranges::any_of(estimate.notes,
                             [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST(CorrectionEstimate, vignettingIsFoundFromStrokesAllOverTheImage) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Samples samples = emptySamples();
    SyntheticCamera camera("nao", darkCorners(), seed);
    camera.touchAll(samples, 25);
    const CorrectionEstimate estimate = estimateCorrections(samples);
    ASSERT_EQ(estimate.corrections.size(), 1U);
    EXPECT_EQ(estimate.corrections[0].camera, "nao");
    expectLike(estimate.corrections[0].correction, darkCorners(), 0.03, 1);
    EXPECT_TRUE(isNoted(estimate, "% of what it is in the middle")) << estimate.notes.front();
  }
}

TEST(CorrectionEstimate, aFewStrokesWithoutNoiseAreEnough) {
  Samples samples = emptySamples();
  SyntheticCamera camera("nao", darkCorners(), 1);
  camera.noise = camera.shading = 0;
  camera.touchAll(samples, 4);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  ASSERT_EQ(estimate.corrections.size(), 1U);
  expectLike(estimate.corrections[0].correction, darkCorners(), 0.03, 1);
}

TEST(CorrectionEstimate, strokesInTheMiddleAloneSayNothing) {
  Samples samples = emptySamples();
  SyntheticCamera("nao", darkCorners(), 1).touchAll(samples, 25, 0.3);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  EXPECT_TRUE(estimate.corrections.empty());
  EXPECT_TRUE(isNoted(estimate, "toward its corners"));
}

TEST(CorrectionEstimate, chanceIsNotTakenForVignetting) {
  int found = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Samples samples = emptySamples();
    SyntheticCamera camera("nao", {}, seed);
    camera.shading = 12;
    camera.touchAll(samples, 3 + static_cast<int>(seed % 5));
    found += static_cast<int>(estimateCorrections(samples).corrections.size());
  }
  EXPECT_LE(found, 4);
}

TEST(CorrectionEstimate, aStrokeOfTheWrongClassDoesLittle) {
  Samples samples = emptySamples();
  SyntheticCamera camera("nao", darkCorners(), 4);
  camera.touchAll(samples, 25);
  for (const int x : {20, 160, 300}) camera.touch(samples, kColors[2], {2}, x, 20);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  ASSERT_EQ(estimate.corrections.size(), 1U);
  expectLike(estimate.corrections[0].correction, darkCorners(), 0.06, 2);
}

/// Night in the corners, day in the middle: that alone would look like vignetting.
TEST(CorrectionEstimate, lightingsAreNotMixed) {
  Samples samples = emptySamples();
  SyntheticCamera camera("nao", {}, 5);
  for (int i = 0; i < 12; ++i) {
    const YCbCr night{80, 128, 128};
    camera.lighting = "night";
    camera.touch(samples, night, {3}, i % 2 == 0 ? 10 : 310, 10 + i);
    camera.lighting = "day";
    camera.touch(samples, kColors[2], {3}, 150 + i, 120);
  }
  EXPECT_TRUE(estimateCorrections(samples).corrections.empty());
}

TEST(CorrectionEstimate, theColorsOfACameraBecomeThoseOfTheOneWithMostStrokes) {
  ColorCorrection other;
  other.channels = {{{1.25, -12}, {0.9, 8}, {1.1, -20}}};
  Samples samples = emptySamples();
  SyntheticCamera("nao1", {}, 1).touchAll(samples, 12);
  SyntheticCamera("nao2", other, 2).touchAll(samples, 8);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  ASSERT_FALSE(estimate.corrections.empty());
  const ColorCorrection& found = estimate.corrections.back().correction;
  EXPECT_EQ(estimate.corrections.back().camera, "nao2");
  EXPECT_TRUE(isNoted(estimate, "to be like nao1"));
  SyntheticCamera exact("nao2", other, 3);
  exact.noise = exact.shading = 0;
  for (const YCbCr color : kColors) {
    const YCbCr corrected = found.apply(exact.seen(color, 160, 120), 160, 120, kWidth, kHeight);
    EXPECT_NEAR(corrected.y, color.y, 4);
    EXPECT_NEAR(corrected.cb, color.cb, 2);
    EXPECT_NEAR(corrected.cr, color.cr, 2);
  }
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found.channels[i].gain, other.channels[i].gain, 0.06) << i;
}

TEST(CorrectionEstimate, twoClassesTellAnOffsetOnly) {
  ColorCorrection other;
  other.channels = {{{1, -12}, {1, 8}, {1, -20}}};
  Samples samples = emptySamples();
  SyntheticCamera("nao1", {}, 1).touchAll(samples, 12, 1, 2);
  SyntheticCamera("nao2", other, 2).touchAll(samples, 8, 1, 2);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  ASSERT_FALSE(estimate.corrections.empty());
  const ColorCorrection& found = estimate.corrections.back().correction;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(found.channels[i].gain, 1);
    EXPECT_NEAR(found.channels[i].offset, other.channels[i].offset, 3);
  }
  EXPECT_TRUE(isNoted(estimate, "strokes of three classes"));
}

TEST(CorrectionEstimate, camerasWithoutAClassInCommonAreNotCompared) {
  Samples samples = emptySamples();
  SyntheticCamera("nao1", {}, 1).touchAll(samples, 3, 1, 1);
  SyntheticCamera("nao2", {}, 2).touch(samples, kColors[1], {2}, 100, 100);
  const CorrectionEstimate estimate = estimateCorrections(samples);
  EXPECT_TRUE(estimate.corrections.empty());
  EXPECT_TRUE(isNoted(estimate, "cannot be compared with nao1"));
}

TEST(CorrectionEstimate, backgroundSaysNothing) {
  Samples samples = emptySamples();
  SyntheticCamera camera("nao", darkCorners(), 1);
  for (int i = 0; i < 30; ++i) {
    camera.touch(samples, kColors[0], {0}, 10 * i + 5, 8 * i + 4);
    camera.touch(samples, kColors[0], {1, true}, 10 * i + 5, 8 * i + 4);
  }
  const CorrectionEstimate estimate = estimateCorrections(samples);
  EXPECT_TRUE(estimate.corrections.empty());
  EXPECT_EQ(estimate.notes.size(), 1U);
}

/// Gray of the wall in the middle is what white is in the corners, so that without a correction nobody can
/// tell them apart.
TEST(CorrectionEstimate, strokesPredictEachOtherBetterWithIt) {
  ColorCorrection other;
  other.vignetting.luma = {-0.5, 0};
  other.channels[1].offset = 14;
  ColorCorrection first;
  first.vignetting.luma = {-0.45, 0};
  Samples samples = emptySamples();
  samples.settings.votes.brightnessWeight = 1;
  std::mt19937 random(8);
  for (auto& [name, correction] : {std::pair("nao1", first), {"nao2", other}}) {
    SyntheticCamera camera(name, correction, 6);
    camera.touchAll(samples, 15);
    for (int i = 0; i < 20; ++i) {
      const int y = static_cast<int>(random() % kHeight), x = static_cast<int>(random() % kWidth);
      camera.touch(samples, {130, 126, 129}, {0}, x, y);
    }
  }
  const StrokeQuality before = *crossValidate(samples);
  samples.corrections = estimateCorrections(samples).corrections;
  samples.settings.correctVignetting = samples.settings.correctCameras = true;
  const StrokeQuality after = *crossValidate(samples);
  const std::array<std::uint8_t, 3> all = {1, 2, 3};
  EXPECT_LT(before.evaluation.recall(3), 0.95);
  EXPECT_GT(before.evaluation.falseColor(all), 0.2);
  EXPECT_GT(after.evaluation.recall(3), 0.99);
  EXPECT_GT(after.evaluation.meanRecall(), before.evaluation.meanRecall());
  EXPECT_LT(after.evaluation.falseColor(all), 0.02);
}

}  // namespace
}  // namespace colortool
