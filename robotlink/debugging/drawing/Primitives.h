// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "foxglove/Geometry.pb.h"
#include "robotlink/debugging/drawing/Drawings.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {

// Shared by the sources of ImageDrawing and SceneDrawing; not for other headers.

/// Whether all coordinates are finite.
template <typename... Points>
bool finite(const Points&... points) {
  return (points.allFinite() && ...);
}

/// A color in the form of a message.
inline foxglove::Color packed(Color color) {
  foxglove::Color result;
  assign(result, color.rgb, color.alpha);
  return result;
}

/// Whether two shapes have the same color and can share a primitive.
inline bool same(const foxglove::Color& a, const foxglove::Color& b) {
  return a.r() == b.r() && a.g() == b.g() && a.b() == b.b() && a.a() == b.a();
}

}  // namespace robotlink
