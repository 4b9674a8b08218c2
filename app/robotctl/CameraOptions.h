// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/SimulatedRun.h"
#include "app/robotctl/LabelledImages.h"

namespace CLI {
class App;
}

namespace app {

/// The options of `robotctl sim` about what simulated cameras see: light, lens, and the true classes of
/// pixels.
struct CameraOptions {
  simcore::Lighting lighting;
  std::vector<double> vignetting;  ///< falloff, and perhaps tint
  std::optional<double> imageNoise;
  bool classImages = false;
  std::string labelledFolder;  ///< empty: no labelled images are written
  double labelledEvery = 1;    ///< s

  void addTo(CLI::App& command);
  void applyTo(RunOptions& run) const;
  /// Where labelled images go; null if they go nowhere.
  robotlink::Result<std::unique_ptr<LabelledImages>> labelledImages() const;
};

}  // namespace app
