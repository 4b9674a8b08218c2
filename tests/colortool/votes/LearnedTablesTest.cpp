// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/LearnedTables.h"

#include <gtest/gtest.h>

namespace colortool {
namespace {

using robotlink::YCbCr;
using Method = ColorTable (*)(std::span<const CellSamples>);

class LearnedTablesTest : public testing::TestWithParam<Method> {
 protected:
  static void add(std::vector<CellSamples>& samples, YCbCr color, std::uint8_t colorClass) {
    for (int i = -4; i <= 4; i += 4) {
      const YCbCr near{static_cast<std::uint8_t>(color.y + 2 * i), static_cast<std::uint8_t>(color.cb + i),
                       color.cr};
      samples.push_back({ColorTable::cellOf(near), colorClass, 10});
    }
  }
  static constexpr YCbCr kOrange{150, 90, 190}, kGreen{90, 110, 100}, kWall{180, 128, 130};
};

TEST_P(LearnedTablesTest, likeColorsAreOfAClassAndFarOnesOfNone) {
  std::vector<CellSamples> samples;
  add(samples, kOrange, 1);
  add(samples, kGreen, 2);
  add(samples, kWall, 0);
  const ColorTable table = GetParam()(samples);
  EXPECT_EQ(table.classOf(kOrange), 1);
  EXPECT_EQ(table.classOf({140, 94, 188}), 1);
  EXPECT_EQ(table.classOf(kGreen), 2);
  EXPECT_EQ(table.classOf(kWall), 0);
  EXPECT_EQ(table.classOf({90, 240, 100}), 0) << "far from all";
}

TEST_P(LearnedTablesTest, aSingleSamplePerClassIsEnoughAndASingleClassIsNot) {
  const std::vector<CellSamples> two = {{ColorTable::cellOf(kOrange), 1, 1},
                                        {ColorTable::cellOf(kGreen), 2, 1}};
  const ColorTable table = GetParam()(two);
  EXPECT_EQ(table.classOf(kOrange), 1);
  EXPECT_EQ(table.classOf(kGreen), 2);
  EXPECT_EQ(GetParam()(std::span(two).first(1)), ColorTable());
  EXPECT_EQ(GetParam()({}), ColorTable());
}

TEST_P(LearnedTablesTest, theSameSamplesMakeTheSameTable) {
  std::vector<CellSamples> samples;
  add(samples, kOrange, 1);
  add(samples, kGreen, 2);
  EXPECT_EQ(GetParam()(samples), GetParam()(samples));
}

INSTANTIATE_TEST_SUITE_P(
    Methods, LearnedTablesTest,
    testing::Values([](std::span<const CellSamples> samples) { return gaussianTable(samples); },
                    [](std::span<const CellSamples> samples) { return supportVectorTable(samples); }));

}  // namespace
}  // namespace colortool
