// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorCorrection.h"

#include <gtest/gtest.h>

#include <limits>

namespace colortool {
namespace {

using robotlink::YCbCr;

TEST(ColorCorrection, byDefaultNothingChanges) {
  const ColorCorrection correction;
  EXPECT_TRUE(correction.none());
  for (const int x : {0, 20, 39})
    EXPECT_EQ(correction.apply({7, 200, 255}, x, 3, 40, 30), YCbCr({7, 200, 255}));
}

TEST(ColorCorrection, theRadiusIsNoneInTheMiddleAndOneAtTheCorners) {
  EXPECT_DOUBLE_EQ(squaredImageRadius(319.5, 239.5, 640, 480), 0);
  EXPECT_DOUBLE_EQ(squaredImageRadius(-0.5, -0.5, 640, 480), 1);
  EXPECT_DOUBLE_EQ(squaredImageRadius(639.5, 479.5, 640, 480), 1);
  EXPECT_DOUBLE_EQ(squaredImageRadius(-0.5, 239.5, 640, 480), 0.64);
}

TEST(ColorCorrection, vignettingIsTakenOutOfTheCorners) {
  ColorCorrection correction;
  correction.vignetting = {{-0.3, -0.1}, {8, 4}, {-6, 0}};
  EXPECT_EQ(correction.apply({100, 110, 150}, 20, 15, 41, 31), YCbCr({100, 110, 150}));
  // Near enough to a corner: (100 * 0.6, 110 + 12, 150 - 6) is what the lens makes of it.
  EXPECT_EQ(correction.apply({60, 122, 144}, 0, 0, 1001, 1001), YCbCr({100, 110, 150}));
}

TEST(ColorCorrection, theLinesOfTheChannelsComeAfterVignetting) {
  ColorCorrection correction;
  correction.vignetting.blue = {10, 0};
  correction.channels = {{{2, 10}, {0.5, 64}, {1, -5}}};
  EXPECT_EQ(correction.apply({50, 130, 100}, 0, 0, 1001, 1001), YCbCr({110, 124, 95}));
}

TEST(ColorCorrection, whatIsTooMuchStaysWithinTheValues) {
  ColorCorrection correction;
  correction.vignetting.luma = {-5, 0};  // black, and then less than that
  correction.channels[1].offset = -500;
  EXPECT_EQ(correction.apply({20, 130, 128}, 0, 0, 40, 30), YCbCr({160, 0, 128}))
      << "at most 8 times as bright";
  EXPECT_EQ(correction.apply({200, 130, 128}, 0, 0, 40, 30), YCbCr({255, 0, 128}));
}

TEST(ColorCorrection, whatIsNoNumberIsNoticed) {
  ColorCorrection correction;
  EXPECT_TRUE(correction.isFinite());
  correction.channels[2].offset = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(correction.isFinite());
  correction = {};
  correction.vignetting.red[1] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(correction.isFinite());
}

}  // namespace
}  // namespace colortool
