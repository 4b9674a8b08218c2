// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <set>
#include <span>
#include <string>

#include "robotlink/process/Link.h"

namespace robotcontrol {
class KeyMode;
}
namespace robotlink {
class Session;
}

namespace widgets {

/// The interval in ms at which views publish what they only show at a glance (EVERY_MS), so that others may
/// want it more often.
inline constexpr std::uint32_t kGlanceMs = 500;

/// Whether a mode is the one of such views.
bool isGlance(const robotcontrol::KeyMode& mode);

/// Switches on the debug keys of the packages that a view shows (package/drive/state), so that the robot
/// publishes them. A key is requested once, as soon as the robot's key table contains it and says that it is
/// off, or on only at a glance. If the user switches it off afterward it stays off until another platform is
/// opened. Packages that a robot does not have are never requested. What is refused, such as by a program
/// that does not return at the moment, is requested again after a while. GUI thread.
class PackageSubscription {
 public:
  /// Called in each tick, always with the same packages for a robot. Returns early while the key table is
  /// unchanged and nothing was refused.
  void want(robotlink::Session& session, const std::string& robot, std::span<const char* const> packages);
  void want(robotlink::Session& session, const std::string& robot,
            std::initializer_list<const char*> packages) {
    want(session, robot, std::span(packages.begin(), packages.size()));
  }

 private:
  /// Forgets what was refused, if it is time to request it again.
  void tryAgain();

  /// The store's generation that the members below belong to; another one clears them.
  std::uint64_t generation_ = ~std::uint64_t{0};
  /// Paths of packages that were requested, or were on anyway.
  std::set<std::string> settled_;
  /// Key tables that were examined, at most 64. They are kept alive, so that no new table can have the
  /// address of an old one.
  std::set<robotlink::PackagePtr> seen_;
  /// Paths of packages whose requests were refused; shared with the answers to come.
  std::shared_ptr<std::set<std::string>> refused_ = std::make_shared<std::set<std::string>>();
  /// Calls of want() since something was refused, and until it is requested again.
  int calls_ = 0, patience_ = kFirstPatience;
  static constexpr int kFirstPatience = 30, kMaxPatience = 1920;
};

}  // namespace widgets
