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
class StateStream;
}  // namespace simcore

namespace app {

/// Stands in for a referee: counts goals and, some time after a goal or after the ball has left the field,
/// puts the ball back to the center and the robots to where they stood at the start.
///
/// The field description says where the goals are. Decisions depend on the state of the simulation only, so a
/// run stays reproducible. Used in the simulation's thread; the simulation must outlive it.
class KickOff {
 public:
  /// Simulated time from the goal to the kick-off.
  static constexpr robotlink::Duration kPause = std::chrono::seconds(2);

  /// Returns null if the scene has no field or no ball. The present poses of the robots are their starts.
  static std::unique_ptr<KickOff> create(std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation);

  /// To be called after each step of the world. Returns a sentence for the user if something happened.
  std::optional<std::string> step();
  /// To be called after a reset of the simulation: sets the score to 0.
  void restart();

  /// Writes or reads the score, and since when the ball is out.
  void transfer(simcore::StateStream& stream);
  /// The simulation went back or on to another instant: a ball that is out has left just now.
  void worldJumped() { outSince_.reset(); }

  /// The goals so far, and since when the ball is out.
  struct Score {
    std::map<std::string, int> goals;
    std::optional<robotlink::Duration> outSince;
  };
  Score present() const { return {goals_, outSince_}; }
  void adopt(const Score& score) {
    goals_ = score.goals;
    outSince_ = score.outSince;
  }
  /// To be called when there are other models: robots that are new start where they are now. False if there
  /// is no game any more.
  bool followModels();

  /// Goals by the name of the team that scored.
  const std::map<std::string, int>& goals() const { return goals_; }

 private:
  /// A robot and where it starts.
  struct Robot {
    std::string name;
    robotlink::Pose2 start;
  };

  KickOff(std::shared_ptr<const robotlink::FieldDescription> field, simcore::Simulation& simulation);
  /// Returns the team that scored if the ball is in a goal.
  std::optional<std::string> scorer(const robotlink::Vector3& ball) const;
  /// Whether the ball is on the field, with some margin.
  bool onField(const robotlink::Vector3& ball) const;
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
