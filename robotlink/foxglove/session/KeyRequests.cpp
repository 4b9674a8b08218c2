// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyRequests.h"

#include <algorithm>
#include <utility>

namespace robotlink::websocket {

using robotcontrol::KeyMode;

namespace {

KeyMode alwaysMode() {
  KeyMode always;
  always.set_kind(KeyMode::ALWAYS);
  return always;
}

bool isSame(const KeyMode& one, const KeyMode& other) {
  return one.SerializeAsString() == other.SerializeAsString();
}

/// The density of a mode: modes of a higher density publish more in the long run.
int densityOf(const KeyMode& mode) {
  switch (mode.kind()) {
    case KeyMode::ALWAYS:
      return 3;
    case KeyMode::EVERY_N:
    case KeyMode::EVERY_MS:
      return 2;
    case KeyMode::N_TIMES:
      return 1;
    default:
      return 0;
  }
}

/// The mode that is enough for both. How many frames there are in a time is not known here.
KeyMode denserOf(const KeyMode& one, const KeyMode& other) {
  if (densityOf(one) != densityOf(other)) return densityOf(one) > densityOf(other) ? one : other;
  if (one.kind() != other.kind()) return alwaysMode();
  const bool isMoreDense = one.kind() == KeyMode::N_TIMES ? one.n() > other.n() : one.n() < other.n();
  return isMoreDense ? one : other;
}

}  // namespace

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
    key.asked = old->second.asked;
    key.choices = old->second.choices;
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
  found->second.choices.clear();
  found->second.isRestored = false;
  found->second.isTheirs = true;
}

std::map<std::string, std::set<std::string>> KeyRequests::clientsByKey(const std::string& robot) const {
  std::map<std::string, std::set<std::string>> result;
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return result;
  for (const auto& [name, key] : known->second.keys) {
    std::set<std::string> clients = subscribersOf(key, known->second);
    for (const auto& [client, mode] : key.choices) clients.insert(client);
    if (!clients.empty()) result[name] = std::move(clients);
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
    for (auto& [keyName, key] : robot.keys) key.choices.clear();
    update(name, robot);
  }
}

std::set<std::string> KeyRequests::subscribersOf(const Key& key, const Robot& robot) {
  std::set<std::string> all;
  for (const auto& [stream, clients] : robot.subscribers)
    if (publishesOn(key, stream)) all.insert(clients.begin(), clients.end());
  return all;
}

std::optional<KeyMode> KeyRequests::wantedMode(const Key& key, const Robot& robot) {
  std::set<std::string> undecided = subscribersOf(key, robot);
  KeyMode densest;
  for (const auto& [client, mode] : key.choices) {
    undecided.erase(client);
    densest = denserOf(densest, mode);
  }
  if (undecided.empty()) return key.choices.empty() ? std::nullopt : std::optional(densest);
  const KeyMode own = key.before.value_or(key.mode);
  if (own.kind() == KeyMode::OFF && !key.isTheirs) return alwaysMode();
  // Clients that have not chosen a mode get the key's own one.
  densest = denserOf(own, densest);
  return isSame(densest, own) ? std::nullopt : std::optional(densest);
}

std::optional<KeyMode> KeyRequests::takeChange(Key& key, const Robot& robot) {
  if (const auto wanted = wantedMode(key, robot)) {
    // This holds even if the table differs: it may be older than our request.
    if (isSame(key.before ? key.asked : key.mode, *wanted)) return std::nullopt;
    if (!key.before) key.before = key.mode;
    key.isRestored = false;
    key.asked = *wanted;
    return key.asked;
  }
  if (!key.before) return std::nullopt;
  key.isRestored = key.before->kind() == KeyMode::OFF;
  return std::exchange(key.before, std::nullopt);
}

void KeyRequests::update(const std::string& name, Robot& robot) {
  robot.hasChanged = true;
  for (auto& [keyName, key] : robot.keys) {
    if (subscribersOf(key, robot).empty()) key.isTheirs = false;
    if (const auto mode = takeChange(key, robot)) set(name, keyName, key, *mode);
  }
}

std::optional<KeyMode> KeyRequests::choose(const std::string& robot, const std::string& key,
                                           const std::string& client, const std::optional<KeyMode>& mode) {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return mode;
  const auto found = known->second.keys.find(key);
  if (found == known->second.keys.end()) return mode;
  std::erase_if(found->second.choices, [&](const auto& choice) { return choice.first == client; });
  if (mode) found->second.choices.emplace_back(client, *mode);
  const auto wanted = wantedMode(found->second, known->second);
  // The count restarts from zero, even if the same mode was requested before.
  if (mode && mode->kind() == KeyMode::N_TIMES && wanted && isSame(*wanted, *mode))
    found->second.asked.Clear();
  known->second.hasChanged = true;
  const auto change = takeChange(found->second, known->second);
  if (change) found->second.mode = *change;
  return change;
}

void KeyRequests::setClients(const std::set<std::string>& clients) {
  for (auto& [name, robot] : robots_) {
    std::size_t gone = 0;
    for (auto& [keyName, key] : robot.keys)
      gone += std::erase_if(key.choices, [&](const auto& choice) { return !clients.contains(choice.first); });
    if (gone > 0) update(name, robot);
  }
}

std::optional<KeyMode> KeyRequests::ownMode(const std::string& robot, const std::string& key) const {
  const auto known = robots_.find(robot);
  if (known == robots_.end()) return std::nullopt;
  const auto found = known->second.keys.find(key);
  if (found == known->second.keys.end()) return std::nullopt;
  return found->second.before.value_or(found->second.isRestored ? KeyMode() : found->second.mode);
}

void KeyRequests::set(const std::string& robot, const std::string& name, Key& key, const KeyMode& mode) {
  key.mode = mode;
  isSetting_ = true;
  setMode_(robot, name, mode);
  isSetting_ = false;
}

}  // namespace robotlink::websocket
