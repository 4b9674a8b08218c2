// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Debugging.pb.h"

namespace robotlink::websocket {

/// Switches debug keys on for as long as a client at the far end of a link subscribes to what they publish,
/// or has chosen a mode.
///
/// A key that is on already stays as it is for subscribers. One whose mode was changed here gets its own mode
/// back when the last client that wants another one has gone, unless another user set it in the meantime:
/// then that holds. A robot whose program
/// restarts keeps its keys (they are overrides), so nothing has to be repeated. One thread.
class KeyRequests {
 public:
  /// Asks a robot to set a key.
  using SetMode = std::function<void(const std::string& robot, const std::string& key,
                                     const robotcontrol::KeyMode& mode)>;

  explicit KeyRequests(SetMode setMode) : setMode_(std::move(setMode)) {}

  /// The subscribers of one of a robot's streams, after each change; none: the last one has gone.
  void setSubscribers(const std::string& robot, const std::string& stream,
                      const std::set<std::string>& clients);
  /// Takes the mode that a client chooses for as long as it is connected. Of several choices the one counts
  /// that publishes most, which is "always" while a client without a choice subscribes. A choice of "off"
  /// counts only while no other client wants the key on. Without a mode the choice is withdrawn. Returns the
  /// mode that the robot is to be asked for now; nothing if its mode stays.
  std::optional<robotcontrol::KeyMode> choose(const std::string& robot, const std::string& key,
                                              const std::string& client,
                                              const std::optional<robotcontrol::KeyMode>& mode);
  /// Only these clients are still there.
  void setClients(const std::set<std::string>& clients);
  /// A robot is gone, and its streams with it. Should it come back, keys that were switched on here get their
  /// modes back.
  void forgetSubscribers(const std::string& robot);
  /// The newest table of a robot's keys.
  void setTable(const std::string& robot, const robotcontrol::KeyTable& table);
  /// Call this when a local view or script sets a key explicitly. Ignored while this object itself
  /// does.
  void noteChosen(const std::string& robot, const std::string& key, const robotcontrol::KeyMode& mode);

  /// The clients that subscribe to what a robot's keys publish, or have chosen a mode, by key.
  std::map<std::string, std::set<std::string>> clientsByKey(const std::string& robot) const;
  /// Returns the same for keys that are on only because of them, also while such a key, to which no client
  /// subscribes any longer, may still be on.
  std::map<std::string, std::set<std::string>> onDemand(const std::string& robot) const;
  /// The mode that a key has without these clients; nothing if it is not known.
  std::optional<robotcontrol::KeyMode> ownMode(const std::string& robot, const std::string& key) const;
  /// Whether they may have changed since this was asked last.
  bool takeChanged(const std::string& robot);
  /// Gives all keys that were switched on here their modes back, because no client can subscribe any longer.
  void restoreAll();

 private:
  struct Key {
    std::string stream;
    robotcontrol::KeyMode mode;
    /// The mode to restore; empty: it was not changed here.
    std::optional<robotcontrol::KeyMode> before;
    /// The mode that was requested here while `before` is set.
    robotcontrol::KeyMode asked;
    /// Clients with the modes that they have chosen.
    std::vector<std::pair<std::string, robotcontrol::KeyMode>> choices;
    /// Whether its own mode was requested back, and no table confirms that yet.
    bool isRestored = false;
    /// While there are subscribers: whether another user set it.
    bool isTheirs = false;
  };
  struct Robot {
    std::map<std::string, Key> keys;
    /// Clients by stream.
    std::map<std::string, std::set<std::string>> subscribers;
    bool hasChanged = false;
  };

  static bool publishesOn(const Key& key, const std::string& stream);
  static std::set<std::string> subscribersOf(const Key& key, const Robot& robot);
  /// The mode that clients want it to have; nothing if it is to have its own.
  static std::optional<robotcontrol::KeyMode> wantedMode(const Key& key, const Robot& robot);
  /// The mode that the robot is to be asked for, if it is another one now.
  static std::optional<robotcontrol::KeyMode> takeChange(Key& key, const Robot& robot);
  /// Gives keys the modes that clients want, and their own to those that no client wants changed any longer.
  void update(const std::string& name, Robot& robot);
  void set(const std::string& robot, const std::string& name, Key& key, const robotcontrol::KeyMode& mode);

  SetMode setMode_;
  std::map<std::string, Robot> robots_;
  bool isSetting_ = false;
};

}  // namespace robotlink::websocket
