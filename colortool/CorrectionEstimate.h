// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "colortool/Samples.h"

namespace colortool {

/// What samples tell about their cameras.
struct CorrectionEstimate {
  /// The corrections of cameras for which something was found, in the order of the samples' images.
  std::vector<CameraCorrection> corrections;
  /// Sentences for people, one or more a camera: what was found, or why nothing was, and which strokes would
  /// help.
  std::vector<std::string> notes;
};

/// Finds out how each camera's lens darkens and tints its images, and how the colours of each differ from
/// those of the camera with most strokes, by what strokes of one class look like in different places and
/// cameras. Strokes are compared within one class and one lighting only; background and what must not be of a
/// class are left out, since they are of any colour.
///
/// Vignetting is found where strokes of the same class are in the middle of the images and towards their
/// corners, each channel on its own, if it is more than chance. Channels get a gain against the other camera
/// with three classes of different values, else an offset alone. What the samples' settings switch off is
/// estimated all the same. Some milliseconds; any thread.
CorrectionEstimate estimateCorrections(const Samples& samples);

}  // namespace colortool
