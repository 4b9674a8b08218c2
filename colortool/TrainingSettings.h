// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "colortool/ColorVotes.h"
#include "colortool/LearnedTables.h"
#include "colortool/TableCleanUp.h"

namespace colortool {

enum class TrainingMethod : std::uint8_t { kVotes, kGaussians, kSupportVectors };

/// How a table is made of samples. A plain value.
struct TrainingSettings {
  TrainingMethod method = TrainingMethod::kVotes;
  VoteOptions votes;
  GaussianOptions gaussians;
  SupportVectorOptions supportVectors;
  CleanUpOptions cleanUp;
  bool correctVignetting = false;
  bool correctCameras = false;
  bool operator==(const TrainingSettings&) const = default;
};

}  // namespace colortool
