// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/team/GameEnds.h"
#include "app/core/team/TeamSocket.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace robotlink {
class Platform;
}

namespace app {

/// The link by which a robot hears its team over UDP. A plain value.
struct TeamLinkOptions {
  /// The port at which it receives; unset: it has no such link.
  std::optional<std::uint16_t> port = {};
  /// "HOST:PORT" of the others.
  std::vector<std::string> peers = {};
  /// Empty: the one that is known of the robot, or else "team".
  std::string team = {};
};

/// The link of a robot, whose body is not simulated here, to those of its team on other machines: sends what
/// its program tells them over UDP, and gives the program what it hears, the newest of each. What is damaged,
/// of other versions or of other teams is left out. One thread.
class TeamLink {
 public:
  /// Opens the port. Fails with the reason.
  static robotlink::Result<std::unique_ptr<TeamLink>> open(const TeamLinkOptions& options,
                                                           const std::string& robot, const std::string& team);

  /// Gives the platform of the robot the ends of packages; call this once, before its program is made.
  /// Fails if it has them itself. This object must outlive the platform.
  robotlink::Result<void> attach(robotlink::Platform& platform);
  /// Call this after each step of the platform.
  void step(robotlink::Instant now);

  std::uint16_t port() const { return socket_->port(); }
  /// Numbers of datagrams sent, received, and left out.
  struct Counts {
    std::uint64_t sent = 0, heard = 0, leftOut = 0;
  };
  const Counts& counts() const { return counts_; }

 private:
  TeamLink(std::unique_ptr<TeamSocket> socket, std::string robot, std::string team);
  void send();
  /// Returns whether something new was received.
  bool hear();

  const std::unique_ptr<TeamSocket> socket_;
  const std::string robot_, team_;
  const std::shared_ptr<GameMail> mail_ = std::make_shared<GameMail>();
  std::unique_ptr<GameEnds> ends_;
  /// The newest message of each sender, by its name.
  std::map<std::string, std::shared_ptr<const robotcontrol::TeamMessage>> newest_;
  Counts counts_;
};

}  // namespace app
