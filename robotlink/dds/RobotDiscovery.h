// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/dds/Node.h"

namespace robotlink::dds {

/// A robot that a program announces. A plain value.
struct AnnouncedRobot {
  /// "red1".
  std::string name;
  /// The kind of the robot, "ers210"; empty: not known.
  std::string kind = {};
  /// The layout that its program runs in, "compact"; empty: not known.
  std::string layout = {};
  /// Whether only its body is there, so that its program can run elsewhere.
  bool isBody = false;
  bool operator==(const AnnouncedRobot&) const = default;
};

/// The announcement of a program that lets others watch and steer its robots (--listen). A plain value.
struct AnnouncedRobots {
  /// At least one.
  std::vector<AnnouncedRobot> robots;
  /// The address to which clients connect.
  std::string address;
  std::uint16_t port = 0;
  bool isEncrypted = false;
  /// The fingerprint of its certificate; empty without encryption. It is only what the network says: a client
  /// still has to compare it.
  std::string fingerprint = {};

  /// "wss://192.168.1.20:8765".
  std::string url() const;
  /// "red1, red2".
  std::string names() const;
  bool operator==(const AnnouncedRobots&) const = default;
};

/// Announces robots on networks as long as it exists.
class RobotAnnouncement {
 public:
  /// The announcement names no address: on each node it is that of its interface.
  static Result<std::unique_ptr<RobotAnnouncement>> open(std::vector<std::shared_ptr<Node>> nodes,
                                                         const AnnouncedRobots& robots);
  ~RobotAnnouncement();
  /// Announces other robots from now on, at the same place.
  void update(const std::vector<AnnouncedRobot>& robots);

 private:
  struct Implementation;
  explicit RobotAnnouncement(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// Lists the robots that are currently announced on networks. Robots that leave are removed at once, or
/// after a second if they cannot announce it. Any thread.
class RobotDiscovery {
 public:
  static Result<std::unique_ptr<RobotDiscovery>> open(std::vector<std::shared_ptr<Node>> nodes);
  ~RobotDiscovery();

  /// Sorted by the names of the robots; each address once.
  std::vector<AnnouncedRobots> robots() const;

 private:
  struct Implementation;
  explicit RobotDiscovery(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

/// Nodes for announcements, in a domain of their own, found by multicast: on the interface with this address,
/// or, for "0.0.0.0" and an empty one, on all of this machine. None for the loopback interface. Interfaces
/// where DDS does not work are left out.
std::vector<std::shared_ptr<Node>> announcementNodes(const std::string& address);

}  // namespace robotlink::dds
