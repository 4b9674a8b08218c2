// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/PaletteTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "robotlink/base/Random.h"

namespace colortool {
namespace {

const std::vector<NamedColor> kColorsOfPalette = {{"green", {0, 130, 50}},     {"white", {235, 235, 235}},
                                                  {"orange", {255, 105, 0}},   {"yellow", {250, 215, 0}},
                                                  {"skyblue", {40, 165, 235}}, {"pink", {250, 90, 160}},
                                                  {"red", {200, 15, 25}},      {"blue", {15, 30, 130}},
                                                  {"carpet", {95, 88, 84}},    {"dark", {45, 45, 50}}};
constexpr std::array<std::string_view, 8> kNames = {"orange", "pink",  "yellow", "skyblue",
                                                    "green",  "white", "red",    "blue"};

robotlink::Rgb lit(robotlink::Rgb color, double light) {
  const auto channel = [light](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(light * value), 0L, 255L));
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

robotlink::YCbCr noisy(robotlink::YCbCr color, double sigma, robotlink::Random& random) {
  const auto channel = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(std::lround(value + sigma * random.normal()), 0L, 255L));
  };
  return {channel(color.y), channel(color.cb), channel(color.cr)};
}

class PaletteTable : public testing::Test {
 protected:
  ColorClasses classes_ = ColorClasses::select(kColorsOfPalette, kNames);
  ColorTable table_ = paletteTable(kColorsOfPalette, classes_);
};

TEST_F(PaletteTable, knowsEveryColorInShadowAndInFullLightDespiteNoise) {
  robotlink::Random random(1);
  for (const NamedColor& color : kColorsOfPalette) {
    if (color.name == "white" || classes_.index(color.name) == ColorClasses::kNone) continue;
    int right = 0, all = 0;
    for (int i = 0; i < 2000; ++i, ++all) {
      const auto pixel = noisy(robotlink::toYCbCr(lit(color.rgb, random.uniform(0.4, 1))), 4, random);
      right += table_.classOf(pixel) == classes_.index(color.name) ? 1 : 0;
    }
    EXPECT_GT(right, 0.97 * all) << color.name;
  }
}

TEST_F(PaletteTable, tellsWhiteFromDarkGraysWhereTheLightIsUsual) {
  EXPECT_EQ(table_.classOf(robotlink::toYCbCr(lit({235, 235, 235}, 0.8))), classes_.index("white"));
  EXPECT_EQ(table_.classOf(robotlink::toYCbCr(lit({95, 88, 84}, 0.8))), ColorClasses::kNone);
  EXPECT_EQ(table_.classOf(robotlink::toYCbCr({45, 45, 50})), ColorClasses::kNone);
}

TEST_F(PaletteTable, takesBlackAndColorsThatTheSceneLacksForNone) {
  EXPECT_EQ(table_.classOf({0, 128, 128}), ColorClasses::kNone);
  EXPECT_EQ(table_.classOf(robotlink::toYCbCr({120, 0, 255})), ColorClasses::kNone);
  EXPECT_EQ(table_.classOf({255, 0, 0}), ColorClasses::kNone);
}

TEST_F(PaletteTable, isTheSameEveryTime) {
  EXPECT_EQ(table_, paletteTable(kColorsOfPalette, classes_));
}

TEST_F(PaletteTable, isNarrowerWithLessTolerance) {
  LightingRange strict;
  strict.tolerance = 8;
  const ColorTable narrow = paletteTable(kColorsOfPalette, classes_, strict);
  const auto size = [](const ColorTable& table) {
    return std::ranges::count_if(table.cells(), [](auto c) { return c != 0; });
  };
  EXPECT_LT(size(narrow), size(table_) / 2);
  EXPECT_EQ(narrow.classOf(robotlink::toYCbCr({255, 105, 0})), classes_.index("orange"));
}

}  // namespace
}  // namespace colortool
