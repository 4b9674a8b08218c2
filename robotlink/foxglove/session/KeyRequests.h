// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "robotcontrol/Debugging.pb.h"

namespace robotlink::websocket {

/// Switches debug keys on for as long as somebody at the far end of a link subscribes to what they publish.
///
/// A key that is on already stays as it is. One that was switched on here gets its mode back when the last
/// subscriber has gone, unless somebody else set it in the meantime: then that holds. A robot whose program
/// starts anew keeps its keys (they are overrides), so nothing has to be repeated. One thread.
class KeyRequests {
 public:
  /// Asks a robot to set a key.
  using SetMode = std::function<void(const std::string& robot, const std::string& key,
                                     const robotcontrol::KeyMode& mode)>;

  explicit KeyRequests(SetMode setMode) : setMode_(std::move(setMode)) {}

  /// The subscribers of one of a robot's streams, after each change; none: the last one has gone.
  void setSubscribers(const std::string& robot, const std::string& stream,
                      const std::set<std::string>& clients);
  /// A robot is gone, and its streams with it. Should it come back, keys that were switched on here get their
  /// modes back.
  void forgetSubscribers(const std::string& robot);
  /// The newest table of a robot's keys.
  void setTable(const std::string& robot, const robotcontrol::KeyTable& table);
  /// Somebody (a view, a script, also a client by its own request) sets a key explicitly. Ignored while this
  /// object itself does.
  void noteChosen(const std::string& robot, const std::string& key, const robotcontrol::KeyMode& mode);

  /// The clients that subscribe to what a robot's keys publish, by key.
  std::map<std::string, std::set<std::string>> clientsByKey(const std::string& robot) const;
  /// The same for the keys that are on only because of them, also while such a key, which nobody subscribes
  /// to any more, may still be on.
  std::map<std::string, std::set<std::string>> onDemand(const std::string& robot) const;
  /// Whether they may have changed since this was asked last.
  bool takeChanged(const std::string& robot);
  /// Gives all keys that were switched on here their modes back, because nobody can subscribe any more.
  void restoreAll();

 private:
  struct Key {
    std::string stream;
    robotcontrol::KeyMode mode;
    /// The mode to restore; empty: it was not switched on here.
    std::optional<robotcontrol::KeyMode> before;
    /// Its mode was asked back, and no table says yet that it is.
    bool isRestored = false;
    /// While there are subscribers: somebody else set it.
    bool isTheirs = false;
  };
  struct Robot {
    std::map<std::string, Key> keys;
    /// Clients by stream.
    std::map<std::string, std::set<std::string>> subscribers;
    bool hasChanged = false;
  };

  static bool publishesOn(const Key& key, const std::string& stream);
  /// Switches keys that have subscribers on, and those that have none any more back.
  void update(const std::string& name, Robot& robot);
  void set(const std::string& robot, const std::string& name, Key& key, const robotcontrol::KeyMode& mode);

  SetMode setMode_;
  std::map<std::string, Robot> robots_;
  bool isSetting_ = false;
};

}  // namespace robotlink::websocket
