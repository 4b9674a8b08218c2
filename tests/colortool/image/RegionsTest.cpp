// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/Regions.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "robotlink/base/Random.h"

namespace colortool {
namespace {

using robotlink::Image;

/// '.' is none, digits are classes.
Image painted(const std::vector<std::string>& rows) {
  Image image(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()),
              robotlink::PixelFormat::kMono8);
  for (std::size_t y = 0; y < rows.size(); ++y)
    for (std::size_t x = 0; x < rows[y].size(); ++x)
      image.row(static_cast<int>(y))[x] = rows[y][x] == '.' ? 0 : static_cast<std::uint8_t>(rows[y][x] - '0');
  return image;
}

RegionFinder finder(int minimumArea = 1, int maximum = 64) {
  return RegionFinder({minimumArea, maximum});
}

TEST(RegionFinder, measuresAreaBoxAndCenter) {
  auto rows = finder();
  const auto regions = rows.findInRows(painted({"......", ".11...", ".111..", "......"}).view());
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].area, 5);
  EXPECT_EQ(regions[0].left, 1);
  EXPECT_EQ(regions[0].top, 1);
  EXPECT_EQ(regions[0].right, 4);
  EXPECT_EQ(regions[0].bottom, 3);
  EXPECT_DOUBLE_EQ(regions[0].centerX, (1.5 + 2.5 + 1.5 + 2.5 + 3.5) / 5);
  EXPECT_DOUBLE_EQ(regions[0].centerY, (1.5 * 2 + 2.5 * 3) / 5);
}

TEST(RegionFinder, joinsArmsThatMeetFurtherDown) {
  auto rows = finder();
  const auto regions = rows.findInRows(painted({"1.1.1", "1.1.1", "11111"}).view());
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].area, 11);
}

TEST(RegionFinder, joinsByCornersButNotAcrossClasses) {
  auto rows = finder();
  const auto regions = rows.findInRows(painted({"1..2", ".12.", "1..2"}).view());
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].area, 3);
  EXPECT_EQ(regions[1].colorClass, 2);
  EXPECT_EQ(regions[1].area, 3);
}

TEST(RegionFinder, sortsByClassThenBySizeAndDropsTheSmall) {
  auto rows = finder(2);
  const auto regions = rows.findInRows(painted({"22.1", "....", "11.2", "1..."}).view());
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].area, 3);
  EXPECT_EQ(regions[1].colorClass, 2);
  EXPECT_EQ(regions[1].area, 2);
}

TEST(RegionFinder, keepsOnlyTheLargestOfAClass) {
  auto rows = finder(1, 2);
  const auto regions = rows.findInRows(painted({"1.11.111", "2......."}).view());
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(regions[0].area, 3);
  EXPECT_EQ(regions[1].area, 2);
  EXPECT_EQ(regions[2].colorClass, 2);
}

TEST(RegionFinder, findsTheSameInAllColumnsAsInAllRows) {
  robotlink::Random random(3);
  Image image(40, 30, robotlink::PixelFormat::kMono8);
  for (auto& pixel : image.data)
    pixel = random.uniform() < 0.5 ? 0 : static_cast<std::uint8_t>(random.uniform(1, 4));
  auto rows = finder(), columns = finder();
  EXPECT_THAT(columns.findInColumns(image.view(), 1),
              testing::Pointwise(testing::Truly([](const auto& pair) {
                                   const Region &a = std::get<0>(pair), &b = std::get<1>(pair);
                                   return a.colorClass == b.colorClass && a.area == b.area;
                                 }),
                                 rows.findInRows(image.view())));
}

TEST(RegionFinder, findsTheEndsOfRunsOfAnyLength) {
  for (int begin = 0; begin < 20; ++begin) {
    for (int length = 1; length < 40; ++length) {
      for (const std::uint8_t around : {std::uint8_t{0}, std::uint8_t{129}}) {
        Image image(begin + length + begin % 3, 1, robotlink::PixelFormat::kMono8);
        std::ranges::fill(image.data, around);
        std::fill_n(image.data.begin() + begin, length, std::uint8_t{1});
        auto rows = finder();
        const auto regions = rows.findInRows(image.view());
        ASSERT_FALSE(regions.empty());
        EXPECT_EQ(regions[0].left, begin);
        EXPECT_EQ(regions[0].area, length);
      }
    }
  }
}

TEST(RegionFinder, estimatesSizesFromScanLines) {
  Image image(60, 40, robotlink::PixelFormat::kMono8);
  for (int y = 10; y < 30; ++y)
    for (int x = 20; x < 44; ++x) image.row(y)[x] = 1;
  auto columns = finder();
  const auto regions = columns.findInColumns(image.view(), 4);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].height(), 20);
  EXPECT_NEAR(regions[0].width(), 24, 4);
  EXPECT_NEAR(regions[0].area, 480, 80);
  EXPECT_NEAR(regions[0].centerX, 32, 2);
}

TEST(RegionFinder, keepsScanLineBoxesInsideTheImage) {
  Image image(10, 3, robotlink::PixelFormat::kMono8);
  std::ranges::fill(image.data, 1);
  auto columns = finder();
  const auto regions = columns.findInColumns(image.view(), 4);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].right, 8);  // the last line would stand at 10
  EXPECT_EQ(regions[0].area, 24);
}

TEST(RegionFinder, findsNothingInNothing) {
  auto rows = finder();
  EXPECT_TRUE(rows.findInRows({}).empty());
  EXPECT_TRUE(rows.findInColumns({}, 3).empty());
}

}  // namespace
}  // namespace colortool
