// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/RemoteKeys.h"

#include <algorithm>
#include <utility>

namespace robotlink::websocket {

using robotcontrol::KeyMode;
using robotcontrol::KeyTable;

RemoteKeys::Outcome RemoteKeys::set(const robotcontrol::SetKey& request) {
  const Key* key = find(request.name());
  if (key == nullptr) {
    if (hasTable() || request.mode().kind() != KeyMode::ALWAYS) return {true, false};
    // The robot says whether it has the key; what the key publishes is known, and subscribed to, with the
    // table.
    choose(request);
    return {true, wanted_.insert(request.name()).second};
  }
  const bool wasChosen = choices_.erase(request.name()) + counted_.erase(request.name()) > 0;
  // Keys that publish no stream are none that one can subscribe to.
  if (key->stream().empty()) {
    choose(request);
    return {true, true};
  }
  if (areChannels_ && isOn(request.mode())) return {false, wanted_.insert(request.name()).second};
  switch (request.mode().kind()) {
    case KeyMode::ALWAYS:
      return {false, wanted_.insert(request.name()).second || wasChosen, wasChosen};
    case KeyMode::OFF: {
      const bool wasWanted = wanted_.erase(request.name()) > 0;
      if (!isOn(key->mode())) return {false, wasWanted, wasChosen};
      choose(request);
      return {true, true};
    }
    case KeyMode::N_TIMES:
      choose(request);
      return {true, wanted_.insert(request.name()).second || wasChosen};
    default:
      choose(request);
      wanted_.insert(request.name());
      return {false, true, true};
  }
}

/// Notes a choice. A mode with a count ends by itself, and is not sent again.
void RemoteKeys::choose(const robotcontrol::SetKey& request) {
  if (request.mode().kind() == KeyMode::N_TIMES)
    counted_.insert(request.name());
  else
    choices_[request.name()] = request.mode();
}

void RemoteKeys::setUnsent() {
  areUnsent_ = true;
  counted_.clear();
}

std::optional<KeyMode> RemoteKeys::choice(const std::string& key) const {
  const auto found = choices_.find(key);
  return found == choices_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> RemoteKeys::takeUnsent() {
  std::vector<std::string> names;
  if (!std::exchange(areUnsent_, false)) return names;
  for (const auto& [name, mode] : choices_) names.push_back(name);
  return names;
}

void RemoteKeys::setChannelKeys(const KeyTable& table) {
  table_ = table;
  areChannels_ = true;
}

KeyTable RemoteKeys::shown(KeyTable table) const {
  for (Key& key : *table.mutable_keys()) {
    if (!isOn(key.mode()) && wanted_.contains(key.name())) key.mutable_mode()->set_kind(KeyMode::ALWAYS);
    if (const auto chosen = choice(key.name())) *key.mutable_mode() = *chosen;
  }
  return table;
}

bool RemoteKeys::wants(const std::string& stream) const {
  const Key* key = keyOf(stream);
  if (key == nullptr) return false;
  const auto chosen = choice(key->name());
  return chosen ? isOn(*chosen) : wanted_.contains(key->name()) || isOn(key->mode());
}

const RemoteKeys::Key* RemoteKeys::find(const std::string& name) const {
  const auto found = std::ranges::find(table_.keys(), name, [](const Key& key) { return key.name(); });
  return found == table_.keys().end() ? nullptr : &*found;
}

/// A plot's curves, and the stopwatches of the processes, have streams below that of their key.
const RemoteKeys::Key* RemoteKeys::keyOf(const std::string& stream) const {
  const auto found = std::ranges::find_if(table_.keys(), [&](const Key& key) {
    const std::string& own = key.stream();
    return !own.empty() && stream.starts_with(own) &&
           (stream.size() == own.size() || stream[own.size()] == '/');
  });
  return found == table_.keys().end() ? nullptr : &*found;
}

bool RemoteKeys::isOn(const KeyMode& mode) {
  return mode.kind() != KeyMode::OFF;
}

}  // namespace robotlink::websocket
