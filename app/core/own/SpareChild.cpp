// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/SpareChild.h"

#include <utility>

namespace app {

robotlink::Result<ProgramChild> SpareChild::take(const std::filesystem::path& executable,
                                                 const std::string& name) {
  if (next_ && next_->hasEnded()) next_.reset();
  auto taken =
      next_ ? robotlink::Result<ProgramChild>(*std::move(next_)) : ProgramChild::start(executable, name);
  next_.reset();
  if (!taken) return taken;
  // If there is no room for one more, the next program says so when it is made.
  if (auto next = ProgramChild::start(executable, name)) next_.emplace(*std::move(next));
  return taken;
}

}  // namespace app
