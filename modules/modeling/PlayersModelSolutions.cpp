// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "players-model": the positions of other robots.
#include "ModelingParameters.pb.h"
#include "modules/modeling/PlayerTracker.h"
#include "modules/modeling/SeenPlayers.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

class PerceptPlayers final : public SeenPlayers {
 public:
  explicit PerceptPlayers(robotlink::SolutionContext& context)
      : SeenPlayers(context),
        percepts_(context.input(robotlink::kRobotPercepts)),
        pose_(context.input(robotlink::kRobotPose)),
        parameters_(context.parameters<robotcontrol::PerceptPlayersParameters>()) {}

  void execute() override {
    if (!percepts_ || !percepts_.isNew() || !pose_) return;
    const robotlink::Pose2 robotInField = robotlink::pose2(pose_->robot_in_field());
    seen_.clear();
    for (const robotcontrol::RobotPercept& percept : percepts_->robots())
      seen_.push_back({percept.team(), robotInField * robotlink::vector2(percept.position_in_robot()),
                       percept.confidence()});
    tracker_.setOptions(
        {parameters_.same_within(), parameters_.half_life(), parameters_.forget_below(), parameters_.pull()});
    tracker_.update(robotlink::seconds(robotlink::instant(percepts_->timestamp())), seen_);
    publishSeen(tracker_.players(), percepts_->timestamp());
  }

 private:
  robotlink::Input<robotcontrol::RobotPercepts> percepts_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  const robotcontrol::PerceptPlayersParameters& parameters_;
  PlayerTracker tracker_{{}};
  std::vector<TrackedPlayer> seen_;
};

const robotlink::SolutionRegistration kPercepts =
    robotlink::SolutionBuilder<PerceptPlayers>(
        "players-model", "percepts",
        "Remembers robots that were seen until they have been out of sight for a while.")
        .source("A method of this project.")
        .needs(robotlink::kRobotPercepts)
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kTeamMessages)
        .yields(robotlink::kPlayersModel)
        .keys({&kPlayersKey, &kPlayerCountKey})
        .parameters<robotcontrol::PerceptPlayersParameters>();

class OraclePlayers final : public PlayersModeler {
 public:
  explicit OraclePlayers(robotlink::SolutionContext& context)
      : PlayersModeler(context), world_(context.input(robotlink::kOracleWorld)) {}

  void execute() override {
    if (!world_ || !world_.isNew()) return;
    std::vector<TrackedPlayer> players;
    for (const robotcontrol::OracleWorld::Robot& robot : world_->others())
      players.push_back({robot.team(), robotlink::pose2(robot.pose_in_field()).translation(), 1});
    publish(players, world_->timestamp());
  }

 private:
  robotlink::Input<robotcontrol::OracleWorld> world_;
};

const robotlink::SolutionRegistration kOraclePlayers =
    robotlink::SolutionBuilder<OraclePlayers>("players-model", "oracle",
                                              "The true positions of the other robots, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kPlayersModel)
        .keys({&kPlayersKey, &kPlayerCountKey});

}  // namespace
}  // namespace modules
