// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/RenderScene.h"

namespace simcore::rendering {

/// Adds up light of several colors. The kernels know light without color only, so those lamps are drawn
/// together that shine in one color; then the colors of the pixels are those that they have in the sum. Where
/// all lamps are white, nothing of this is needed. One thread at a time.
class LampTints {
 public:
  /// Lamps of one color: a range of order().
  struct Group {
    Eigen::Vector3f tint = {1, 1, 1};
    std::size_t first = 0, count = 0;
  };

  explicit LampTints(const std::vector<Lamp>& lamps);

  /// The lamps by their numbers in the scene, those of a color together.
  const std::vector<std::size_t>& order() const { return order_; }
  /// Empty if all lamps are white.
  std::span<const Group> groups() const { return groups_; }

  /// Begins with the ambient light of a strip, which is white; its kernels then add none.
  void begin(Strip& strip, const VisibilityBuffer& buffer);
  /// Adds what the lamps of a group gave.
  void add(const Group& group, const Strip& strip, const VisibilityBuffer& buffer);
  /// Sets colors and light of the strip, in the channels of a YCbCr image (`isLuma`) or of an RGB image.
  void finish(Strip& strip, const VisibilityBuffer& buffer, bool isLuma);

 private:
  std::vector<std::size_t> order_;
  std::vector<Group> groups_;
  float ambient_ = 0;
  /// Red, green and blue light by pixel of the strip.
  std::vector<Eigen::Vector3f> sums_;
};

}  // namespace simcore::rendering
