// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"
#include "simcore/world/Radiation.h"

namespace simcore {

using robotlink::Pose3;
using robotlink::Rgb;

/// Triangles in a frame of their own, in meters, counterclockwise seen from outside. One unit normal per
/// vertex.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;
  // Indices of vertices.
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A mesh on a body, in one color.
struct RenderInstance {
  int mesh = 0;
  /// Index into the poses that are passed to a renderer; 0 is the world.
  int body = 0;
  Pose3 meshInBody = Pose3::Identity();
  Rgb color;
  /// For inspection: "red1/head/skin".
  std::string name;
  bool castsShadow = true;
  /// The color's name in the palette; empty if it has none.
  std::string colorName = {};
};

/// A light. The irradiance of a surface that faces a point light or a spot at distance d is `intensity` *
/// `color` / (1 + d^2 * attenuation); that of a directional light, which is infinitely far away, is
/// `intensity`
/// * `color` everywhere.
struct Lamp {
  enum class Kind : std::uint8_t { kPoint, kDirectional, kSpot };
  /// In the world, m; without meaning for a directional light.
  Eigen::Vector3f position = {0, 0, 3};
  float intensity = 0.6F;
  /// Per square meter.
  float attenuation = 0;
  /// Red, green and blue, 0 to 1.
  Eigen::Vector3f color = {1, 1, 1};
  Kind kind = Kind::kPoint;
  /// The direction of the light in the world, of unit length; meaningless for a point light.
  Eigen::Vector3f direction = {0, 0, -1};
  /// Only for spots, rad, the full angles of two cones: within the inner one the light is full, between the
  /// two it falls off with the cosine of the angle, beyond there is none.
  float innerAngle = 0, outerAngle = 0;
};

/// Returns the origin of a lamp's light: a directional one is far away against its direction, so that its
/// rays are nearly parallel, and near enough for floats.
Eigen::Vector3f placeOf(const Lamp& lamp);
/// The intensity of the channel that a lamp has most of.
inline float peakOf(const Lamp& lamp) {
  return lamp.intensity * lamp.color.maxCoeff();
}
/// A lamp's color with a largest channel of 1.
Eigen::Vector3f tintOf(const Lamp& lamp);
/// The share of a lamp's light, 0 to 1, that goes in a direction of any length: all of it unless it is a
/// spot.
float shareTowards(const Lamp& lamp, const Eigen::Vector3f& direction);

/// Everything that a camera or a viewer needs to draw a world, except for the poses of the bodies. Built once
/// per scene, then immutable and shared between threads.
///
/// The color of a pixel is color * min(1, ambient + sum over lamps of visibility * irradiance * max(0,
/// cos(angle))); where colored light is too bright for one channel, all channels are dimmed by the same
/// factor.
struct RenderScene {
  std::vector<Mesh> meshes;
  std::vector<RenderInstance> instances;
  /// Names by body index; bodies[0] is "world".
  std::vector<std::string> bodies;
  std::vector<Lamp> lamps;
  /// Fraction of a surface's color that is visible without lamps.
  float ambient = 0.4F;
  /// The color where there is nothing.
  Rgb background;
  /// The data that image sensors see in addition to colors.
  SceneRadiation radiation = {};
  /// The true class of each instance: 0 if it has none, otherwise the index of its color's name in
  /// `labelNames` plus 1. The names are sorted.
  std::vector<std::uint16_t> labels = {};
  std::vector<std::string> labelNames = {};
};

/// Meshes of basic shapes, centered at the origin of their frame; cylinders and capsules are along z. Round
/// shapes are smooth: vertices are on the true surface and have its normals. A capsule's `length` is that of
/// its cylindrical part, as in SDFormat and ODE; its ends extend `radius` beyond. There are at least 2 rings
/// and 3 sides.
Mesh boxMesh(const Eigen::Vector3f& size);
Mesh sphereMesh(float radius, int rings = 12);
Mesh cylinderMesh(float radius, float length, int sides = 24);
Mesh capsuleMesh(float radius, float length, int sides = 12);

}  // namespace simcore
