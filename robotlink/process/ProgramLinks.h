// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"

namespace robotlink {

class AnyReceiver;
class AnySender;

/// Makes the links of a robot program's processes to those that run in other programs of the operating
/// system (Layout::Program). Both sides make their half, in any order and at any time; a link carries
/// packages while both are there.
class ProgramLinks {
 public:
  virtual ~ProgramLinks() = default;
  /// Links a sender of this program to all receivers of its package in others. `from` is the name of its
  /// process in the layout; that of the platform is kPlatform. Repeated calls do nothing.
  virtual Result<void> link(AnySender& sender, const std::string& from) = 0;
  /// Links a receiver of this program to a sender in another.
  virtual Result<void> link(AnyReceiver& receiver, const std::string& from) = 0;

  /// The platform in place of the name of a process.
  static constexpr const char* kPlatform = "platform";
};

}  // namespace robotlink
