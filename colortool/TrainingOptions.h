// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "colortool/TrainingSettings.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// A number of the training settings by its name, for scripts and for sliders. Constant data.
struct TrainingOption {
  std::string_view name;                 ///< "brightness-weight"
  std::optional<TrainingMethod> method;  ///< that it is of; none: of all
  bool isSwitch = false;                 ///< 0 or 1
  double least = 0, most = 1;
  bool logarithmic = false;  ///< its scale; `least` is more than 0 then
  double (*get)(const TrainingSettings&) = nullptr;
  void (*set)(TrainingSettings&, double) = nullptr;
};

std::span<const TrainingOption> trainingOptions();
/// Null if there is none of that name.
const TrainingOption* findTrainingOption(std::string_view name);
/// Fails on names that are not known and on values out of range, with what there is instead.
robotlink::Result<TrainingSettings> withOption(TrainingSettings settings, std::string_view name,
                                               double value);

/// "votes", "gaussians", "support-vectors".
std::string_view nameOf(TrainingMethod method);
robotlink::Result<TrainingMethod> trainingMethod(std::string_view name);

}  // namespace colortool
