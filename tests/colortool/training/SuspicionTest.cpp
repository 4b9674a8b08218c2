// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/Suspicion.h"

#include <gtest/gtest.h>

#include "colortool/image/ClassPresets.h"

namespace colortool {
namespace {

using robotlink::YCbCr;

constexpr std::uint8_t kOrangeClass = 1, kBlueClass = 2, kGreenClass = 3;
const ColorClasses kSuspectClasses({{"orange", {255, 128, 0}},
                                    {"blue", {0, 80, 255}},
                                    {"green", {0, 160, 40}}});

/// A color that a table below has for each class; none is black.
YCbCr colorOf(std::uint8_t colorClass) {
  return {static_cast<std::uint8_t>(40 * colorClass), 128, 128};
}
ColorTable table() {
  ColorTable table;
  for (const std::uint8_t one : {kOrangeClass, kBlueClass, kGreenClass}) table.setCell(10 * one, 32, 32, one);
  return table;
}
std::vector<std::uint8_t> margins(std::uint8_t orange = 255) {
  std::vector<std::uint8_t> margins(ColorTable::kCellCount, 255);
  margins[ColorTable::cellOf(colorOf(kOrangeClass))] = orange;
  return margins;
}

/// 320 x 240, painted in rectangles.
struct Picture {
  robotlink::Image image{320, 240, robotlink::PixelFormat::kYuyv};
  Picture() { fill(0, 0, 320, 240, 0); }
  /// x and width even, since two pixels share their chroma.
  void fill(int x, int y, int width, int height, std::uint8_t colorClass) {
    const YCbCr color = colorOf(colorClass);
    for (int row = y; row < y + height; ++row) {
      for (int column = x; column < x + width; ++column) {
        image.row(row)[2 * column] = color.y;
        image.row(row)[2 * column + 1] = 128;
      }
    }
  }
};

SuspiciousPixels found(const Picture& picture, std::span<const std::uint8_t> margins = {}) {
  SuspicionMeter meter(table(), margins, objectClasses(kSuspectClasses));
  return meter.measure(picture.image.view()).pixels;
}

TEST(Suspicion, specksOfColoredClassesAreSuspicious) {
  Picture picture;
  picture.fill(40, 40, 30, 30, kOrangeClass);
  EXPECT_EQ(found(picture), SuspiciousPixels{}) << "a ball";
  picture.fill(200, 50, 3, 3, kOrangeClass);
  picture.fill(300, 200, 2, 1, kBlueClass);
  picture.fill(100, 200, 2, 1, kGreenClass);
  EXPECT_EQ(found(picture), (SuspiciousPixels{11, 0, 0, 0})) << "green is everywhere";
  picture.fill(203, 53, 3, 3, kOrangeClass);
  EXPECT_EQ(found(picture).specks, 2U) << "it touches by a corner, and is one of 18 pixels";
}

TEST(Suspicion, isTheSameInImagesOfAnySize) {
  robotlink::Image small(32, 24, robotlink::PixelFormat::kYuyv);
  for (std::size_t i = 0; i < small.data.size(); ++i) small.data[i] = i % 2 == 0 ? 0 : 128;
  small.row(5)[2 * 7] = colorOf(kOrangeClass).y;
  SuspicionMeter meter(table(), {}, objectClasses(kSuspectClasses));
  EXPECT_EQ(meter.measure(small.view()).pixels.specks, 0U) << "a pixel of 768 is more than 1/6400";
  EXPECT_EQ(meter.classes().row(5)[7], kOrangeClass);
}

TEST(Suspicion, aPatchInsideOfAnotherThingIsSuspicious) {
  Picture goal;
  goal.fill(100, 50, 100, 60, kBlueClass);
  goal.fill(120, 70, 6, 5, kOrangeClass);
  EXPECT_EQ(found(goal), (SuspiciousPixels{0, 30, 0, 0}));
  goal.fill(110, 60, 20, 30, kOrangeClass);
  EXPECT_EQ(found(goal), SuspiciousPixels{}) << "a ball in front of the goal";
  Picture carpet;
  carpet.fill(100, 50, 100, 60, kGreenClass);
  carpet.fill(120, 70, 6, 5, kOrangeClass);
  EXPECT_EQ(found(carpet), SuspiciousPixels{}) << "a ball far away";
  Picture post;
  post.fill(100, 50, 20, 60, kBlueClass);
  post.fill(118, 70, 6, 5, kOrangeClass);
  EXPECT_EQ(found(post), SuspiciousPixels{}) << "in front of a post";
  Picture edge;
  edge.fill(0, 0, 100, 60, kBlueClass);
  edge.fill(20, 0, 6, 5, kOrangeClass);
  EXPECT_EQ(found(edge), SuspiciousPixels{}) << "what is beyond the edge is not known";
}

TEST(Suspicion, pixelsWithASmallMarginAreAmbiguous) {
  Picture picture;
  picture.fill(40, 40, 30, 30, kOrangeClass);
  picture.fill(200, 50, 3, 3, kOrangeClass);
  EXPECT_EQ(found(picture, margins(200)), (SuspiciousPixels{9, 0, 0, 0}));
  EXPECT_EQ(found(picture, margins(20)), (SuspiciousPixels{9, 0, 900, 0})) << "each pixel counts once";
}

TEST(Suspicion, whatCoversTheImageIsHardlyAThing) {
  Picture picture;
  picture.fill(0, 0, 320, 90, kBlueClass);
  EXPECT_EQ(found(picture), SuspiciousPixels{}) << "a goal nearby";
  picture.fill(0, 90, 320, 60, kBlueClass);
  EXPECT_EQ(found(picture), (SuspiciousPixels{0, 0, 0, 320 * 150}));
  picture.fill(0, 0, 320, 240, kGreenClass);
  EXPECT_EQ(found(picture), SuspiciousPixels{}) << "the carpet does";
  picture.fill(0, 0, 320, 240, kOrangeClass);
  EXPECT_EQ(found(picture, margins(20)), (SuspiciousPixels{0, 0, 320 * 240, 0})) << "each pixel counts once";
}

TEST(Suspicion, isCountedByClassAndWeighed) {
  Picture picture;
  picture.fill(40, 40, 30, 30, kOrangeClass);
  picture.fill(200, 50, 3, 3, kBlueClass);
  SuspicionMeter meter(table(), margins(20), objectClasses(kSuspectClasses),
                       {.speckWeight = 2, .ambiguousWeight = 0.5});
  const Suspicion found = meter.measure(picture.image.view());
  ASSERT_EQ(found.byClass.size(), 4U);
  EXPECT_EQ(found.byClass[kOrangeClass], (SuspiciousPixels{0, 0, 900, 0}));
  EXPECT_EQ(found.byClass[kBlueClass], (SuspiciousPixels{9, 0, 0, 0}));
  EXPECT_EQ(found.byClass[kGreenClass], SuspiciousPixels{});
  EXPECT_DOUBLE_EQ(found.score, 2 * 9 + 0.5 * 900);
  EXPECT_EQ(meter.measure({}).score, 0) << "no image";
  Picture empty;
  EXPECT_EQ(meter.measure(empty.image.view()).score, 0);
}

TEST(Suspicion, looksAtWhatThingsHaveByTheirColor) {
  for (const ClassPreset& preset : classPresets()) {
    const ColorClasses classes = preset.classes();
    const std::vector<bool> things = objectClasses(classes);
    ASSERT_EQ(things.size(), static_cast<std::size_t>(classes.size()));
    EXPECT_FALSE(things[0]);
    for (int i = 1; i < classes.size(); ++i) {
      const std::string& name = classes.name(i);
      EXPECT_EQ(things[static_cast<std::size_t>(i)], name != "green" && name != "white" && name != "black")
          << preset.name << " " << name;
    }
  }
}

}  // namespace
}  // namespace colortool
