// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/PointFilter.h"

#include <gmock/gmock.h>

#include <cmath>

namespace robotlink {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using Points = std::vector<std::pair<double, double>>;

Points filtered(PointFilter& filter, const Points& points) {
  Points results;
  for (const auto& [time, value] : points) {
    if (const auto result = filter.next({time, value})) results.emplace_back(result->time, result->value);
  }
  return results;
}

Points filtered(const std::string& text, const Points& points) {
  auto filter = PointFilter::parse(text);
  EXPECT_TRUE(filter) << filter.error().describe();
  return filtered(*filter, points);
}

}  // namespace

TEST(PointFilterTest, aFilterWithoutStepsPassesAll) {
  EXPECT_THAT(filtered("", {{1, 2}, {3, 4}}), ElementsAre(Pair(1, 2), Pair(3, 4)));
  EXPECT_TRUE(PointFilter::parse(" ")->isEmpty());
}

TEST(PointFilterTest, derivesAndIntegrates) {
  EXPECT_THAT(filtered("derivative", {{0, 1}, {0.5, 2}, {0.5, 9}, {1.5, 0}}),
              ElementsAre(Pair(0.5, 2), Pair(1.5, -2)));
  EXPECT_THAT(filtered("integral", {{0, 1}, {1, 3}, {3, 3}}),
              ElementsAre(Pair(0, 0), Pair(1, 2), Pair(3, 8)));
}

TEST(PointFilterTest, averagesAndMediansAreOfTheLastSeconds) {
  const Points points{{0, 1}, {1, 5}, {2, 3}, {3, 100}, {9, 7}};
  EXPECT_THAT(filtered("average 2.5", points),
              ElementsAre(Pair(0, 1), Pair(1, 3), Pair(2, 3), Pair(3, 36), Pair(9, 7)));
  EXPECT_THAT(filtered("median 2.5", points),
              ElementsAre(Pair(0, 1), Pair(1, 3), Pair(2, 3), Pair(3, 5), Pair(9, 7)));
}

TEST(PointFilterTest, aLowPassApproachesAStep) {
  const auto points = filtered("low-pass 2", {{0, 0}, {2, 1}, {200, 1}});
  EXPECT_THAT(points, ElementsAre(Pair(0, 0), Pair(2, DoubleNear(1 - std::exp(-1), 1e-12)),
                                  Pair(200, DoubleNear(1, 1e-12))));
}

TEST(PointFilterTest, stepsAreDoneOneAfterTheOther) {
  EXPECT_THAT(filtered("scale 2 | offset -1|derivative", {{0, 1}, {1, 3}}), ElementsAre(Pair(1, 4)));
}

TEST(PointFilterTest, whatIsNoNumberPassesAndCountsForNothing) {
  const auto points = filtered("average 10", {{0, 2}, {1, std::nan("")}, {2, 4}});
  ASSERT_EQ(points.size(), 3U);
  EXPECT_TRUE(std::isnan(points[1].second));
  EXPECT_EQ(points[2].second, 3);
}

TEST(PointFilterTest, beginsAnew) {
  for (const char* text : {"derivative", "integral", "average 5", "median 5", "low-pass 5", "scale 2"}) {
    auto filter = PointFilter::parse(text);
    const Points points{{1, 3}, {2, 9}, {3, 1}};
    const Points first = filtered(*filter, points);
    filter->restart();
    EXPECT_EQ(filtered(*filter, points), first) << text;
  }
}

TEST(PointFilterTest, latePointsDoNotBreakIt) {
  for (const char* text : {"derivative", "integral", "average 5", "median 5", "low-pass 5"}) {
    for (const auto& [time, value] : filtered(text, {{1, 3}, {2, 9}, {1.5, 100}, {3, 1}}))
      EXPECT_TRUE(std::isfinite(value) && time != 1.5) << text;
  }
}

TEST(PointFilterTest, errorsSayWhatIsExpected) {
  EXPECT_THAT(PointFilter::parse("derivate").error().text, HasSubstr("derivative"));
  EXPECT_THAT(PointFilter::parse("average").error().text, HasSubstr("seconds above 0"));
  EXPECT_FALSE(PointFilter::parse("average -1"));
  EXPECT_FALSE(PointFilter::parse("scale"));
  EXPECT_FALSE(PointFilter::parse("scale nan"));
  EXPECT_FALSE(PointFilter::parse("derivative 3"));
  EXPECT_FALSE(PointFilter::parse("| derivative"));
}

TEST(PointFilterTest, unitsFollow) {
  EXPECT_EQ(PointFilter::parse("average 1 | derivative")->unit("m"), "m/s");
  EXPECT_EQ(PointFilter::parse("integral")->unit("A"), "A s");
  EXPECT_EQ(PointFilter::parse("scale 57.3")->unit("rad"), "");
  EXPECT_EQ(PointFilter::parse("offset 1")->unit("rad"), "rad");
}

}  // namespace robotlink
