// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "widgets/scene/render/SceneMesh.h"

// The parts of which markers consist. Meters in the shape's frame; colors are RGBA.
namespace widgets {

using MarkerColor = std::array<std::uint8_t, 4>;

/// Adds an arrow with a solid shaft of a radius; the head is as long as three shafts are wide, but at most
/// the whole arrow. Nothing if its ends are less than a tenth of a millimeter apart, or not finite.
void addMarkerArrow(SceneShape& shape, const robotlink::Vector3& from, const robotlink::Vector3& to,
                    double radius, MarkerColor color);
/// Adds a line of a width in pixels; nothing if its ends are not finite.
void addMarkerLine(SceneShape& shape, const robotlink::Vector3& from, const robotlink::Vector3& to,
                   MarkerColor color, float pixels = 1.5F);
/// Adds a square of a size in pixels, which faces the viewer.
void addMarkerPoint(SceneShape& shape, const robotlink::Vector3& at, MarkerColor color, float pixels = 5);
/// Adds arrows along x (red), y (green) and z (blue).
void addMarkerAxes(SceneShape& shape, double length);

/// A pose at a point whose z-axis has a direction, which need not be of unit length.
robotlink::Pose3 poseAlong(const robotlink::Vector3& at, const robotlink::Vector3& direction);

}  // namespace widgets
