// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/game/Umpire.h"
#include "robotlink/base/Clock.h"
#include "robotlink/config/FieldDescription.h"

namespace simcore {
class Simulation;
}  // namespace simcore

namespace app {

/// Stands in for a referee where no rules are named: counts goals and, some time after a goal or after the
/// ball has left the field, puts the ball back to the center and the robots to where they stood at the start.
///
/// The field description says where the goals are. Decisions depend on the state of the simulation only, so a
/// run stays reproducible. Used in the simulation's thread; the simulation must outlive it.
class KickOff final : public Umpire {
 public:
  /// Simulated time from the goal to the kick-off.
  static constexpr robotlink::Duration kPause = std::chrono::seconds(2);

  /// Returns null if the scene has no field or no ball. The present poses of the robots are their starts.
  static std::unique_ptr<KickOff> create(std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation);

  std::vector<std::string> step() override;
  void restart() override;
  void transfer(simcore::StateStream& stream) override;
  /// A ball that is out has left just now.
  void worldJumped() override { outSince_.reset(); }
  /// Robots that are new start where they are now.
  bool followModels() override;
  const std::map<std::string, int>& goals() const override { return goals_; }

 private:
  /// A robot and where it starts.
  struct Robot {
    std::string name;
    robotlink::Pose2 start;
  };

  KickOff(std::shared_ptr<const robotlink::FieldDescription> field, simcore::Simulation& simulation);
  /// Returns the team that scored if the ball is in a goal.
  std::optional<std::string> scorer(const robotlink::Vector3& ball) const;
  /// The score in words.
  std::string score() const;
  /// The two phases of step().
  std::optional<std::string> whilePlaying(const robotlink::Vector3& ball);
  std::optional<std::string> whileWaiting(const robotlink::Vector3& ball);
  /// Puts all robots back to where they started, as far as there is room.
  void placeRobots();

  std::shared_ptr<const robotlink::FieldDescription> field_;
  simcore::Simulation& simulation_;
  /// The name of the ball's model.
  std::string ball_;
  std::vector<Robot> robots_;
  std::map<std::string, int> goals_;
  /// The simulation's time when the ball left play; unset while it is in play.
  std::optional<robotlink::Duration> outSince_;
};

}  // namespace app
