// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/behavior/SoccerMind.h"

namespace modules {

/// A soccer player of a team: a hierarchy of options on plain values, from the phase of the game by the role
/// in the team to skills with the ball. What its options are is documented by their helps, see
/// SoccerOptions.cpp. Not thread-safe; it must not be moved.
class SoccerPlayer {
 public:
  using Options = SoccerMind::Options;

  /// `field` is that of the places.
  SoccerPlayer(const robotlink::FieldDescription& field, const Options& options);
  SoccerPlayer(const SoccerPlayer&) = delete;
  SoccerPlayer& operator=(const SoccerPlayer&) = delete;

  /// Takes effect with the next decide(); the places stay those of the constructor.
  void setOptions(const Options& options) { mind_.setOptions(options); }
  void setControl(OptionMachine::Control control) { mind_.setControl(std::move(control)); }

  /// Call it once a frame.
  Intention decide(const GameSituation& now) { return mind_.decide(now); }

  const OptionMachine& machine() const { return mind_.machine(); }
  Role role() const { return mind_.role(); }
  /// The estimate that the team receives, s.
  double secondsToBall() const { return mind_.secondsToBall(); }
  // For drawings: where it walks to, in the robot's frame, and the direction in which it plays the ball.
  const std::optional<robotlink::Vector2>& target() const { return mind_.target(); }
  std::optional<double> aim() const { return mind_.aim(); }

 private:
  SoccerMind mind_;
};

}  // namespace modules
