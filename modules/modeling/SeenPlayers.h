// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "modules/modeling/PlayersModeler.h"
#include "modules/modeling/ReportedMates.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {

/// The base of those solutions of the task "players-model" that know other robots by the camera: they believe
/// those of the own team where they say that they are. They have to use the package of team messages.
class SeenPlayers : public PlayersModeler {
 public:
  explicit SeenPlayers(robotlink::SolutionContext& context)
      : PlayersModeler(context),
        team_(context.robot().team),
        name_(context.robot().name),
        messages_(context.input(robotlink::kTeamMessages)) {}

 protected:
  void publishSeen(const std::vector<TrackedPlayer>& seen, const google::protobuf::Timestamp& time) {
    publish(withReportedMates(seen, team_, reported(time)), time);
  }

 private:
  /// An older message, s, says nothing of where a robot is, nor does that of one that hardly knows it, m.
  static constexpr double kOldMessage = 1, kLostMate = 0.4;

  std::vector<robotlink::Vector2> reported(const google::protobuf::Timestamp& time) const {
    std::vector<robotlink::Vector2> places;
    if (!messages_) return places;
    const robotlink::Instant now = robotlink::instant(time);
    for (const robotcontrol::TeamMessage& message : messages_->messages()) {
      if (message.team() != team_ || message.sender() == name_ || !message.has_pose_in_field()) continue;
      if (robotlink::seconds(now - robotlink::instant(message.timestamp())) < kOldMessage &&
          message.position_deviation() < kLostMate)
        places.push_back(robotlink::pose2(message.pose_in_field()).translation());
    }
    return places;
  }

  const std::string team_, name_;
  robotlink::Input<robotcontrol::TeamMessages> messages_;
};

}  // namespace modules
