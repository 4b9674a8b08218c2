// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// A polygon of 3 to 1000 corners (m, in either direction; the last may repeat the first), extruded from z =
/// 0 to `height`, as SDFormat's <polyline>. Triangulated by cutting ears off (G. H. Meisters, 1975). Fails
/// with a reason if the polygon has no area or crosses itself.
tl::expected<Mesh, std::string> extrudedMesh(std::vector<robotlink::Vector2> corners, double height);

/// A cone along z, its base at -length / 2, its tip at length / 2.
Mesh coneMesh(float radius, float length, int sides = 24);

}  // namespace simcore
