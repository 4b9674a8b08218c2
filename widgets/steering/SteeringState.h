// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

namespace robotlink {
class Session;
}

namespace widgets {

/// The person who steers a robot that several people can steer over a link. A plain value.
struct SteeringState {
  enum class Who { kNobody, kThisPerson, kOther };
  Who who = Who::kNobody;
  /// "RobotControl of anna at 10.0.0.7:51234"; empty: nobody.
  QString name;
  /// Whether that person is silent, so that the robot was told to stop.
  bool isSilent = false;
  /// A sentence: "RobotControl of anna at 10.0.0.7:51234 steers red1."
  QString text;
  /// Details that the robot reports.
  QString details;

  /// Whether commands from here would be refused, because another client steers.
  bool isOthers() const { return who == Who::kOther && !isSilent; }
};

/// Whether the line to a remote robot is lost, so that it stands still and nobody here steers it.
bool isLost(const robotlink::Session& session, const std::string& robot);

/// The robot's last report; unset if it has not reported, so that it can be steered from here only, or
/// nobody has steered it yet, or if the line to it is lost.
std::optional<SteeringState> steeringState(robotlink::Session& session, const std::string& robot);

}  // namespace widgets
