// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorSpaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace colortool {
namespace {

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

void expectNear(const Eigen::Vector3f& value, const Eigen::Vector3f& expected, float tolerance = 1e-4F) {
  EXPECT_LE((value - expected).cwiseAbs().maxCoeff(), tolerance)
      << value.transpose() << " instead of " << expected.transpose();
}

ColorValue yCbCrOf(int r, int g, int b) {
  return valueOf(robotlink::toYCbCr(
      {static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)}));
}

TEST(ColorSpacesTest, rgbIsWhatImagesHave) {
  for (const robotlink::YCbCr color : {robotlink::YCbCr{140, 60, 200}, {90, 110, 90}, {30, 150, 120}}) {
    const robotlink::Rgb rgb = robotlink::toRgb(color);
    expectNear(rgbOf(valueOf(color)).cwiseMax(0.F).cwiseMin(255.F),
               {static_cast<float>(rgb.r), static_cast<float>(rgb.g), static_cast<float>(rgb.b)}, 1.01F);
  }
}

TEST(ColorSpacesTest, yCbCrHasColorsThatRgbHasNot) {
  EXPECT_TRUE(hasRgb({128, 128, 128}));
  EXPECT_TRUE(hasRgb(yCbCrOf(255, 0, 0), 2));
  EXPECT_FALSE(hasRgb({0, 255, 255}, 2));
  EXPECT_FALSE(hasRgb({250, 60, 128}, 2));
}

// Hues of the book's figure 6.15, and its formulas by hand for (0.6, 0.3, 0.15).
TEST(ColorSpacesTest, hsiIsThatOfGonzalezAndWoods) {
  expectNear(hsiOf({1, 0, 0}), {0, 1, 1.F / 3});
  expectNear(hsiOf({1, 1, 0}), {1.F / 6, 1, 2.F / 3});
  expectNear(hsiOf({0, 1, 0}), {2.F / 6, 1, 1.F / 3});
  expectNear(hsiOf({0, 1, 1}), {3.F / 6, 1, 2.F / 3});
  expectNear(hsiOf({0, 0, 1}), {4.F / 6, 1, 1.F / 3});
  expectNear(hsiOf({1, 0, 1}), {5.F / 6, 1, 2.F / 3});
  expectNear(hsiOf({1, 1, 1}), {0, 0, 1});
  expectNear(hsiOf({0, 0, 0}), {0, 0, 0});
  const float angle = std::acos(0.5F * (0.3F + 0.45F) / std::sqrt(0.3F * 0.3F + 0.45F * 0.15F));
  expectNear(hsiOf({0.6F, 0.3F, 0.15F}), {angle / kTurn, 1 - 0.15F / 0.35F, 0.35F});
  expectNear(hsiOf({0.6F, 0.15F, 0.3F}), {1 - angle / kTurn, 1 - 0.15F / 0.35F, 0.35F});
}

// Computed by hand with the paper's formulas.
TEST(ColorSpacesTest, tslIsThatOfTerrillon) {
  // Red: r' = 2/3, g' = -1/3. Blue: both -1/3. Green: r' = -1/3, g' = 2/3.
  expectNear(tslOf({1, 0, 0}), {std::atan(-2.F) / kTurn + 0.75F, 1, 0.299F});
  expectNear(tslOf({0, 0, 1}), {std::atan(1.F) / kTurn + 0.75F, std::sqrt(0.4F), 0.114F});
  expectNear(tslOf({0, 1, 0}), {std::atan(-0.5F) / kTurn + 0.25F, 1, 0.587F});
  expectNear(tslOf({1, 1, 1}), {0, 0, 1});
  expectNear(tslOf({0, 0, 0}), {0, 0, 0});
  const float red = 0.5F - 1.F / 3, green = 0.375F - 1.F / 3;
  expectNear(tslOf({0.8F, 0.6F, 0.2F}),
             {std::atan(red / green) / kTurn + 0.25F, std::sqrt(1.8F * (red * red + green * green)),
              0.299F * 0.8F + 0.587F * 0.6F + 0.114F * 0.2F});
}

TEST(ColorSpacesTest, tintGoesOnWhereGreenIsAThird) {
  const float before = tslOf({0.5F, 0.3334F, 0.1666F})[0], after = tslOf({0.5F, 0.3332F, 0.1668F})[0];
  EXPECT_NEAR(before, after, 0.001F);
  EXPECT_NEAR(before, 0.5F, 0.001F);
}

TEST(ColorSpacesTest, allColorsHaveAPlaceInTheCube) {
  for (const ColorSpace space : kColorSpaces) {
    float lowest = 1, highest = -1;
    for (float y = 0; y <= 255; y += 15) {
      for (float cb = 0; cb <= 255; cb += 15) {
        for (float cr = 0; cr <= 255; cr += 15) {
          const Eigen::Vector3f place = placeIn(space, {y, cb, cr});
          ASSERT_TRUE(place.allFinite()) << nameOf(space);
          ASSERT_LE(place.cwiseAbs().maxCoeff(), 0.5001F) << nameOf(space);
          ASSERT_TRUE(!isCylinder(space) || place.head<2>().norm() <= 0.5001F) << nameOf(space);
          lowest = std::min(lowest, place.z());
          highest = std::max(highest, place.z());
        }
      }
    }
    EXPECT_LT(lowest, -0.45F) << nameOf(space);
    EXPECT_GT(highest, 0.45F) << nameOf(space);
  }
}

TEST(ColorSpacesTest, placesFollowTheChannels) {
  expectNear(placeIn(ColorSpace::kYCbCr, {255, 51, 204}), {-0.3F, 0.3F, 0.5F});
  expectNear(placeIn(ColorSpace::kRgb, yCbCrOf(255, 0, 0)), {0.5F, -0.5F, -0.5F}, 0.01F);
  // Yellow: a sixth of a turn from x to y, on the surface.
  expectNear(placeIn(ColorSpace::kHsi, yCbCrOf(255, 255, 0)),
             {0.5F * std::cos(kTurn / 6), 0.5F * std::sin(kTurn / 6), 2.F / 3 - 0.5F}, 0.01F);
  // Gray is on the axis.
  for (const ColorSpace space : {ColorSpace::kHsi, ColorSpace::kTsl})
    expectNear(placeIn(space, {100, 128, 128}), {0, 0, 100.F / 255 - 0.5F});
}

TEST(ColorSpacesTest, channelsAreNamed) {
  for (const ColorSpace space : kColorSpaces) {
    std::string joined;
    for (const char* name : channelNames(space)) joined += name;
    EXPECT_EQ(joined, nameOf(space));
  }
}

}  // namespace
}  // namespace colortool
