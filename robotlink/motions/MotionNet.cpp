// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionNet.h"

#include <algorithm>

namespace robotlink {

int MotionNet::find(std::string_view motion) const {
  const auto found = std::find(motions.begin(), motions.end(), motion);
  return found == motions.end() ? -1 : static_cast<int>(found - motions.begin());
}

MotionFile::Begin MotionNet::begin(std::string_view motion) const {
  const int index = find(motion);
  return index < 0 ? MotionFile::Begin::kStand : begins[static_cast<std::size_t>(index)];
}

}  // namespace robotlink
