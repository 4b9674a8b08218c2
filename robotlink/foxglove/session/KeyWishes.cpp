// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/KeyWishes.h"

#include <algorithm>

namespace robotlink::websocket {

using robotcontrol::KeyMode;
using robotcontrol::KeyTable;

KeyWishes::Outcome KeyWishes::set(const robotcontrol::SetKey& request) {
  const Key* key = find(request.name());
  // Keys that publish no stream are none that one can subscribe to.
  if (key == nullptr || key->stream().empty()) return {true, false};
  if (areChannels_ && request.mode().kind() != KeyMode::OFF)
    return {false, wanted_.insert(request.name()).second};
  switch (request.mode().kind()) {
    case KeyMode::ALWAYS:
      return {false, wanted_.insert(request.name()).second};
    case KeyMode::OFF:
      return {isOn(*key), wanted_.erase(request.name()) > 0};
    default:
      return {true, wanted_.insert(request.name()).second};
  }
}

void KeyWishes::setChannelKeys(const KeyTable& table) {
  table_ = table;
  areChannels_ = true;
}

KeyTable KeyWishes::shown(KeyTable table) const {
  for (Key& key : *table.mutable_keys()) {
    if (!isOn(key) && wanted_.contains(key.name())) key.mutable_mode()->set_kind(KeyMode::ALWAYS);
  }
  return table;
}

bool KeyWishes::wants(const std::string& stream) const {
  const Key* key = keyOf(stream);
  return key != nullptr && (wanted_.contains(key->name()) || isOn(*key));
}

const KeyWishes::Key* KeyWishes::find(const std::string& name) const {
  const auto found = std::ranges::find(table_.keys(), name, [](const Key& key) { return key.name(); });
  return found == table_.keys().end() ? nullptr : &*found;
}

/// A plot's curves, and the stopwatches of the processes, have streams below that of their key.
const KeyWishes::Key* KeyWishes::keyOf(const std::string& stream) const {
  const auto found = std::ranges::find_if(table_.keys(), [&](const Key& key) {
    const std::string& own = key.stream();
    return !own.empty() && stream.starts_with(own) &&
           (stream.size() == own.size() || stream[own.size()] == '/');
  });
  return found == table_.keys().end() ? nullptr : &*found;
}

bool KeyWishes::isOn(const Key& key) {
  return key.mode().kind() != KeyMode::OFF;
}

}  // namespace robotlink::websocket
