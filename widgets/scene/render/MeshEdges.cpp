// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/MeshEdges.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <unordered_map>

namespace widgets {
namespace {

using Index = std::uint32_t;
using robotlink::Vector3;

constexpr double kSamePlane = 0.99995;  // cosine of 0.6 degrees

/// A place, bit by bit, so that exactly equal ones are found.
struct EdgePlace {
  std::array<std::uint32_t, 3> bits;
  bool operator==(const EdgePlace&) const = default;
};

struct EdgePlaceHash {
  std::size_t operator()(const EdgePlace& place) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t bits : place.bits) hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 32U);
  }
};

/// An edge between two places, with the triangles found at it.
struct MeshEdge {
  Index from = 0, to = 0;
  Vector3 normal;
  int triangles = 0;
  bool isFlat = true;
};

Vector3 placeOfVertex(const SceneMesh& mesh, Index vertex) {
  const auto& p = mesh.vertices[vertex].position;
  return {double(p[0]), double(p[1]), double(p[2])};
}

/// For each vertex the first one at the same place. Adding 0 makes -0 and 0 the same.
std::vector<Index> weldedVertices(const SceneMesh& mesh) {
  std::unordered_map<EdgePlace, Index, EdgePlaceHash> known;
  known.reserve(mesh.vertices.size());
  std::vector<Index> welded;
  welded.reserve(mesh.vertices.size());
  for (Index i = 0; i < mesh.vertices.size(); ++i) {
    const auto& p = mesh.vertices[i].position;
    const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value + 0.F); };
    welded.push_back(known.try_emplace({{bits(p[0]), bits(p[1]), bits(p[2])}}, i).first->second);
  }
  return welded;
}

}  // namespace

std::vector<Index> meshEdges(const SceneMesh& mesh) {
  const std::vector<Index> welded = weldedVertices(mesh);
  std::unordered_map<std::uint64_t, MeshEdge> edges;
  edges.reserve(mesh.indices.size() / 2);
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::array<Index, 3> corners{mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]};
    if (std::ranges::max(corners) >= mesh.vertices.size()) continue;
    const Vector3 a = placeOfVertex(mesh, corners[0]);
    const Vector3 normal =
        (placeOfVertex(mesh, corners[1]) - a).cross(placeOfVertex(mesh, corners[2]) - a).normalized();
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = welded[corners[k]], to = welded[corners[(k + 1) % 3]];
      if (from == to) continue;
      MeshEdge& edge = edges[std::uint64_t{std::min(from, to)} << 32U | std::max(from, to)];
      if (edge.triangles++ == 0) {
        edge = {corners[k], corners[(k + 1) % 3], normal, 1, true};
      } else if (!(std::abs(edge.normal.dot(normal)) > kSamePlane)) {
        edge.isFlat = false;
      }
    }
  }
  std::vector<Index> result;
  for (const auto& [key, edge] : edges)
    if (edge.triangles == 1 || !edge.isFlat) result.insert(result.end(), {edge.from, edge.to});
  return result;
}

}  // namespace widgets
