// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/game/GameRules.h"

namespace robotlink {
struct FieldDescription;
}
namespace simcore {
class StateStream;
}

namespace app {

/// Notices that robots leave the field, push opponents, hold the ball under their body, or defend where only
/// their goalkeeper may, from where all of them are at regular intervals.
///
/// A robot pushes while it touches an opponent, goes toward it, and that one gives way; not near the ball,
/// nor a goalkeeper in its own penalty area. It defends where it may not while it is in its own penalty area
/// together with its goalkeeper. All count up while they last, and pushing counts down as fast while it does
/// not.
class FoulWatch {
 public:
  /// The period of look().
  static constexpr robotlink::Duration kEvery = std::chrono::milliseconds(80);

  /// A robot that plays now.
  struct Robot {
    /// Its index, the same in all calls.
    std::size_t index = 0;
    std::size_t team = 0;
    /// The side of its goal, -1 or 1.
    int ownSide = -1;
    bool isGoalie = false;
    robotlink::Vector2 place = robotlink::Vector2::Zero();
  };
  struct Foul {
    std::size_t robot = 0;
    const GameRules::Penalty* penalty = nullptr;
  };
  /// Whether two robots, by their indices, touch each other.
  using Touching = std::function<bool(std::size_t, std::size_t)>;

  /// Both must outlive it.
  FoulWatch(const GameRules& rules, const robotlink::FieldDescription& field)
      : rules_(rules), field_(field) {}

  /// Resets all durations, for this many robots.
  void restart(std::size_t robots);
  /// Forgets what has lasted of one robot, which was put in another place.
  void forget(std::size_t robot);
  /// Looks at all robots that play. Returns the fouls that are penalized now, each once.
  std::vector<Foul> look(const std::vector<Robot>& robots, const std::optional<robotlink::Vector2>& ball,
                         const Touching& touching);

  void transfer(simcore::StateStream& stream);

 private:
  struct History {
    robotlink::Duration outside{}, pushing{}, defending{}, holding{};
    /// Its position the last time.
    std::optional<robotlink::Vector2> place;
  };
  bool pushes(const Robot& robot, const std::vector<Robot>& all,
              const std::optional<robotlink::Vector2>& ball, const Touching& touching) const;
  bool defendsIllegally(const Robot& robot, const std::vector<Robot>& all) const;
  /// m/s since the last time; 0 if it is not known where it was.
  robotlink::Vector2 velocity(const Robot& robot) const;

  const GameRules& rules_;
  const robotlink::FieldDescription& field_;
  /// The history of each robot, by its index.
  std::vector<History> histories_;
};

}  // namespace app
