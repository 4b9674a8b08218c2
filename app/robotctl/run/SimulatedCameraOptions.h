// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/robotctl/color/LabeledImages.h"

namespace CLI {
class App;
}

namespace app {

/// The options of `robotctl sim` that concern simulated cameras: light, lens, noise, and the true classes of
/// pixels. Filled by the command line parser.
struct CameraOptions {
  simcore::LightAdjustment lighting;
  /// Share of light lost in the corners, and optionally the tint; empty: that of the cameras.
  std::vector<double> vignetting;
  /// Standard deviation in gray values; empty: that of the cameras.
  std::optional<double> imageNoise;
  /// Whether the true classes are published as "oracle/classes".
  bool classImages = false;
  /// Folder for labeled images; empty: none are written.
  std::string labeledFolder;
  /// Minimum interval between labeled images of a robot, s.
  double labeledEvery = 1;

  /// Adds the options to a command, which needs to have --no-noise; this object must outlive the command.
  void addTo(CLI::App& command);
  /// Sets the options of a run.
  void applyTo(RunOptions& run) const;
  /// The writer for labeled images; null if none are to be written.
  robotlink::Result<std::unique_ptr<LabeledImages>> labeledImages() const;
};

}  // namespace app
