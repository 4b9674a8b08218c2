// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <utility>

namespace robotlink {
class Session;
}

namespace widgets {

/// Lets robots publish packages twice a second (kGlanceMs) while a view shows them: switches on those debug
/// keys that are off, and off again with release(), unless another mode was chosen in the
/// meantime. Packages that a robot does not have, and keys that are on anyway, are left alone. GUI thread.
class GlanceSubscription {
 public:
  /// Called in each tick while the view is visible. Each key is requested once until release().
  void want(robotlink::Session& session, const std::string& robot,
            std::initializer_list<const char*> packages);
  /// Gives back what was requested. Call this when the view is hidden.
  void release(robotlink::Session& session);

 private:
  /// Robots with the keys that were requested, or were on anyway; and those of the first kind.
  std::set<std::pair<std::string, std::string>> settled_, requested_;
};

}  // namespace widgets
