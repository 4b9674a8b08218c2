// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Series.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

namespace robotlink {
namespace {

using testing::ElementsAre;
using Point = Series::Point;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Numbers that jump about, one each 0.01 s.
std::vector<Point> noise(std::size_t count) {
  std::mt19937 random(1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back({0.01 * static_cast<double>(i), static_cast<double>(random() % 1'000'003)});
  return points;
}

Series seriesOf(const std::vector<Point>& points) {
  Series series;
  for (const Point& point : points) series.append(point);
  return series;
}

std::vector<Point> pointsOf(const Series& series) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < series.size(); ++i) points.push_back(series[i]);
  return points;
}

Series::Extent plainExtent(const Series& series, std::size_t begin, std::size_t end) {
  Series::Extent extent;
  for (std::size_t i = begin; i < end; ++i) extent.add({series[i].value, series[i].value});
  return extent;
}

/// Compares the extents of many ranges with those that one gets by looking at each point.
void checkExtents(const Series& series) {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    const std::size_t a = random() % (series.size() + 1), b = random() % (series.size() + 1);
    const std::size_t begin = std::min(a, b), end = std::max(a, b);
    const auto extent = series.extent(begin, end), plain = plainExtent(series, begin, end);
    ASSERT_EQ(extent.min, plain.min) << begin << " " << end;
    ASSERT_EQ(extent.max, plain.max) << begin << " " << end;
  }
}

}  // namespace

TEST(SeriesTest, extentsAreThoseOfAllPoints) {
  for (const std::size_t count : {0, 1, 15, 16, 17, 1023, 1024, 1025, 20'000}) {
    SCOPED_TRACE(count);
    const auto points = noise(count);
    const Series series = seriesOf(points);
    EXPECT_EQ(pointsOf(series), points);
    checkExtents(series);
  }
}

TEST(SeriesTest, aLatePointGetsItsPlace) {
  auto points = noise(20'000);
  Series series = seriesOf(points);
  for (const double time : {199.005, 150.0, 100.001, -1.0}) {
    const Point late{time, 2e6 + time};
    series.append(late);
    points.insert(std::ranges::upper_bound(points, time, {}, &Point::time), late);
    ASSERT_EQ(pointsOf(series), points);
    checkExtents(series);
  }
}

TEST(SeriesTest, theOldestPointsAreDroppedToALimitOfBytes) {
  constexpr std::size_t kLimit = 200'000;
  Series series;
  const auto points = noise(40'000);
  for (const Point& point : points) {
    series.append(point);
    series.limit(kLimit);
    ASSERT_LE(series.bytes(), kLimit);
  }
  ASSERT_GT(series.size(), kLimit / Series::kBytesPerPoint - 2 * Series::kBlock);
  const std::vector<Point> newest(points.end() - static_cast<std::ptrdiff_t>(series.size()), points.end());
  EXPECT_EQ(pointsOf(series), newest);
  checkExtents(series);
  series.append({newest[5].time, -1});
  checkExtents(series);
  EXPECT_EQ(series.extent(0, series.size()).min, -1);
}

TEST(SeriesTest, aPointTakesLessThanTwentyBytes) {
  const Series series = seriesOf(noise(1'000'000));
  EXPECT_LE(static_cast<double>(series.bytes()), 1e6 * Series::kBytesPerPoint);
  EXPECT_LE(Series::kBytesPerPoint, 20U);
}

TEST(SeriesTest, indicesAreFoundByTimeAlsoAmongEqualTimes) {
  const Series series = seriesOf({{1, 0}, {2, 1}, {2, 2}, {2, 3}, {5, 4}});
  EXPECT_EQ(series.firstFrom(0), 0U);
  EXPECT_EQ(series.firstFrom(2), 1U);
  EXPECT_EQ(series.firstAfter(2), 4U);
  EXPECT_EQ(series.firstFrom(2.5), 4U);
  EXPECT_EQ(series.firstFrom(6), 5U);
  EXPECT_EQ(series.firstAfter(5), 5U);
}

TEST(SeriesTest, aRangeOfTimeIsDividedIntoColumns) {
  // Dense, then nothing, then sparse.
  std::vector<Point> points = noise(10'000);
  for (int i = 0; i < 50; ++i) points.push_back({150.0 + i, static_cast<double>(i % 7)});
  const Series series = seriesOf(points);
  constexpr auto kNone = static_cast<std::size_t>(-1);
  for (const std::size_t count : {1, 7, 500, 40'000}) {
    SCOPED_TRACE(count);
    std::size_t at = series.firstFrom(3.1), seen = 0, before = kNone;
    for (const auto& column : series.columns(3.1, 180, count)) {
      EXPECT_EQ(column.begin, at);
      ASSERT_LT(column.begin, column.end);
      EXPECT_EQ(column.first, series[column.begin].value);
      EXPECT_EQ(column.last, series[column.end - 1].value);
      EXPECT_LT(column.part, count);
      EXPECT_TRUE(before == kNone || column.part > before);
      before = column.part;
      const double width = (180 - 3.1) / static_cast<double>(count);
      EXPECT_NEAR(series[column.begin].time, 3.1 + (static_cast<double>(column.part) + 0.5) * width,
                  width * 5 / 8 + 0.01 * Series::kFan);
      const auto plain = plainExtent(series, column.begin, column.end);
      EXPECT_EQ(column.extent.min, plain.min);
      EXPECT_EQ(column.extent.max, plain.max);
      EXPECT_LT(series[column.end - 1].time - series[column.begin].time, width * 9 / 8 + 0.01 * Series::kFan);
      seen += column.end - column.begin;
      at = column.end;
    }
    EXPECT_EQ(seen, series.firstFrom(180) - series.firstFrom(3.1));
  }
}

TEST(SeriesTest, whatIsNoNumberDoesNotCount) {
  const Series series = seriesOf({{1, kNaN}, {2, 3}, {3, kNaN}, {4, -1}});
  EXPECT_EQ(series.extent(0, 4).min, -1);
  EXPECT_EQ(series.extent(0, 4).max, 3);
  EXPECT_TRUE(series.extent(0, 1).isEmpty());
}

TEST(SeriesTest, timesAreShifted) {
  Series series = seriesOf({{1, 5}, {2, 6}});
  series.shift(10);
  EXPECT_THAT(pointsOf(series), ElementsAre(Point{11, 5}, Point{12, 6}));
  series.clear();
  EXPECT_TRUE(series.empty());
  series.append({0, 1});
  EXPECT_EQ(series.size(), 1U);
}

}  // namespace robotlink
