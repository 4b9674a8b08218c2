// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/color/LabelStrokes.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using colortool::DiscStroke;
using robotlink::Image;
using testing::HasSubstr;
using testing::IsEmpty;

const colortool::ColorClasses kTwoColors{{{"orange", {255, 128, 0}}, {"green", {0, 128, 0}}}};
constexpr std::uint8_t kOrange = 1, kGreen = 2;

/// Labels of one class, of which a rectangle has another one.
Image labelsOf(int width, int height, std::uint8_t label) {
  Image labels(width, height, robotlink::PixelFormat::kMono8);
  for (int y = 0; y < height; ++y) std::fill_n(labels.row(y), width, label);
  return labels;
}
void fill(Image& labels, int left, int top, int width, int height, std::uint8_t label) {
  for (int y = top; y < top + height; ++y) std::fill_n(labels.row(y) + left, width, label);
}

std::vector<DiscStroke> strokesIn(const Image& labels, std::size_t count) {
  return strokesInside(labels, "frame.png", kTwoColors, count);
}

TEST(LabelStrokes, lieOnlyWhereAllNeighborsAreOfTheClass) {
  Image labels = labelsOf(320, 10, 0);
  fill(labels, 100, 2, 5, 5, kOrange);
  const auto strokes = strokesIn(labels, 1000);
  int orange = 0;
  for (const DiscStroke& stroke : strokes) {
    EXPECT_EQ(stroke.image, "frame.png");
    EXPECT_EQ(stroke.radius, 1) << "a pixel of an image of this width";
    if (stroke.colorClass != "orange") continue;
    ++orange;
    EXPECT_TRUE(stroke.x >= 101 && stroke.x <= 103 && stroke.y >= 3 && stroke.y <= 5)
        << stroke.x << " " << stroke.y;
  }
  EXPECT_EQ(orange, 9);
}

TEST(LabelStrokes, placesAreInPixelsOfTheUsualWidth) {
  Image labels = labelsOf(80, 3, kGreen);
  const auto strokes = strokesIn(labels, 1);
  ASSERT_EQ(strokes.size(), 1U);
  EXPECT_EQ(strokes[0].colorClass, "green");
  EXPECT_EQ(strokes[0].x, 4 * 40);
  EXPECT_EQ(strokes[0].y, 4 * 1);
  EXPECT_EQ(strokes[0].radius, 4);
}

TEST(LabelStrokes, areSpreadOverTheImage) {
  const auto strokes = strokesIn(labelsOf(320, 100, kGreen), 4);
  ASSERT_EQ(strokes.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_GT(strokes[i].y, 25.0 * static_cast<double>(i)) << "one in each quarter";
    EXPECT_LT(strokes[i].y, 25.0 * static_cast<double>(i + 1));
  }
}

TEST(LabelStrokes, theBackgroundIsAClassButWhatDoesNotCountIsNot) {
  Image labels = labelsOf(320, 30, 255);
  fill(labels, 0, 0, 320, 10, 0);
  fill(labels, 0, 20, 320, 10, 77);
  const auto strokes = strokesIn(labels, 3);
  ASSERT_EQ(strokes.size(), 3U) << "255 and 77 are no classes";
  for (const DiscStroke& stroke : strokes) EXPECT_EQ(stroke.colorClass, DiscStroke::kBackground);
}

TEST(LabelStrokes, imagesWithoutAnInsideHaveNone) {
  EXPECT_THAT(strokesIn(labelsOf(320, 2, kGreen), 10), IsEmpty());
  EXPECT_THAT(strokesIn(labelsOf(2, 100, kGreen), 10), IsEmpty());
  EXPECT_THAT(strokesIn(labelsOf(1, 1, kGreen), 10), IsEmpty());
  EXPECT_THAT(strokesIn(labelsOf(320, 100, kGreen), 0), IsEmpty());
}

}  // namespace
}  // namespace app
