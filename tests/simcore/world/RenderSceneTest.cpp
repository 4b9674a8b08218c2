// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/RenderScene.h"

#include <gtest/gtest.h>

#include <map>

using namespace simcore;
using Eigen::Vector3f;

namespace {

Vector3f faceNormal(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]);
}

/// Six times the volume, positive if the triangles face outwards.
float signedVolume(const Mesh& mesh) {
  float sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]]));
  }
  return sum / 6;
}

/// Every edge of a closed mesh is walked once each way; vertices are compared by place.
bool isClosed(const Mesh& mesh) {
  const auto key = [&](std::uint32_t v) {
    const Vector3f p = mesh.vertices[v] * 1e5F;
    return std::array{std::lround(p.x()), std::lround(p.y()), std::lround(p.z())};
  };
  std::map<std::pair<std::array<long, 3>, std::array<long, 3>>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = key(t[i]), b = key(t[(i + 1) % 3]);
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

std::vector<Mesh> shapes() {
  return {boxMesh({0.2F, 0.4F, 0.6F}), sphereMesh(0.1F),    cylinderMesh(0.1F, 0.3F),
          capsuleMesh(0.1F, 0.3F),     sphereMesh(0.1F, 3), cylinderMesh(0.1F, 0.3F, 5),
          capsuleMesh(0.1F, 0.3F, 4)};
}

}  // namespace

TEST(RenderScene, shapesAreClosedAndFaceOutwards) {
  for (const Mesh& mesh : shapes()) {
    EXPECT_TRUE(isClosed(mesh));
    EXPECT_GT(signedVolume(mesh), 0);
    for (const auto& t : mesh.triangles) {
      const Vector3f normal = faceNormal(mesh, t);
      EXPECT_GT(normal.norm(), 0) << "no triangle without an area";
      for (const std::uint32_t vertex : t) EXPECT_GT(normal.dot(mesh.normals[vertex]), 0);
    }
  }
}

TEST(RenderScene, normalsAreOfUnitLengthOneAVertex) {
  for (const Mesh& mesh : shapes()) {
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
    for (const Vector3f& normal : mesh.normals) EXPECT_NEAR(normal.norm(), 1, 1e-6);
  }
}

TEST(RenderScene, shapesHaveTheirSizes) {
  EXPECT_NEAR(signedVolume(boxMesh({0.2F, 0.4F, 0.6F})), 0.048, 1e-6);
  EXPECT_NEAR(signedVolume(sphereMesh(0.1F, 40)), 4.0 / 3 * robotlink::kPi * 1e-3, 3e-5);
  EXPECT_NEAR(signedVolume(cylinderMesh(0.1F, 0.3F, 100)), robotlink::kPi * 3e-3, 2e-5);
  EXPECT_NEAR(signedVolume(capsuleMesh(0.1F, 0.3F, 100)), robotlink::kPi * (3e-3 + 4.0 / 3 * 1e-3), 3e-5);
}

TEST(RenderScene, aCapsuleReachesItsRadiusBeyondItsLength) {
  float top = 0;
  for (const Vector3f& vertex : capsuleMesh(0.1F, 0.3F).vertices) top = std::max(top, vertex.z());
  EXPECT_FLOAT_EQ(top, 0.25F);
}

TEST(RenderScene, verticesOfASphereLieOnItWithItsNormals) {
  const Mesh mesh = sphereMesh(0.042F);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_NEAR((mesh.vertices[i] - 0.042F * mesh.normals[i]).norm(), 0, 1e-7);
  }
}
