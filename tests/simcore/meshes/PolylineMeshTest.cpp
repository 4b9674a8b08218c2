// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/meshes/PolylineMesh.h"

#include <gtest/gtest.h>

#include <limits>

namespace simcore {
namespace {

using robotlink::Vector2;

/// The volume that a closed mesh encloses, with triangles that are counter-clockwise seen from outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& triangle : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[triangle[0]].cast<double>(),
                          b = mesh.vertices[triangle[1]].cast<double>(),
                          c = mesh.vertices[triangle[2]].cast<double>();
    sum += a.dot(b.cross(c)) / 6;
  }
  return sum;
}

/// Normals have length 1, and are on the side from which their triangles are counter-clockwise.
void expectNormalsOutside(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh.vertices.size());
    const Eigen::Vector3f across = (mesh.vertices[triangle[1]] - mesh.vertices[triangle[0]])
                                       .cross(mesh.vertices[triangle[2]] - mesh.vertices[triangle[0]]);
    for (const std::uint32_t corner : triangle) {
      EXPECT_NEAR(mesh.normals[corner].norm(), 1, 1e-5);
      EXPECT_GT(across.dot(mesh.normals[corner]), 0);
    }
  }
}

struct Polygon {
  const char* what;
  std::vector<Vector2> corners;
  double area;
};

const Polygon kPolygons[] = {
    {"a triangle", {{0, 0}, {2, 0}, {0, 1}}, 1},
    {"a square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1},
    {"a square, clockwise", {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 1},
    {"a square whose last corner is the first", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, 1},
    {"a square with a corner twice", {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}, 1},
    {"an L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3},
    {"a C", {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}}, 7},
    {"a star", {{0, 3}, {-0.5, 0.5}, {-3, 0}, {-0.5, -0.5}, {0, -3}, {0.5, -0.5}, {3, 0}, {0.5, 0.5}}, 6},
};

TEST(PolylineMesh, aPolygonIsExtrudedToItsVolume) {
  for (const Polygon& polygon : kPolygons) {
    SCOPED_TRACE(polygon.what);
    for (const double height : {0.5, 2.0}) {
      const auto mesh = extrudedMesh(polygon.corners, height);
      ASSERT_TRUE(mesh) << mesh.error();
      EXPECT_NEAR(volume(*mesh), polygon.area * height, 1e-5);
      expectNormalsOutside(*mesh);
      float low = 9, high = -9;
      for (const auto& vertex : mesh->vertices) {
        low = std::min(low, vertex.z());
        high = std::max(high, vertex.z());
      }
      EXPECT_EQ(low, 0);
      EXPECT_EQ(high, static_cast<float>(height));
    }
  }
}

TEST(PolylineMesh, whatIsNoPolygonIsRefusedWithAReason) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  struct Case {
    std::vector<Vector2> corners;
    const char* reason;
  };
  const Case cases[] = {
      {{}, "it has 0"},
      {{{0, 0}, {1, 0}}, "it has 2"},
      {{{0, 0}, {1, 0}, {0, 0}}, "it has 2"},
      {{{0, 0}, {1, 0}, {2, 0}}, "it has no area"},
      {{{0, 0}, {1, 0}, {kNowhere, 1}}, "it has no area"},
      {{{0, 0}, {4, 0}, {0.5, 3}, {2, -2}, {3.5, 3}}, "it crosses itself"},
      {{{0, 0}, {3, 2}, {3, 0}, {0, 1}}, "it crosses itself"},
      {std::vector<Vector2>(2000, Vector2(1, 1)), "it has 1"},
  };
  for (const Case& one : cases) {
    const auto mesh = extrudedMesh(one.corners, 1);
    ASSERT_FALSE(mesh) << one.reason;
    EXPECT_EQ(mesh.error(), one.reason);
  }
}

TEST(PolylineMesh, aSpiralOfAThousandCornersIsCutIntoItsTriangles) {
  // Its ears are few, and far from each other: a search from the beginning for each would take long.
  std::vector<Vector2> corners;
  const auto add = [&](double radius, int i) {
    corners.emplace_back(std::cos(i * 0.1) * (radius + i * 0.02), std::sin(i * 0.1) * (radius + i * 0.02));
  };
  for (int i = 0; i < 490; ++i) add(1, i);
  for (int i = 489; i >= 0; --i) add(0.98, i);
  const auto mesh = extrudedMesh(corners, 1);
  ASSERT_TRUE(mesh) << mesh.error();
  double area = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  EXPECT_NEAR(volume(*mesh), std::abs(area), 1e-3);
  expectNormalsOutside(*mesh);
}

TEST(PolylineMesh, aCircleOfAThousandCornersIsTheLargest) {
  const auto circle = [](int count) {
    std::vector<Vector2> corners;
    for (int i = 0; i < count; ++i)
      corners.emplace_back(std::cos(2 * robotlink::kPi * i / count),
                           std::sin(2 * robotlink::kPi * i / count));
    return corners;
  };
  const auto mesh = extrudedMesh(circle(1000), 1);
  ASSERT_TRUE(mesh) << mesh.error();
  EXPECT_NEAR(volume(*mesh), robotlink::kPi, 1e-4);
  EXPECT_FALSE(extrudedMesh(circle(1001), 1));
}

TEST(PolylineMesh, aConeHasItsTipAboveItsBase) {
  const Mesh cone = coneMesh(0.5F, 2, 200);
  EXPECT_NEAR(volume(cone), robotlink::kPi * 0.25 * 2 / 3, 1e-3);
  expectNormalsOutside(cone);
  for (const auto& vertex : cone.vertices) {
    // On the base's rim or center, or at the tip.
    const float radius = std::hypot(vertex.x(), vertex.y());
    if (vertex.z() > 0) {
      EXPECT_NEAR(radius, 0, 1e-6);
    }
    EXPECT_NEAR(std::abs(vertex.z()), 1, 1e-6);
    EXPECT_LE(radius, 0.5F + 1e-6F);
  }
}

TEST(PolylineMesh, aConeHasThreeSidesAtLeast) {
  EXPECT_EQ(coneMesh(1, 1, 0).triangles.size(), 6U);
  EXPECT_EQ(coneMesh(1, 1, 12).triangles.size(), 24U);
}

}  // namespace
}  // namespace simcore
