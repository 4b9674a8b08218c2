// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneLight.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/Requests.pb.h"

namespace widgets {

SceneLight sceneLight(const robotcontrol::SimulationStatus* status) {
  if (status == nullptr) return {};
  const double brightness = status->brightness(), warmth = status->warmth();
  // A brightness of 0 is from a program that knows no light, and in the dark nothing would be visible.
  if (!(brightness > 0) || !std::isfinite(brightness) || !(std::abs(warmth) <= 1)) return {};
  return {static_cast<float>(brightness * (1 - std::max(-warmth, 0.0))),
          static_cast<float>(brightness * (1 - std::abs(warmth) / 2)),
          static_cast<float>(brightness * (1 - std::max(warmth, 0.0)))};
}

}  // namespace widgets
