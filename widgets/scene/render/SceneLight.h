// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotcontrol {
class SimulationStatus;
}

namespace widgets {

/// Factors for red, green and blue of a scene's light, relative to the scene's file. A plain
/// value.
struct SceneLight {
  float red = 1, green = 1, blue = 1;
  bool operator==(const SceneLight&) const = default;
};

/// The light that simulated cameras see, too: with warmth above 0 it lacks that share of blue and half of it
/// of green, below 0 of red and green. Null, or without light at all: that of the scene's file.
SceneLight sceneLight(const robotcontrol::SimulationStatus* status);

}  // namespace widgets
