// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotcontrol/Requests.pb.h"

namespace robotlink::websocket {

/// The debug keys of one robot at the far end, as a session here sees them. While the session wants what a
/// key publishes, it subscribes to it, and the robot switches the key on for it. It can also choose a mode
/// such as "every 3", a mode of a key without a stream, or that a key that is on at the robot is off. Choices
/// end with the connection, too, and are made again in the next one. The robot's tables have the modes
/// without both: keys that are on only because of clients are off in them. One thread.
class RemoteKeys {
 public:
  /// The effect of a request to set a key.
  struct Outcome {
    /// Whether the request is also forwarded to the robot, where it counts as this client's choice.
    bool isForwarded = false;
    /// The streams that are wanted have changed.
    bool hasChanged = false;
    /// The mode that this client has chosen has changed, and has to be sent to the robot: see choice().
    bool isChoice = false;
  };

  Outcome set(const robotcontrol::SetKey& request);
  /// The mode that a key has for this client, as long as it is connected; nothing if it has chosen none.
  std::optional<robotcontrol::KeyMode> choice(const std::string& key) const;
  /// Marks all choices as unsent, because the robot has forgotten them.
  void setUnsent();
  /// The keys whose modes have to be sent.
  std::vector<std::string> takeUnsent();
  /// The newest table of the robot.
  void setTable(const robotcontrol::KeyTable& table) { table_ = table; }
  /// For a robot without debug keys: each of these represents a channel that is subscribed to while it is on.
  void setChannelKeys(const robotcontrol::KeyTable& table);
  bool hasTable() const { return table_.keys_size() > 0; }

  /// The newest table, or another one of the robot, as it is shown here.
  robotcontrol::KeyTable shown() const { return shown(table_); }
  robotcontrol::KeyTable shown(robotcontrol::KeyTable table) const;
  /// Whether a stream, named without the robot, is published by a key; and whether it is wanted.
  bool isOfKey(const std::string& stream) const { return keyOf(stream) != nullptr; }
  bool wants(const std::string& stream) const;

 private:
  using Key = robotcontrol::KeyTable::Key;
  const Key* find(const std::string& name) const;
  const Key* keyOf(const std::string& stream) const;
  void choose(const robotcontrol::SetKey& request);
  static bool isOn(const robotcontrol::KeyMode& mode);

  robotcontrol::KeyTable table_;
  std::set<std::string> wanted_;
  std::map<std::string, robotcontrol::KeyMode> choices_;
  /// Keys for which a number of times was chosen, which the robot keeps until another is chosen.
  std::set<std::string> counted_;
  bool areUnsent_ = false;
  bool areChannels_ = false;
};

}  // namespace robotlink::websocket
