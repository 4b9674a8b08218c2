// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/requests/GameRequests.h"

#include "robotcontrol/Requests.pb.h"

namespace robotlink {

namespace {

/// Written so that a NaN is not within.
bool isBetween(double value, double low, double high) {
  return value >= low && value <= high;
}

}  // namespace

std::string wrongRadio(const robotcontrol::TeamRadioSettings& radio) {
  if (radio.has_range() && !isBetween(radio.range(), 0, kMaxRadioRange))
    return "the range of the radio is 0 to 1000 m";
  if (radio.has_delay() && !isBetween(radio.delay(), 0, kMaxRadioDelay))
    return "the delay of the radio is 0 to 10 s";
  if (radio.has_loss() && !isBetween(radio.loss(), 0, 1)) return "the share of messages lost is 0 to 1";
  return "";
}

std::string wrongGame(const robotcontrol::Request& request) {
  using robotcontrol::ControlGame;
  const ControlGame& control = request.control_game();
  if (!ControlGame::Action_IsValid(control.action())) return "there is no such action of the referee";
  switch (control.action()) {
    case ControlGame::PENALIZE:
    case ControlGame::RETURN:
      return control.robot().empty() ? "the robot is not named" : "";
    case ControlGame::SCORE:
      if (control.goals() > kMaxGoals) return "a team can have at most 99 goals";
      [[fallthrough]];
    case ControlGame::KICK_OFF:
      return control.team().empty() ? "the team is not named" : "";
    case ControlGame::RADIO:
      return wrongRadio(control.radio());
    default:
      return "";
  }
}

}  // namespace robotlink
