// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "colortool/votes/VoteKernel.h"

namespace colortool {

/// The kernels of the votes around samples. Light, distance and blur change the saturation of a color far
/// more than its hue, and the more so the more saturated it is: so the votes of saturated colors reach
/// farther along their saturation (toward gray and away from it), and less far across it, where other hues
/// are: orange does not get lost to red. Colors near gray have no hue; their votes reach equally far. One
/// thread.
class NearKernels {
 public:
  NearKernels() = default;
  /// `gray`: the kernel of colors near gray.
  explicit NearKernels(const VoteKernel::Shape& gray);

  /// See VoteKernel; the bound holds for samples of any colors.
  double largestSum() const;
  void setPeak(double peak);

  /// The kernel of the samples in a cell. Made when it is first needed, in about 0.1 ms; valid until the next
  /// call of setPeak().
  const VoteKernel& at(std::size_t cell);

 private:
  VoteKernel::Shape gray_;
  double peak_ = 0;
  /// The kernels, indexed by direction and degree of saturation; not set until needed.
  std::vector<std::optional<VoteKernel>> kernels_;
};

}  // namespace colortool
