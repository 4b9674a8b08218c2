// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

// Shapes of scene entities as a graphics card takes them, and their intersection with rays.
namespace widgets {

struct Ray;

/// A triangle mesh, in meters.
struct SceneMesh {
  /// Layout as uploaded to the graphics card.
  struct Vertex {
    std::array<float, 3> position;
    /// The normal, of length 1.
    std::array<float, 3> normal;
    /// RGBA.
    std::array<std::uint8_t, 4> color;
  };
  std::vector<Vertex> vertices;
  /// Three per triangle.
  std::vector<std::uint32_t> indices;

  bool empty() const { return indices.empty(); }
};

/// Line segments with a width.
struct SceneLines {
  /// Layout as uploaded to the graphics card.
  struct Segment {
    std::array<float, 3> from, to;
    std::array<std::uint8_t, 4> color;
    /// Positive in pixels, negative in meters.
    float width;
  };
  std::vector<Segment> segments;
};

/// A text at a position.
struct SceneText {
  robotlink::Vector3 position;
  std::string text;
  std::array<std::uint8_t, 4> color;
  /// Positive in pixels, negative in meters.
  double size;
};

/// The shape of an entity of the scene or of a drawing, in the entity's frame. Made by shapeOf().
struct SceneShape {
  /// Alpha is 255 everywhere.
  SceneMesh opaque;
  SceneMesh translucent;
  SceneLines lines;
  std::vector<SceneText> texts;
};

/// Distance along the ray, which is in the mesh's frame, to its first intersection with the mesh; unset:
/// none.
std::optional<double> distanceTo(const SceneMesh& mesh, const Ray& ray);

}  // namespace widgets
