// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/DrawableMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace simcore::rendering {
namespace {

constexpr std::size_t kLanes = 8;

std::size_t paddedSize(std::size_t count) {
  return (count + kLanes - 1) / kLanes * kLanes;
}

/// Not normalized; in double precision, because thin triangles need it.
Eigen::Vector3d faceNormal(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const Eigen::Vector3d a = mesh.vertices[t[0]].cast<double>();
  return (mesh.vertices[t[1]].cast<double>() - a).cross(mesh.vertices[t[2]].cast<double>() - a);
}

bool isDrawable(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const std::size_t count = std::min(mesh.vertices.size(), mesh.normals.size());
  return t[0] < count && t[1] < count && t[2] < count && faceNormal(mesh, t).norm() > 0;
}

}  // namespace

DrawableMesh::DrawableMesh(const Mesh& mesh) {
  fillVertices(mesh);
  fillTriangles(mesh);
  for (std::size_t i = 0; i < 3; ++i) {
    streams_.position[i] = floats_[i].data();
    streams_.index[i] = indices_[i].data();
  }
  streams_.normal = normals_.data();
  for (std::size_t i = 0; i < 4; ++i) streams_.plane[i] = floats_[i + 3].data();
  streams_.flat = flat_.data();
  findBounds(mesh);
  findConvexity(mesh);
}

void DrawableMesh::fillVertices(const Mesh& mesh) {
  const std::size_t count = std::min(mesh.vertices.size(), mesh.normals.size());
  for (std::size_t i = 0; i < 3; ++i) floats_[i].resize(paddedSize(count));
  normals_.resize(4 * paddedSize(count));
  for (std::size_t v = 0; v < count; ++v) {
    for (int k = 0; k < 3; ++k) {
      floats_[static_cast<std::size_t>(k)][v] = mesh.vertices[v][k];
      normals_[4 * v + static_cast<std::size_t>(k)] = mesh.normals[v][k];
    }
  }
  streams_.vertexGroups = static_cast<int>(paddedSize(count) / kLanes);
}

void DrawableMesh::fillTriangles(const Mesh& mesh) {
  for (const auto& t : mesh.triangles) {
    if (!isDrawable(mesh, t)) continue;
    const Eigen::Vector3d normal = faceNormal(mesh, t).normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      indices_[i].push_back(static_cast<std::int32_t>(t[i]));
      floats_[i + 3].push_back(static_cast<float>(normal[static_cast<Eigen::Index>(i)]));
    }
    floats_[6].push_back(static_cast<float>(normal.dot(mesh.vertices[t[0]].cast<double>())));
    flat_.push_back(mesh.normals[t[0]] == mesh.normals[t[1]] && mesh.normals[t[0]] == mesh.normals[t[2]] ? 1
                                                                                                         : 0);
  }
  const std::size_t size = paddedSize(flat_.size());
  for (std::size_t i = 0; i < 3; ++i) {
    indices_[i].resize(size);
    floats_[i + 3].resize(size);
  }
  floats_[6].resize(size, std::numeric_limits<float>::infinity());
  flat_.resize(size);
  streams_.triangleGroups = static_cast<int>(size / kLanes);
}

void DrawableMesh::findBounds(const Mesh& mesh) {
  if (mesh.vertices.empty()) return;
  Eigen::Vector3d low = mesh.vertices.front().cast<double>(), high = low;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex.cast<double>());
    high = high.cwiseMax(vertex.cast<double>());
  }
  bound_.center = (low + high) / 2;
  for (const Eigen::Vector3f& vertex : mesh.vertices) {
    bound_.radius = std::max(bound_.radius, (vertex.cast<double>() - bound_.center).norm());
  }
  bound_.radius *= 1 + 1e-6;
  // The bounding box, cut into roughly cubic pieces along its longest side.
  const Eigen::Vector3d size = high - low;
  Eigen::Index longest = 0;
  const double length = size.maxCoeff(&longest);
  const double width = std::max(size.sum() - length - size.minCoeff(), length / 16);
  const int pieces = length > 0 ? std::max(1, static_cast<int>(std::lround(length / width))) : 1;
  Eigen::Vector3d piece = size;
  piece[longest] /= pieces;
  const double radius = pieces == 1 ? bound_.radius : piece.norm() / 2 * (1 + 1e-6);
  for (int i = 0; i < pieces; ++i) {
    Eigen::Vector3d center = bound_.center;
    center[longest] = low[longest] + (i + 0.5) * piece[longest];
    cover_.push_back({center, radius});
  }
}

void DrawableMesh::findConvexity(const Mesh& mesh) {
  constexpr double kMaxWork = 1e7;
  const double tolerance = 1e-5 * bound_.radius;
  if (static_cast<double>(mesh.triangles.size()) * static_cast<double>(mesh.vertices.size()) > kMaxWork)
    return;
  convex_ =
      std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const std::array<std::uint32_t, 3>& t) {
        if (!isDrawable(mesh, t)) return true;
        const Eigen::Vector3d normal = faceNormal(mesh, t).normalized();
        const double offset = normal.dot(mesh.vertices[t[0]].cast<double>());
        return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const Eigen::Vector3f& vertex) {
          return normal.dot(vertex.cast<double>()) <= offset + tolerance;
        });
      });
}

}  // namespace simcore::rendering
