// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "colortool/votes/ColorVotes.h"
#include "colortool/votes/LearnedTables.h"
#include "colortool/votes/TableCleanUp.h"

namespace colortool {

/// How a table is learned: ColorVotes, gaussianTable(), or supportVectorTable().
enum class TrainingMethod : std::uint8_t { kVotes, kGaussians, kSupportVectors };

/// Everything besides strokes and classes that determines a trained table. A plain value, stored with the
/// samples.
struct TrainingSettings {
  TrainingMethod method = TrainingMethod::kVotes;
  /// The options of each method; only those of `method` apply.
  VoteOptions votes;
  GaussianOptions gaussians;
  SupportVectorOptions supportVectors;
  CleanUpOptions cleanUp;
  /// Whether images are corrected for vignetting before the look-up.
  bool correctVignetting = false;
  /// Whether the channels of each camera are mapped to those of the reference camera.
  bool correctCameras = false;
  bool operator==(const TrainingSettings&) const = default;
};

}  // namespace colortool
