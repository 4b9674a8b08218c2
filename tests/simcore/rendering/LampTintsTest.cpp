// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampTints.h"

#include <gmock/gmock.h>

#include <array>

namespace simcore::rendering {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr int kStripWidth = 3, kStripStride = 11, kStripRows = 2;

Lamp lampOfColor(float red, float green, float blue) {
  Lamp lamp;
  lamp.color = {red, green, blue};
  return lamp;
}

/// A strip of an image of 3 x 4 pixels that all show triangle 1.
class LampTintsTest : public testing::Test {
 protected:
  LampTintsTest() {
    triangles_.fill(1);
    buffer_.width = kStripWidth;
    buffer_.height = 2 * kStripRows;
    buffer_.stride = kStripStride;
    buffer_.triangle = triangles_.data();
    strip_.rows = kStripRows;
    strip_.light = light_.data();
    for (std::size_t k = 0; k < 3; ++k) strip_.color[k] = color_[k].data();
    strip_.ambient = 0.2F;
    setColor(100, 100, 100);
  }
  void setColor(float first, float second, float third) {
    color_[0].fill(first);
    color_[1].fill(second);
    color_[2].fill(third);
  }
  /// Lights all pixels by a lamp of a color.
  void addLight(LampTints& tints, const LampTints::Group& group, float light) {
    light_.fill(light);
    tints.add(group, strip_, buffer_);
  }
  std::array<float, 3> colorAt(std::size_t pixel) const {
    return {color_[0][pixel], color_[1][pixel], color_[2][pixel]};
  }

  static constexpr std::size_t kPixels = std::size_t{kStripStride} * kStripRows;
  std::array<std::int32_t, 2 * kPixels> triangles_{};
  std::array<float, kPixels> light_{};
  std::array<std::array<float, kPixels>, 3> color_{};
  VisibilityBuffer buffer_;
  Strip strip_;
};

TEST_F(LampTintsTest, whiteAndGrayLampsNeedNoGroups) {
  const LampTints tints({lampOfColor(1, 1, 1), lampOfColor(0.5F, 0.5F, 0.5F), Lamp{}});
  EXPECT_THAT(tints.groups(), IsEmpty());
  EXPECT_THAT(tints.order(), ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(LampTints({}).groups(), IsEmpty());
}

TEST_F(LampTintsTest, lampsOfOneColorAreTogetherHoweverBrightTheyAre) {
  const LampTints tints({lampOfColor(1, 0, 0), lampOfColor(1, 1, 1), lampOfColor(0.5F, 0, 0),
                         lampOfColor(0, 0, 0.25F), lampOfColor(0.5F, 0.5F, 0.5F)});
  EXPECT_THAT(tints.order(), ElementsAre(0U, 2U, 1U, 4U, 3U));
  ASSERT_EQ(tints.groups().size(), 3U);
  EXPECT_EQ(tints.groups()[0].tint, Eigen::Vector3f(1, 0, 0));
  EXPECT_EQ(tints.groups()[0].count, 2U);
  EXPECT_EQ(tints.groups()[1].first, 2U);
  EXPECT_EQ(tints.groups()[1].tint, Eigen::Vector3f(1, 1, 1));
  EXPECT_EQ(tints.groups()[2].first, 4U);
  EXPECT_EQ(tints.groups()[2].count, 1U);
  EXPECT_EQ(tints.groups()[2].tint, Eigen::Vector3f(0, 0, 1)) << "the brightness is that of the lamp";
}

TEST_F(LampTintsTest, aGrayPixelTakesTheColorOfItsLight) {
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  EXPECT_EQ(strip_.ambient, 0) << "the kernels add none";
  addLight(tints, tints.groups()[0], 0.6F);
  tints.finish(strip_, buffer_, false);
  EXPECT_FLOAT_EQ(light_[0], 0.8F);
  EXPECT_THAT(colorAt(0), ElementsAre(testing::FloatEq(100), testing::FloatEq(25), testing::FloatEq(25)));
  EXPECT_EQ(colorAt(kStripStride + 2), colorAt(0));
}

TEST_F(LampTintsTest, lightsOfSeveralColorsAddUp) {
  LampTints tints({lampOfColor(1, 0, 0), lampOfColor(0, 1, 0)});
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0.3F);
  addLight(tints, tints.groups()[1], 0.8F);
  tints.finish(strip_, buffer_, false);
  // Red 0.5, green 1, blue 0.2.
  EXPECT_FLOAT_EQ(light_[1], 1);
  EXPECT_THAT(colorAt(1), ElementsAre(testing::FloatEq(50), testing::FloatEq(100), testing::FloatEq(20)));
}

TEST_F(LampTintsTest, theColorsOfAnImageOfLumaAreTheSame) {
  // Gray: Y 100 without chroma, as RGB (100, 100, 100).
  setColor(100, 0, 0);
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0.6F);
  tints.finish(strip_, buffer_, true);
  const auto [y, cb, cr] = colorAt(0);
  EXPECT_NEAR(y + 1.402F * cr, 100, 0.01);
  EXPECT_NEAR(y - 0.344136F * cb - 0.714136F * cr, 25, 0.01);
  EXPECT_NEAR(y + 1.772F * cb, 25, 0.01);
}

TEST_F(LampTintsTest, theBackgroundKeepsItsColorAndIsFullyLit) {
  triangles_[1] = 0;
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0.6F);
  tints.finish(strip_, buffer_, false);
  EXPECT_EQ(light_[1], 1);
  EXPECT_THAT(colorAt(1), ElementsAre(100, 100, 100));
  EXPECT_FLOAT_EQ(light_[0], 0.8F);
}

TEST_F(LampTintsTest, aPixelWithoutAnyLightKeepsItsColorInTheDark) {
  strip_.ambient = 0;
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0);
  tints.finish(strip_, buffer_, false);
  EXPECT_EQ(light_[0], 0);
  EXPECT_THAT(colorAt(0), ElementsAre(100, 100, 100)) << "and is not divided by nothing";
}

TEST_F(LampTintsTest, allStripsOfAnImageHaveItsAmbientLight) {
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  // The next strip is the same one further down, whose ambient light was taken; it shows the background in
  // the first row of the image only.
  triangles_.fill(0);
  std::fill(triangles_.begin() + kPixels, triangles_.end(), 1);
  strip_.firstRow = kStripRows;
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0);
  tints.finish(strip_, buffer_, false);
  EXPECT_FLOAT_EQ(light_[0], 0.2F);
}

TEST_F(LampTintsTest, whatIsBehindTheRowsIsLeftAlone) {
  LampTints tints({lampOfColor(1, 0, 0)});
  tints.begin(strip_, buffer_);
  addLight(tints, tints.groups()[0], 0.6F);
  tints.finish(strip_, buffer_, false);
  EXPECT_EQ(light_[kStripWidth], 0.6F);
  EXPECT_THAT(colorAt(kStripWidth), ElementsAre(100, 100, 100));
}

}  // namespace
}  // namespace simcore::rendering
