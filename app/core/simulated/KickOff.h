// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/config/FieldDescription.h"

namespace simcore {
class Simulation;
}

namespace app {

/// Does what people do around a field until there is a referee: counts the goals, and a moment after a goal
/// puts the ball back to the middle and the robots to where they stood at the start. A ball that left the
/// field comes back, too.
///
/// Where the goals are is up to the field's description. Decides by the state of the simulation alone, so
/// that a run stays reproducible. The simulation must outlive it; its thread.
class KickOff {
 public:
  /// How long the ball stays in the goal, simulated.
  static constexpr robotlink::Duration kPause = std::chrono::seconds(2);

  /// Null if the scene shows no field or has no ball. The robots stand where they start.
  static std::unique_ptr<KickOff> create(std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation);

  /// To be called after each step of the world. Returns a sentence for people if something happened.
  std::optional<std::string> step();
  /// Forgets everything, after the simulation was reset.
  void restart();

  /// How many goals each team scored, by its name.
  const std::map<std::string, int>& goals() const { return goals_; }

 private:
  struct Robot {
    std::string name;
    robotlink::Pose2 start;
  };

  KickOff(std::shared_ptr<const robotlink::FieldDescription> field, simcore::Simulation& simulation);
  /// The team that scored, if the ball is in a goal.
  std::optional<std::string> scorer(const robotlink::Vector3& ball) const;
  bool onField(const robotlink::Vector3& ball) const;
  std::string score() const;
  std::optional<std::string> whilePlaying(const robotlink::Vector3& ball);
  std::optional<std::string> whileWaiting(const robotlink::Vector3& ball);
  void placeRobots();

  std::shared_ptr<const robotlink::FieldDescription> field_;
  simcore::Simulation& simulation_;
  std::string ball_;
  std::vector<Robot> robots_;
  std::map<std::string, int> goals_;
  std::optional<robotlink::Duration> outSince_;  // by the simulation's time; none: the ball is in play
};

}  // namespace app
