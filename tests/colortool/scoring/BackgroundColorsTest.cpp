// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/BackgroundColors.h"

#include <gtest/gtest.h>

#include "colortool/scoring/CrossValidation.h"
#include "colortool/training/TableTrainer.h"

namespace colortool {
namespace {

constexpr robotlink::YCbCr kPaleWall{150, 118, 122}, kCarpet{90, 100, 90};
constexpr std::uint8_t kFieldClass = 1;

/// An image whose upper part is a wall with some grain, and the rest carpet.
ColorImage room(int wallRows) {
  ColorImage image(40, 30);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      robotlink::YCbCr color = y < wallRows ? kPaleWall : kCarpet;
      color.y = static_cast<std::uint8_t>(color.y + (7 * x + 13 * y) % 9);
      image.pixels[static_cast<std::size_t>(y * image.width + x)] = color;
    }
  }
  return image;
}

robotlink::Image bytesOf(const ColorImage& image) {
  robotlink::Image bytes(image.width, image.height, robotlink::PixelFormat::kRgb8);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const robotlink::Rgb rgb = robotlink::toRgb(image.pixels[i]);
    bytes.data[3 * i] = rgb.r;
    bytes.data[3 * i + 1] = rgb.g;
    bytes.data[3 * i + 2] = rgb.b;
  }
  return bytes;
}

class BackgroundColorsTest : public testing::Test {
 protected:
  BackgroundColorsTest() {
    samples_.classes = ColorClasses({{"green", {0, 130, 50}}});
    paint(kFieldClass, {2, 24}, {37, 28});
    paint(kFieldClass, {2, 20}, {37, 23});
  }
  void paint(std::uint8_t colorClass, ImagePoint from, ImagePoint to) {
    const ColorImage image = room(18);
    addStroke(samples_, {0, "a", "", "", 0, 0}, image, rectangleArea(image.width, image.height, from, to),
              {colorClass, false, 1, "rectangle"});
  }
  BackgroundColors::Counts countsIn(const std::vector<robotlink::Image>& images) {
    TableTrainer trainer;
    BackgroundColors colors(samples_, trainer.train(samples_));
    for (const robotlink::Image& image : images) colors.add(image.view());
    return colors.counts();
  }

  Samples samples_;
};

TEST_F(BackgroundColorsTest, ofWhatIsBackgroundNothingIsTakenByAGoodTable) {
  paint(0, {3, 3}, {12, 8});
  paint(0, {20, 3}, {30, 8});
  const auto counts = countsIn({bytesOf(room(10)), bytesOf(room(25))});
  EXPECT_EQ(counts.pixels, 2U * 40 * 30);
  EXPECT_GT(counts.background, 1000U);
  EXPECT_EQ(counts.taken[kFieldClass], 0U);
}

TEST_F(BackgroundColorsTest, twoStrokesThatVouchForEachOtherAreSeenThroughInOtherImages) {
  paint(0, {3, 3}, {8, 5});
  paint(kFieldClass, {0, 0}, {39, 8});
  paint(kFieldClass, {0, 9}, {39, 17});
  const StrokeQuality quality = crossValidate(samples_).value();
  EXPECT_EQ(quality.strokes.back().right, 1) << "each of the two finds the other one right";
  EXPECT_EQ(quality.strokes[quality.strokes.size() - 2].right, 1);
  const auto counts = countsIn({bytesOf(room(25))});
  EXPECT_GT(counts.background, 500U);
  EXPECT_EQ(counts.taken[kFieldClass], counts.background) << "all of the wall is green";
  EXPECT_EQ(counts.covered[kFieldClass], counts.pixels);
}

TEST_F(BackgroundColorsTest, withoutStrokesOfTheBackgroundNothingIsKnownOfIt) {
  const auto counts = countsIn({bytesOf(room(10))});
  EXPECT_EQ(counts.background, 0U);
  EXPECT_GT(counts.covered[kFieldClass], counts.pixels / 2);
}

TEST_F(BackgroundColorsTest, whatMustNotBeGreenIsNoBackground) {
  const ColorImage image = room(18);
  addStroke(samples_, {0, "a", "", "", 0, 0}, image, rectangleArea(40, 30, {3, 3}, {12, 8}),
            {0, true, 1, "rectangle"});
  EXPECT_EQ(countsIn({bytesOf(room(10))}).background, 0U);
}

}  // namespace
}  // namespace colortool
