// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "robotlink/session/Presets.h"

namespace robotlink {
struct SolutionDescription;
}

namespace app {

/// The parameters of a solution that are tuned, each in a range: a unit cube. A plain value.
class ParameterSpace {
 public:
  struct Axis {
    /// "gait.fore.lift"
    std::string path;
    double low = 0, high = 0;
    /// The value in the robot's files.
    double start = 0;
    bool isWhole = false;
  };

  /// Reads texts like "gait.fore.lift=0.005:0.02", or "gait.fore.lift" for half of the present value to twice
  /// as much. Fails if there is no such number, if it makes no sense in the range, or if its present value is
  /// not in it.
  static robotlink::Result<ParameterSpace> of(const std::vector<std::string>& texts,
                                              const robotlink::SolutionDescription& solution,
                                              const robotlink::SolutionParameters& parameters);

  const std::vector<Axis>& axes() const { return axes_; }
  /// The present values.
  std::vector<double> start() const;
  /// Returns the preset for a point: the numbers of all axes with six significant digits.
  robotlink::Preset presetAt(const std::vector<double>& point) const;
  /// The numbers themselves, in the order of the axes.
  std::vector<std::string> numbersAt(const std::vector<double>& point) const;

 private:
  std::string solution_;
  std::vector<Axis> axes_;
};

}  // namespace app
