// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/drawing/Shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace robotlink;

namespace {

using Corners = std::vector<Vector2>;

double area(const Corners& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(twice) / 2;
}

double areaOfTriangles(const Corners& corners, const std::vector<std::uint32_t>& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    sum += area({corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]});
  }
  return sum;
}

}  // namespace

TEST(Shapes, anEllipsesPointsLieOnItFirstOneOnItsFirstAxis) {
  const Vector2 center(3, -1);
  const auto points = ellipsePoints(center, {2, 1}, kPi / 2);
  ASSERT_EQ(points.size(), 32U);
  EXPECT_TRUE(points[0].isApprox(center + Vector2(0, 2), 1e-9));
  EXPECT_TRUE(points[8].isApprox(center + Vector2(-1, 0), 1e-9));
  for (const Vector2& point : points) {
    const Vector2 d = point - center;
    EXPECT_NEAR(d.x() * d.x() + d.y() * d.y() / 4, 1, 1e-9);
  }
}

TEST(Shapes, anArrowsHeadPointsBackOnBothSides) {
  const ArrowHead head = arrowHead({0, 0}, {10, 0}, 2);
  EXPECT_NEAR((head.left - Vector2(10, 0)).norm(), 2, 1e-9);
  EXPECT_LT(head.left.x(), 9);
  EXPECT_NEAR(head.left.y(), -head.right.y(), 1e-9);
  EXPECT_GT(head.left.y(), 0.5);
  const ArrowHead none = arrowHead({1, 1}, {1, 1}, 2);
  EXPECT_EQ(none.left, Vector2(1, 1));
}

TEST(Shapes, aConvexPolygonIsFilledExactly) {
  const Corners square{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  const auto triangles = triangulate(square);
  EXPECT_EQ(triangles.size(), 6U);
  EXPECT_NEAR(areaOfTriangles(square, triangles), 2, 1e-9);
}

TEST(Shapes, aConcavePolygonIsFilledExactlyInBothOrientations) {
  Corners arrow{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {-3, 5}, {-1, 2}};
  for (int orientation = 0; orientation < 2; ++orientation) {
    const auto triangles = triangulate(arrow);
    EXPECT_EQ(triangles.size(), (arrow.size() - 2) * 3);
    EXPECT_NEAR(areaOfTriangles(arrow, triangles), area(arrow), 1e-9);
    std::reverse(arrow.begin(), arrow.end());
  }
}

TEST(Shapes, polygonsWithoutAreaOrThatCrossThemselvesEnd) {
  EXPECT_TRUE(triangulate(Corners{}).empty());
  EXPECT_TRUE(triangulate(Corners{{0, 0}, {1, 1}}).empty());
  EXPECT_EQ(triangulate(Corners{{0, 0}, {1, 1}, {2, 2}, {3, 3}}).size(), 6U);
  EXPECT_EQ(triangulate(Corners(5, Vector2(1, 1))).size(), 9U);
  EXPECT_EQ(triangulate(Corners{{0, 0}, {2, 2}, {2, 0}, {0, 2}}).size(), 6U);
  Corners star;
  for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(i * 4 * kPi / 5), std::sin(i * 4 * kPi / 5));
  EXPECT_EQ(triangulate(star).size(), 9U);
}
