// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "widgets/scene/render/SceneMesh.h"

namespace widgets {

/// The edges of a mesh as pairs of indices of its vertices, each edge once: all but those between triangles
/// that lie in one plane, so that a box has twelve and a floor four. Vertices at the same place count as one.
/// Triangles with an index past the end are left out. Takes time in proportion to the number of triangles.
/// Pure.
std::vector<std::uint32_t> meshEdges(const SceneMesh& mesh);

}  // namespace widgets
