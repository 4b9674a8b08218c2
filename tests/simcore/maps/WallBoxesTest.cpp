// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/maps/WallBoxes.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "robotlink/base/Random.h"

using namespace simcore;
using robotlink::GroundMap;
using robotlink::Vector2;

namespace {

const std::filesystem::path kMapFolder = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos";

/// How far a point is from a rectangle; 0 inside.
double distance(const Vector2& point, const WallBox& box) {
  const Vector2 local = Eigen::Rotation2Dd(-box.angle) * (point - box.center);
  return (local.cwiseAbs() - box.size / 2).cwiseMax(Vector2::Zero()).norm();
}

double distance(const Vector2& point, const std::vector<WallBox>& boxes) {
  double nearest = 1e9;
  for (const WallBox& box : boxes) nearest = std::min(nearest, distance(point, box));
  return nearest;
}

double distance(const Vector2& point, const GroundMap::Line& line) {
  const Vector2 along = line.to - line.from;
  const double share =
      std::clamp((point - line.from).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (point - line.from - share * along).norm();
}

/// How far a point is from what the map says of walls: lines, and squares of the resolution around points.
double distance(const Vector2& point, const GroundMap& map) {
  double nearest = 1e9;
  for (const GroundMap::Line& line : map.lines) nearest = std::min(nearest, distance(point, line));
  for (const Vector2& wall : map.points) {
    if ((wall - point).squaredNorm() < 1) {
      nearest = std::min(nearest, distance(point, WallBox{wall, {map.resolution, map.resolution}, 0}));
    }
  }
  return nearest;
}

/// Points on the outlines of boxes, the corners among them.
std::vector<Vector2> outline(const WallBox& box) {
  std::vector<Vector2> points;
  const Eigen::Rotation2Dd turn(box.angle);
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (const double y : {-0.5, 0.0, 0.5})
      points.push_back(box.center + turn * Vector2(x * box.size.x(), y * box.size.y()));
  }
  return points;
}

}  // namespace

TEST(WallBoxes, aLineIsAThinBox) {
  GroundMap map;
  map.lines = {{{1, 1}, {1, 4}}};
  const auto boxes = wallBoxes(map);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_EQ(boxes[0].center, Vector2(1, 2.5));
  EXPECT_NEAR(boxes[0].size.x(), 3.01, 1e-12);
  EXPECT_NEAR(boxes[0].size.y(), 0.01, 1e-12);
  EXPECT_NEAR(boxes[0].angle, robotlink::kPi / 2, 1e-12);
}

TEST(WallBoxes, pointsInARowBecomeOneBox) {
  GroundMap map;
  for (int i = 0; i < 50; ++i) map.points.emplace_back(0.02 * i, 1);
  const auto boxes = wallBoxes(map);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_NEAR((boxes[0].center - Vector2(0.49, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((boxes[0].size - Vector2(1, 0.02)).norm(), 0, 1e-12);
}

TEST(WallBoxes, aPointAloneIsASquareOfTheResolution) {
  GroundMap map;
  map.resolution = 0.05;
  map.points = {{0.5, -2}};
  const auto boxes = wallBoxes(map);
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_NEAR((boxes[0].center - Vector2(0.5, -2)).norm(), 0, 1e-12);
  EXPECT_NEAR((boxes[0].size - Vector2(0.05, 0.05)).norm(), 0, 1e-12);
}

TEST(WallBoxes, pointsOnALineAreOnlyTheLine) {
  GroundMap map;
  map.lines = {{{0, 0}, {2, 1}}};
  for (int i = 0; i <= 100; ++i) map.points.emplace_back(0.02 * i, 0.02 * std::round(0.5 * i));
  EXPECT_EQ(wallBoxes(map).size(), 1U);
}

TEST(WallBoxes, nothingIsLostOrThickenedByMoreThanTwoCentimeters) {
  robotlink::Random random(3);
  for (int round = 0; round < 20; ++round) {
    GroundMap map;
    map.lines = {{{random.uniform(), random.uniform()}, {random.uniform(), random.uniform()}}};
    for (int i = 0; i < 300; ++i)
      map.points.emplace_back(0.02 * static_cast<int>(random.uniform(0, 40)),
                              0.02 * static_cast<int>(random.uniform(0, 40)));
    const auto boxes = wallBoxes(map);
    EXPECT_LT(boxes.size(), 200U);
    for (const Vector2& point : map.points) {
      for (const Vector2& corner : outline({point, {0.02, 0.02}, 0}))
        ASSERT_LE(distance(corner, boxes), 0.0201);
    }
    for (const WallBox& box : boxes) {
      for (const Vector2& corner : outline(box)) ASSERT_LE(distance(corner, map), 0.0201);
    }
  }
}

/// The points of a laser that saw walls of several directions, with errors of its own, as maps of real
/// buildings have them.
GroundMap scannedBuilding() {
  robotlink::Random random(7);
  GroundMap map;
  for (int wall = 0; wall < 30; ++wall) {
    const Vector2 from{random.uniform(-20, 20), random.uniform(-20, 20)};
    const double angle = random.uniform(0, robotlink::kPi);
    const Vector2 along(std::cos(angle), std::sin(angle));
    for (int i = 0; i < 400; ++i) {
      const Vector2 error{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      const Vector2 seen = from + 0.02 * i * along + error;
      map.points.emplace_back(0.02 * std::round(seen.x() / 0.02), 0.02 * std::round(seen.y() / 0.02));
    }
  }
  return map;
}

TEST(WallBoxes, noPointOfAScannedBuildingIsLost) {
  const GroundMap map = scannedBuilding();
  const auto boxes = wallBoxes(map);
  EXPECT_LT(boxes.size(), map.points.size() / 2);
  for (std::size_t i = 0; i < map.points.size(); i += 7)
    ASSERT_LE(distance(map.points[i], boxes), 0.0101) << map.points[i].transpose();
}

TEST(WallBoxes, noPointOfABuildingIsLost) {
  const auto map = GroundMap::load(kMapFolder / "columbia.map");
  if (!map) GTEST_SKIP() << "../shared/data/arcos is not here";
  const auto boxes = wallBoxes(*map);
  EXPECT_LT(boxes.size(), 9000U);
  // All boxes by the column of 0.5 m that they reach into.
  std::map<int, std::vector<WallBox>> columns;
  const auto columnOf = [](double x) { return static_cast<int>(std::floor(2 * x)); };
  for (const WallBox& box : boxes) {
    const double half = box.size.norm() / 2 + 0.03;
    for (int c = columnOf(box.center.x() - half); c <= columnOf(box.center.x() + half); ++c)
      columns[c].push_back(box);
  }
  for (std::size_t i = 0; i < map->points.size(); i += 7) {
    const Vector2& point = map->points[i];
    ASSERT_LE(distance(point, columns[columnOf(point.x())]), 0.0101) << point.transpose();
  }
}
