// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {

/// Something in a scene's files that this simulator does not have, or has only approximately. A plain value.
struct LeftOut {
  robotlink::FilePosition where;
  /// The object that has it, by the names of what contains it: "world/robot/arm/skin".
  std::string object;
  /// The part that was left out, for users: "<kp>".
  std::string what;
  /// The consequence of leaving it out: "contacts have the stiffness of the solver".
  std::string why;
  bool operator==(const LeftOut&) const = default;
};
using LeftOuts = std::vector<LeftOut>;

/// The number of entries after which further ones are dropped, so that damaged files need bounded memory.
constexpr std::size_t kMaxLeftOut = 5000;

inline void leaveOut(LeftOuts& all, LeftOut one) {
  if (all.size() < kMaxLeftOut) all.push_back(std::move(one));
}

}  // namespace simcore
