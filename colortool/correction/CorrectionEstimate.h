// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "colortool/samples/Samples.h"

namespace colortool {

/// Color corrections estimated from samples.
struct CorrectionEstimate {
  /// The corrections of cameras for which something was found, in the order of the samples' images.
  std::vector<CameraCorrection> corrections;
  /// Sentences for the user, one or more per camera: what was found, or why nothing was, and which strokes
  /// would help.
  std::vector<std::string> notes;
};

/// Estimates from the strokes of each class, seen in different places and by different cameras, how the lens
/// of each camera darkens and tints its images, and how its colors differ from those of the camera with the
/// most strokes. Strokes are compared within one class and one lighting only. Background and strokes that
/// exclude a class are ignored, since they can have any color.
///
/// Vignetting is found, per channel, if strokes of the same class lie both near the center of the images and
/// toward their corners, and the difference is significant. A channel gets a gain relative to the reference
/// camera if three classes of different values are available, otherwise an offset only. The result includes
/// corrections that the samples' settings switch off. Takes some milliseconds; any thread.
CorrectionEstimate estimateCorrections(const Samples& samples);

}  // namespace colortool
