// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace foxglove {
class SceneEntity;
}

namespace widgets {

struct Ray;

/// Triangles as a graphics card takes them, in metres.
struct SceneMesh {
  struct Vertex {
    std::array<float, 3> position;
    std::array<float, 3> normal;  ///< of length 1
    std::array<std::uint8_t, 4> color;
  };
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;  ///< three for each triangle

  bool empty() const { return indices.empty(); }
};

/// Straight pieces with a width.
struct SceneLines {
  struct Segment {
    std::array<float, 3> from, to;
    std::array<std::uint8_t, 4> color;
    float width;  ///< positive: pixels; negative: metres
  };
  std::vector<Segment> segments;
};

struct SceneText {
  robotlink::Vector3 position;
  std::string text;
  std::array<std::uint8_t, 4> color;
  double size;  ///< positive: pixels; negative: metres
};

/// What an entity of a scene or drawing looks like, in the entity's frame.
struct SceneShape {
  SceneMesh opaque;  ///< alpha is 255 everywhere
  SceneMesh translucent;
  SceneLines lines;
  std::vector<SceneText> texts;
};

/// Spheres, cubes, cylinders and arrows become triangles; triangles get normals, smooth where neighbours meet
/// in an angle below 40 degrees. What an entity says wrongly (an index past the end) is left out. Pure.
SceneShape shapeOf(const foxglove::SceneEntity& entity);

/// How far along the ray, which is in the mesh's frame, it meets the mesh first.
std::optional<double> distanceTo(const SceneMesh& mesh, const Ray& ray);

}  // namespace widgets
