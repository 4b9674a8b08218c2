// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/SnappedWay.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace colortool;
using robotlink::YCbCr;

constexpr YCbCr kGrass{90, 110, 100}, kWhite{190, 128, 122};

/// A field with a line of two pixels across it, rows 19 and 20, blurred at both sides.
ColorImage lineOnField() {
  ColorImage image(60, 40);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      YCbCr& pixel = image.pixels[static_cast<std::size_t>(y * image.width + x)];
      pixel = y == 19 || y == 20 ? kWhite : kGrass;
      if (y == 18 || y == 21) pixel = {120, 115, 107};
    }
  }
  return image;
}

/// What a brush touches that is led along these points.
PixelArea painted(const ColorImage& image, const std::vector<ImagePoint>& points, double radius = 3) {
  SnappedWay way(image, points.front(), radius, 24);
  PixelArea area = way.begin(image);
  for (const ImagePoint point : points) area = united(area, way.moveTo(image, point));
  return area;
}

int pixelsIn(const PixelArea& area, int top, int bottom) {
  int count = 0;
  for (const PixelRun& run : area) count += run.y >= top && run.y <= bottom ? run.end - run.begin : 0;
  return count;
}

TEST(SnappedWay, aHandThatShakesPaintsNothingButTheThinLine) {
  const ColorImage image = lineOnField();
  std::vector<ImagePoint> points;
  for (int x = 5; x <= 50; x += 3) points.push_back({1.0 * x, 19.5 + 2.4 * std::sin(x)});
  points.front().y = 19;
  const PixelArea area = painted(image, points);
  EXPECT_EQ(pixelsIn(area, 0, 17) + pixelsIn(area, 22, 39), 0) << "of the field";
  EXPECT_GT(pixelsIn(area, 19, 20), 80) << "of the line's 92";
  EXPECT_TRUE(isValid(area, image.width, image.height));
}

TEST(SnappedWay, aWayThatLeavesTheLineForGoodGoesWhereTheMouseGoes) {
  const ColorImage image = lineOnField();
  const PixelArea area = painted(image, {{10, 19}, {20, 20}, {30, 30}, {40, 32}});
  EXPECT_TRUE(contains(area, 15, 19));
  EXPECT_TRUE(contains(area, 38, 32)) << "the field is meant now";
  EXPECT_FALSE(contains(area, 15, 23));
}

TEST(SnappedWay, aThingIsPaintedFromItsLitToItsDarkSide) {
  ColorImage image(60, 40);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      YCbCr& pixel = image.pixels[static_cast<std::size_t>(y * image.width + x)];
      pixel = {static_cast<std::uint8_t>(220 - 3 * x), 60, 200};
    }
  }
  const PixelArea area = painted(image, {{5, 20}, {55, 20}});
  EXPECT_EQ(area, painted(image, {{5, 20}, {20, 20}, {30, 20}, {55, 20}}));
  EXPECT_GT(pixelsIn(area, 19, 21), 3 * 48);
}

TEST(SnappedWay, aWayThatBeginsOrEndsOutsideOfTheImageIsTakenAsItIs) {
  const ColorImage image = lineOnField();
  EXPECT_TRUE(isValid(painted(image, {{-20, 19}, {70, 20}, {70, 200}}), image.width, image.height));
  EXPECT_GT(pixelsIn(painted(image, {{-20, 19}, {70, 20}}), 19, 20), 90);
  EXPECT_TRUE(painted(image, {{-20, -20}, {-10, -10}}).empty());
  EXPECT_FALSE(painted(image, {{10, 19}, {1e9, 19}}).empty());
}

}  // namespace
