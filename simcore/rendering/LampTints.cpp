// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LampTints.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

/// Lights a color by the shares of red, green and blue light; with the coefficients of robotlink::toYCbCr and
/// its inverse, chroma without its offset.
void tintColor(const Eigen::Vector3f& share, bool isLuma, float& first, float& second, float& third) {
  if (!isLuma) {
    first *= share.x();
    second *= share.y();
    third *= share.z();
    return;
  }
  const float r = (first + 1.402F * third) * share.x(),
              g = (first - 0.344136F * second - 0.714136F * third) * share.y(),
              b = (first + 1.772F * second) * share.z();
  first = 0.299F * r + 0.587F * g + 0.114F * b;
  second = -0.168736F * r - 0.331264F * g + 0.5F * b;
  third = 0.5F * r - 0.418688F * g - 0.081312F * b;
}

}  // namespace

LampTints::LampTints(const std::vector<Lamp>& lamps) {
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    if (std::ranges::find(order_, i) != order_.end()) continue;
    Group group{tintOf(lamps[i]), order_.size(), 0};
    for (std::size_t k = i; k < lamps.size(); ++k) {
      if (tintOf(lamps[k]) == group.tint) order_.push_back(k);
    }
    group.count = order_.size() - group.first;
    groups_.push_back(group);
  }
  const Eigen::Vector3f white(1, 1, 1);
  if (std::ranges::all_of(groups_, [&](const Group& group) { return group.tint == white; })) groups_.clear();
}

void LampTints::begin(Strip& strip, const VisibilityBuffer& buffer) {
  // An image has several strips.
  if (strip.firstRow == 0) ambient_ = strip.ambient;
  strip.ambient = 0;
  sums_.assign(static_cast<std::size_t>(strip.rows) * static_cast<std::size_t>(buffer.stride),
               Eigen::Vector3f::Constant(ambient_));
}

void LampTints::add(const Group& group, const Strip& strip, const VisibilityBuffer& buffer) {
  for (int row = 0; row < strip.rows; ++row) {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.stride);
    for (std::size_t i = at; i < at + static_cast<std::size_t>(buffer.width); ++i)
      sums_[i] += strip.light[i] * group.tint;
  }
}

void LampTints::finish(Strip& strip, const VisibilityBuffer& buffer, bool isLuma) {
  for (int row = 0; row < strip.rows; ++row) {
    const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(buffer.stride);
    const std::int32_t* drawn =
        buffer.triangle + static_cast<std::ptrdiff_t>(strip.firstRow + row) * buffer.stride;
    for (std::size_t i = at; i < at + static_cast<std::size_t>(buffer.width); ++i, ++drawn) {
      // The background keeps its color.
      const float peak = *drawn == 0 ? 1 : sums_[i].maxCoeff();
      strip.light[i] = peak;
      if (*drawn == 0 || peak <= 0) continue;
      tintColor(sums_[i] / peak, isLuma, strip.color[0][i], strip.color[1][i], strip.color[2][i]);
    }
  }
}

}  // namespace simcore::rendering
