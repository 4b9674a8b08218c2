// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyRequests.h"

#include <algorithm>
#include <utility>

namespace robotlink::websocket {

using robotcontrol::KeyMode;

/// A plot's curves, and the stopwatches of the processes, have streams below that of their key.
bool KeyRequests::publishesOn(const Key& key, const std::string& stream) {
  if (key.stream.empty() || !stream.starts_with(key.stream)) return false;
  return stream.size() == key.stream.size() || stream[key.stream.size()] == '/';
}

void KeyRequests::setSubscribers(const std::string& robot, const std::string& stream,
                                 const std::set<std::string>& clients) {
  Robot& known = robots_[robot];
  if (clients.empty()) {
    known.subscribers.erase(stream);
  } else {
    known.subscribers[stream] = clients;
  }
  update(robot, known);
}

void KeyRequests::forgetSubscribers(const std::string& robot) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return;
  known->second.subscribers.clear();
  known->second.hasChanged = true;
}

void KeyRequests::setTable(const std::string& robot, const robotcontrol::KeyTable& table) {
  Robot& known = robots_[robot];
  std::map<std::string, Key> keys;
  for (const auto& row : table.keys()) {
    Key& key = keys[row.name()];
    key.stream = row.stream();
    key.mode = row.mode();
    const auto old = known.keys.find(row.name());
    if (old == known.keys.end()) continue;
    key.before = old->second.before;
    key.isTheirs = old->second.isTheirs;
    key.isRestored = old->second.isRestored && key.mode.kind() != KeyMode::OFF;
  }
  known.keys = std::move(keys);
  update(robot, known);
}

void KeyRequests::noteChosen(const std::string& robot, const std::string& key, const KeyMode& mode) {
  if (isSetting_) return;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return;
  const auto found = known->second.keys.find(key);
  if (found == known->second.keys.end()) return;
  found->second.mode = mode;
  found->second.before.reset();
  found->second.isRestored = false;
  found->second.isTheirs = true;
}

std::map<std::string, std::set<std::string>> KeyRequests::clientsByKey(const std::string& robot) const {
  std::map<std::string, std::set<std::string>> result;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return result;
  for (const auto& [name, key] : known->second.keys) {
    for (const auto& [stream, clients] : known->second.subscribers) {
      if (publishesOn(key, stream)) result[name].insert(clients.begin(), clients.end());
    }
  }
  return result;
}

std::map<std::string, std::set<std::string>> KeyRequests::onDemand(const std::string& robot) const {
  auto clients = clientsByKey(robot);
  std::map<std::string, std::set<std::string>> result;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return result;
  for (const auto& [name, key] : known->second.keys) {
    if (key.before || key.isRestored) result[name] = std::move(clients[name]);
  }
  return result;
}

bool KeyRequests::takeChanged(const std::string& robot) {
  const auto known = robots_.find(robot);
  return known != robots_.end() && std::exchange(known->second.hasChanged, false);
}

void KeyRequests::restoreAll() {
  for (auto& [name, robot] : robots_) {
    robot.subscribers.clear();
    update(name, robot);
  }
}

void KeyRequests::update(const std::string& name, Robot& robot) {
  robot.hasChanged = true;
  for (auto& [keyName, key] : robot.keys) {
    const bool wanted = std::ranges::any_of(
        robot.subscribers,
        [&one = std::as_const(key)](const auto& subscribed) { return publishesOn(one, subscribed.first); });
    if (wanted && !key.before && !key.isTheirs && key.mode.kind() == KeyMode::OFF) {
      key.before = key.mode;
      key.isRestored = false;
      KeyMode always;
      always.set_kind(KeyMode::ALWAYS);
      set(name, keyName, key, always);
    } else if (!wanted) {
      key.isTheirs = false;
      // Also if the table says that it is so: that may be older than our request.
      if (!key.before) continue;
      key.isRestored = true;
      set(name, keyName, key, *std::exchange(key.before, std::nullopt));
    }
  }
}

void KeyRequests::set(const std::string& robot, const std::string& name, Key& key, const KeyMode& mode) {
  key.mode = mode;
  isSetting_ = true;
  setMode_(robot, name, mode);
  isSetting_ = false;
}

}  // namespace robotlink::websocket
