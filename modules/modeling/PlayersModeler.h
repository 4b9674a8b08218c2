// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "modules/modeling/PlayerTracker.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

// Debug keys shared by all solutions of the task. Inline, so that they are defined in every file that
// registers a solution.
inline const robotlink::FieldDrawingKey kPlayersKey{
    "players-model/players", "The estimated positions of the other robots (drawn on the field)"};
inline const robotlink::PlotKey kPlayerCountKey{"players-model/count", "How many other robots are known"};

/// The base of solutions of the task "players-model": sends the players, and draws them. Used by its
/// process's thread; the context must outlive it.
class PlayersModeler : public robotlink::Solution {
 public:
  explicit PlayersModeler(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        model_(context.output(robotlink::kPlayersModel)),
        field_(context.robot().field) {}

 protected:
  void publish(const std::vector<TrackedPlayer>& players, const google::protobuf::Timestamp& time) {
    auto package = std::make_shared<robotcontrol::PlayersModel>();
    *package->mutable_timestamp() = time;
    for (const TrackedPlayer& player : players) {
      robotcontrol::PlayersModel::Player& added = *package->add_players();
      added.set_team(player.team);
      robotlink::assign(*added.mutable_position_in_field(), player.positionInField);
      added.set_confidence(player.confidence);
    }
    model_.send(std::move(package));
    if (debug_.on(kPlayerCountKey)) debug_.plot(kPlayerCountKey, static_cast<double>(players.size()));
    if (!debug_.on(kPlayersKey)) return;
    auto drawing = debug_.fieldDrawing(kPlayersKey);
    for (const TrackedPlayer& player : players)
      drawing.circle(player.positionInField, 0.15, teamColor(player.team, 1), 1 + 2 * player.confidence);
  }

  /// The color in which players of a team are drawn.
  robotlink::Color teamColor(const std::string& team, double alpha) const {
    return {field_ ? field_->teamColor(team) : robotlink::colors::kBlue.rgb, alpha};
  }

  /// For drawings of the derived classes.
  robotlink::DebugContext& debug_;

 private:
  robotlink::Output<robotcontrol::PlayersModel> model_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
};

}  // namespace modules
