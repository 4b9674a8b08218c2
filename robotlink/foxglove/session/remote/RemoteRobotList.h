// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/foxglove/session/KeyPublishers.h"
#include "robotlink/foxglove/session/RemoteKeys.h"

namespace robotlink::websocket {

/// The robots of one server, with their names there and in the session. Names are given once and kept. One
/// thread.
class RemoteRobotList {
 public:
  struct Robot {
    /// The robot's name at the server; empty for a foreign server, which is a robot itself.
    std::string remote;
    /// The robot's name in the session.
    std::string local;
    RemoteKeys keys;
    KeyPublishers publishers;
    /// Whether the server has not mentioned it since it was reconnected.
    bool isStale = false;
  };
  /// A topic in the session.
  struct Place {
    /// Null: it belongs to no robot.
    Robot* robot = nullptr;
    /// The path after the robot's name; without a robot all of it.
    std::string stream;
    std::string path() const { return robot == nullptr ? stream : robot->local + "/" + stream; }
  };

  explicit RemoteRobotList(std::function<bool(const std::string&)> isTaken) : isTaken_(std::move(isTaken)) {}

  /// Adds a robot if it is new. `wantedName` is its name in the session, if that is free.
  void add(const std::string& remote, const std::string& wantedName);
  void remove(const std::string& remote);
  /// Call this when the connection was lost: robots that are not added again are removed by removeStale().
  void setStale();
  void removeStale();

  Place placeOf(const std::string& topic);
  Robot* findRemote(const std::string& name);
  Robot* findLocal(const std::string& name);
  std::map<std::string, Robot>& all() { return robots_; }
  /// The names in the session, in order of appearance.
  const std::vector<std::string>& names() const { return names_; }
  std::uint64_t version() const { return version_; }

 private:
  std::string freeName(const std::string& wanted) const;

  std::function<bool(const std::string&)> isTaken_;
  /// The key is the robot's name at the server.
  std::map<std::string, Robot> robots_;
  std::vector<std::string> names_;
  std::uint64_t version_ = 0;
};

}  // namespace robotlink::websocket
