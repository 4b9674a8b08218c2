// SPDX-License-Identifier: GPL-3.0-or-later
// Lines of the field in rendered images, against the edges of the field's description.
#include <gtest/gtest.h>

#include <cmath>

#include "modules/modeling/localization/FieldEdgeMap.h"
#include "modules/perception/lines/FieldLineScanner.h"
#include "modules/perception/lines/SegmentFinder.h"
#include "tests/modules/perception/FieldCamera.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

class FieldLines : public testing::Test {
 protected:
  const std::vector<LinePoint>& look(const Pose2& robot, const NeckAngles& neck) {
    const CameraView view = FieldCamera::view(neck);
    return scanner_.find(world_.look(robot, view).view(), view);
  }
  FieldCamera world_;
  FieldEdgeMap edges_{world_.field()};
  FieldLineScanner scanner_{{}};
};

TEST_F(FieldLines, pointsAreOnTheLinesOfTheField) {
  int points = 0, near = 0, along = 0, directed = 0;
  for (const Pose2& robot : {Pose2{-0.8, 0, 0}, Pose2{-0.9, 0.4, 3}, Pose2{0.5, -0.6, -0.9},
                             Pose2{1.1, 0.3, 0.4}, Pose2{-0.3, 0.8, 1.5}, Pose2{1.5, -0.7, -0.5}}) {
    for (const LinePoint& point : look(robot, {-0.35, 0, 0})) {
      const Vector2 inField = robot * point.inRobot;
      const double tolerance = 0.03 + 0.05 * point.inRobot.norm();
      const double distance = edges_.distance(inField, NAN);
      ++points;
      near += distance < tolerance ? 1 : 0;
      if (distance >= tolerance || !std::isfinite(point.direction)) continue;
      ++directed;
      along += edges_.distance(inField, point.direction + robot.heading) < 2 * tolerance ? 1 : 0;
    }
  }
  EXPECT_GT(points, 100);
  EXPECT_GT(near, 0.93 * points);
  EXPECT_GT(directed, 0.7 * near);
  EXPECT_GT(along, 0.85 * directed);
}

TEST_F(FieldLines, theSameAreSeenInDimAndWarmLight) {
  const Pose2 robot{-0.5, 0.2, 0.3};
  const CameraView view = FieldCamera::view({-0.35, 0, 0});
  robotlink::Image image = world_.look(robot, view);
  const std::size_t bright = scanner_.find(image.view(), view).size();
  ASSERT_GT(bright, 10U);
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    const bool luma = i % 2 == 0;
    const int chroma = 128 + (image.data[i] - 128) * 6 / 10 + (i % 4 == 1 ? -6 : 6);
    image.data[i] = static_cast<std::uint8_t>(luma ? image.data[i] * 6 / 10 : chroma);
  }
  const std::size_t dim = scanner_.find(image.view(), view).size();
  EXPECT_GT(static_cast<double>(dim), 0.7 * static_cast<double>(bright));
}

TEST_F(FieldLines, thereAreNoneOnTheBallAndInTheGoal) {
  world_.putBall({-0.9, 0});
  for (const LinePoint& point : look({-1.4, 0, 0}, {-0.4, 0, 0}))
    EXPECT_GT((point.inRobot - Vector2(0.5, 0)).norm(), 0.06);
  EXPECT_TRUE(scanner_.find({}, {}).empty());
}

TEST_F(FieldLines, areAtMostAsManyAsAllowedAndSpreadEvenly) {
  FieldLineScanner few({.maximumPoints = 7});
  const CameraView view = FieldCamera::view({-0.35, 0, 0});
  const robotlink::Image image = world_.look({-0.5, 0.2, 0.3}, view);
  const auto& all = scanner_.find(image.view(), view);
  ASSERT_GT(all.size(), 14U);
  const auto& some = few.find(image.view(), view);
  ASSERT_EQ(some.size(), 7U);
  EXPECT_EQ(some.front().inImage, all.front().inImage);
}

TEST_F(FieldLines, segmentsLieOnEdgesFromEndToEnd) {
  SegmentFinder finder({});
  int segments = 0, right = 0;
  for (const Pose2& robot : {Pose2{-0.8, 0, 0}, Pose2{0.5, -0.6, -0.9}, Pose2{1.1, 0.3, 0.4},
                             Pose2{-0.3, 0.8, 1.5}, Pose2{1.5, -0.7, -0.5}}) {
    for (const LineSegment& segment : finder.find(look(robot, {-0.35, 0, 0}))) {
      ++segments;
      const Vector2 start = robot * segment.start, end = robot * segment.end;
      const double direction = std::atan2(end.y() - start.y(), end.x() - start.x());
      const double farthest = std::max(segment.start.norm(), segment.end.norm());
      const Vector2 middle = 0.5 * (start + end);
      const bool lies = edges_.distance(start, direction) < 0.04 + 0.06 * farthest &&
                        edges_.distance(end, direction) < 0.04 + 0.06 * farthest &&
                        edges_.distance(middle, direction) < 0.04 + 0.06 * farthest;
      right += lies ? 1 : 0;
      EXPECT_GT(segment.confidence, 0);
      EXPECT_LE(segment.confidence, 1);
    }
  }
  EXPECT_GE(segments, 6);
  EXPECT_GE(right, 0.85 * segments);
}

TEST(SegmentFinder, putsPointsTogetherAndLeavesOutTheOthers) {
  std::vector<LinePoint> points;
  for (int i = 0; i < 8; ++i) points.push_back({{}, {0.5 + 0.1 * i, 0.3}, 0});
  for (int i = 0; i < 6; ++i) points.push_back({{}, {1.0, -0.2 - 0.1 * i}, robotlink::kPi / 2});
  points.push_back({{}, {0.4, 1.0}, 0.7});
  SegmentFinder finder({});
  const auto segments = finder.find(points);
  ASSERT_EQ(segments.size(), 2U);
  EXPECT_NEAR((segments[0].end - segments[0].start).norm(), 0.7, 1e-6);
  EXPECT_NEAR((segments[1].end - segments[1].start).norm(), 0.5, 1e-6);
  EXPECT_EQ(finder.segmentOfPoint().back(), -1);
  EXPECT_EQ(finder.segmentOfPoint().front(), 0);
}

TEST(SegmentFinder, cutsALineWhereItHasNoPoints) {
  std::vector<LinePoint> points;
  for (const double x : {0.4, 0.5, 0.6, 0.7, 1.5, 1.6, 1.7, 1.8}) points.push_back({{}, {x, 0.1}, 0});
  EXPECT_EQ(SegmentFinder({}).find(points).size(), 2U);
  EXPECT_EQ(SegmentFinder({.maximumGap = 1}).find(points).size(), 1U);
}

TEST(SegmentFinder, findsNothingInFewPoints) {
  SegmentFinder finder({});
  EXPECT_TRUE(finder.find({}).empty());
  const std::vector<LinePoint> points{{Vector2::Zero(), {1, 0}, 0}, {Vector2::Zero(), {1.1, 0}, 0}};
  EXPECT_TRUE(finder.find(points).empty());
}

}  // namespace
}  // namespace modules
