// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/BodyInbox.h"

namespace app {

std::string BodyInbox::put(const std::string& robot, const Sender& from, robotcontrol::BodyCommands commands,
                           robotlink::Instant now) {
  const std::lock_guard lock(mutex_);
  Robot& to = robots_[robot];
  if (to.commander.id != 0 && to.commander.id != from.id && now - to.heard < kGivenUp)
    return robot + " obeys the program of " + to.commander.name + "; end that program first";
  to.commander = from;
  to.heard = now;
  to.newest = std::move(commands);
  return {};
}

std::optional<robotcontrol::BodyCommands> BodyInbox::take(const std::string& robot) {
  const std::lock_guard lock(mutex_);
  const auto found = robots_.find(robot);
  return found == robots_.end() ? std::nullopt : std::exchange(found->second.newest, std::nullopt);
}

std::string BodyInbox::commander(const std::string& robot) const {
  const std::lock_guard lock(mutex_);
  const auto found = robots_.find(robot);
  return found == robots_.end() ? std::string() : found->second.commander.name;
}

}  // namespace app
