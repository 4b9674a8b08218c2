// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/remote/ListenAccess.h"
#include "robotlink/base/Worker.h"
#include "robotlink/dds/RobotDiscovery.h"
#include "robotlink/foxglove/server/ListenAddress.h"

namespace robotlink {
class Session;
}

namespace app {

/// The robots of a session, with what their streams "program" say of them.
std::vector<robotlink::dds::AnnouncedRobot> robotsToAnnounce(robotlink::Session& session);

/// Announces robots on the networks of an address, from its first update() on, as long as it exists; never on
/// the loopback interface. DDS begins and ends in a thread of its own. Where it does not work, nothing is
/// announced. One thread uses it.
class RobotAnnouncer {
 public:
  /// The nodes for an address, as announcementNodes().
  using Nodes = std::function<std::vector<std::shared_ptr<robotlink::dds::Node>>(const std::string& address)>;

  /// `address` is where clients connect, with the port that was found free.
  RobotAnnouncer(const robotlink::websocket::ListenAddress& address, const ListenAccess& access,
                 Nodes nodes = robotlink::dds::announcementNodes);

  /// Announces these robots; does nothing if they are announced already.
  void update(std::vector<robotlink::dds::AnnouncedRobot> robots);

 private:
  using Robots = std::vector<robotlink::dds::AnnouncedRobot>;
  void announce(const Robots& robots);

  const std::string address_;
  const Nodes nodes_;
  /// The robots of the last announcement.
  Robots announced_;
  /// The following two are used in the thread only.
  robotlink::dds::AnnouncedRobots what_;
  std::unique_ptr<robotlink::dds::RobotAnnouncement> announcement_;
  /// The last member, since its thread uses the others.
  std::unique_ptr<robotlink::Worker<Robots>> worker_;
};

}  // namespace app
