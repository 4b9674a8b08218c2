// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "colortool/votes/TrainingSettings.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// A number of TrainingSettings with its name and range, for scripts and sliders. Constant data.
struct TrainingOption {
  /// The name in scripts: "brightness-weight".
  std::string_view name;
  /// The method that uses it; empty: all.
  std::optional<TrainingMethod> method;
  /// Whether only 0 (off) and 1 (on) are allowed.
  bool isSwitch = false;
  /// The range of values, both ends inclusive.
  double least = 0, most = 1;
  /// Whether a slider should be logarithmic; then `least` is positive.
  bool logarithmic = false;
  /// Access to the number in the settings.
  double (*get)(const TrainingSettings&) = nullptr;
  void (*set)(TrainingSettings&, double) = nullptr;
};

std::span<const TrainingOption> trainingOptions();
/// Returns null if there is no option of that name.
const TrainingOption* findTrainingOption(std::string_view name);
/// Returns the settings with one option changed. Fails on an unknown name or a value out of range; the error
/// lists the alternatives.
robotlink::Result<TrainingSettings> withOption(TrainingSettings settings, std::string_view name,
                                               double value);

/// The name in scripts and files: "votes", "gaussians", "support-vectors".
std::string_view nameOf(TrainingMethod method);
/// The inverse of nameOf(); fails on an unknown name.
robotlink::Result<TrainingMethod> trainingMethod(std::string_view name);

}  // namespace colortool
