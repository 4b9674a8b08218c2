// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <set>
#include <string>

#include "robotlink/process/Link.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// Asks robots for the packages that a view shows, by their debug keys (package/drive/state): each once, as
/// soon as the robot's key table names it and says that it is off. Who switches it off afterwards is obeyed,
/// until another platform is opened. Packages that a robot does not have are not asked for. GUI thread.
class PackageWish {
 public:
  /// Called in each tick, always with the same packages for a robot; costs next to nothing while the table is
  /// the same.
  void want(robotlink::Session& session, const std::string& robot,
            std::initializer_list<const char*> packages);

 private:
  std::uint64_t generation_ = ~std::uint64_t{0};
  std::set<std::string> settled_;  // paths of packages: asked for, or on anyway
  std::set<robotlink::PackagePtr>
      seen_;  // tables that lack the others; kept, so that no new one has their address
};

}  // namespace widgets
