// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace simcore {

using robotlink::Pose3;
using robotlink::Rgb;

/// Triangles in a frame of their own, metres; counter-clockwise seen from outside. One normal a vertex, unit
/// length.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices;
  std::vector<Eigen::Vector3f> normals;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A mesh on a body, in one colour.
struct RenderInstance {
  int mesh = 0;
  int body = 0;  ///< index into the poses that a renderer is given; 0 is the world itself
  Pose3 meshInBody = Pose3::Identity();
  Rgb color;
  std::string name;
  bool castsShadow = true;
  std::string colorName = {};  ///< that a palette has for it; empty if it has none
};

/// A point light. Irradiance on a surface facing it at distance d is `intensity` / (1 + d^2 * attenuation).
struct Lamp {
  Eigen::Vector3f position = {0, 0, 3};  ///< world, metres
  float intensity = 0.6F;
  float attenuation = 0;  ///< 1/m^2
};

/// Everything that a camera or a viewer needs to draw a world, but for where the bodies are. Built once a
/// scene, then immutable and shared between threads.
///
/// A pixel's colour is color * min(1, ambient + sum over lamps of visibility * irradiance * max(0,
/// cos(angle))).
struct RenderScene {
  std::vector<Mesh> meshes;
  std::vector<RenderInstance> instances;
  std::vector<std::string> bodies;  ///< names, by body index; bodies[0] is "world"
  std::vector<Lamp> lamps;
  float ambient = 0.4F;
  Rgb background;
};

/// Meshes of the usual shapes, centred on their frame's origin; cylinders and capsules along z. Round ones
/// are smooth: their vertices lie on the true surface, with its normals. `length` of a capsule is that of its
/// cylinder alone, as in SDFormat and ODE; its ends reach `radius` beyond. At least 2 rings and 3 sides are
/// made.
Mesh boxMesh(const Eigen::Vector3f& size);
Mesh sphereMesh(float radius, int rings = 12);
Mesh cylinderMesh(float radius, float length, int sides = 24);
Mesh capsuleMesh(float radius, float length, int sides = 12);

}  // namespace simcore
