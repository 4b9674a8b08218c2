// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "team-ball": where the team believes the ball to be.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ModelingParameters.pb.h"
#include "modules/modeling/team/TeamBallFusion.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {
namespace {

using robotlink::kAboveZero;
using robotlink::kAtLeastZero;
using robotlink::Pose2;
using robotlink::Vector2;

const robotlink::FieldDrawingKey kTeamBallKey{
    "team-ball/ball", "The team's estimate of the ball's position with its uncertainty (drawn on the field)"};
const robotlink::FieldDrawingKey kReportsKey{
    "team-ball/reports",
    "Each team robot's estimate of the ball, with a line from the robot (drawn on the field)"};
const robotlink::PlotKey kTeamBallPlotKey{
    "team-ball/position", "Position of the team's ball, its deviation, and how many robots it is based on"};

/// The clocks of robots on different machines may differ by more than this, s; their messages then count from
/// their arrival.
constexpr double kSameClock = 3;

/// The common part of both solutions: what the robot itself knows, the package, and drawings.
class TeamBallModeler : public robotlink::Solution {
 public:
  explicit TeamBallModeler(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        name_(context.robot().name),
        ball_(context.input(robotlink::kBallModel)),
        pose_(context.input(robotlink::kRobotPose)),
        model_(context.output(robotlink::kTeamBall)) {}

  void execute() override {
    if (!ball_ || !ball_.isNew()) return;
    now_ = robotlink::seconds(robotlink::instant(ball_->timestamp()));
    reports_.clear();
    if (pose_ && ball_->known()) reports_.push_back(ownReport());
    addReports(reports_);
    publish(TeamBallFusion(options()).fuse(reports_));
  }

 protected:
  virtual TeamBallFusion::Options options() const = 0;
  virtual void addReports(std::vector<BallReport>& /*reports*/) {}
  /// The time of the ball's model, s.
  double now() const { return now_; }

 private:
  BallReport ownReport() const {
    const Pose2 robot = robotlink::pose2(pose_->robot_in_field());
    BallReport own;
    own.robot = name_;
    own.position = robot * robotlink::vector2(ball_->position_in_robot());
    own.velocity = Pose2{0, 0, robot.heading} * robotlink::vector2(ball_->velocity_in_robot());
    own.covariance = ballCovariance(own.position, ball_->standard_deviation(), robot,
                                    pose_->position_deviation(), pose_->heading_deviation());
    // The model is current; it only lacks the growing doubt about a ball that is not seen.
    own.age = 0;
    return own;
  }

  void publish(const std::optional<FusedBall>& ball) {
    auto package = std::make_shared<robotcontrol::TeamBall>();
    *package->mutable_timestamp() = ball_->timestamp();
    package->set_known(ball.has_value());
    if (ball) {
      robotlink::assign(*package->mutable_position_in_field(), ball->position);
      robotlink::assign(*package->mutable_velocity_in_field(), ball->velocity);
      package->set_standard_deviation(ball->deviation());
      for (const std::string& robot : ball->robots) package->add_seen_by(robot);
    }
    model_.send(std::move(package));
    draw(ball);
  }

  void draw(const std::optional<FusedBall>& ball) {
    if (debug_.on(kTeamBallKey)) {
      auto drawing = debug_.fieldDrawing(kTeamBallKey);
      if (ball) {
        drawing.circle(ball->position, 0.05, robotlink::colors::kOrange, 3);
        drawing.circle(ball->position, 0.05 + ball->deviation(), robotlink::colors::kOrange);
        if (ball->velocity.norm() > 0.02)
          drawing.arrow(ball->position, ball->position + ball->velocity, robotlink::colors::kOrange);
      }
    }
    if (debug_.on(kReportsKey)) {
      auto drawing = debug_.fieldDrawing(kReportsKey);
      for (const BallReport& report : reports_) {
        drawing.circle(report.position, 0.03 + std::sqrt(0.5 * report.covariance.trace()),
                       robotlink::colors::kGray);
        drawing.text(report.position, report.robot, robotlink::colors::kGray, 8);
      }
    }
    if (!debug_.on(kTeamBallPlotKey)) return;
    debug_.plot(kTeamBallPlotKey, "robots", ball ? static_cast<double>(ball->robots.size()) : 0);
    if (!ball) return;
    debug_.plot(kTeamBallPlotKey, "x", ball->position.x(), "m");
    debug_.plot(kTeamBallPlotKey, "y", ball->position.y(), "m");
    debug_.plot(kTeamBallPlotKey, "deviation", ball->deviation(), "m");
  }

  robotlink::DebugContext& debug_;
  std::string name_;
  robotlink::Input<robotcontrol::BallModel> ball_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Output<robotcontrol::TeamBall> model_;
  std::vector<BallReport> reports_;
  double now_ = 0;
};

class OwnTeamBall final : public TeamBallModeler {
 public:
  using TeamBallModeler::TeamBallModeler;

 private:
  TeamBallFusion::Options options() const override { return {}; }
};

const robotlink::SolutionRegistration kOwnBall =
    robotlink::SolutionBuilder<OwnTeamBall>("team-ball", "own",
                                            "The robot's own estimate of the ball, regardless of its team.")
        .source("A method of this project.")
        .needs(robotlink::kBallModel)
        .needs(robotlink::kRobotPose)
        .yields(robotlink::kTeamBall)
        .keys({&kTeamBallKey, &kReportsKey, &kTeamBallPlotKey});

using FusionFields = robotcontrol::WeightedTeamBallParameters;
using FusionOptions = TeamBallFusion::Options;
const robotlink::ParameterTable<FusionOptions> kFusionTable{
    {FusionFields::kMemoryFieldNumber, &FusionOptions::memory, kAtLeastZero},
    {FusionFields::kDriftFieldNumber, &FusionOptions::drift, kAtLeastZero},
    {FusionFields::kGateFieldNumber, &FusionOptions::gate, kAboveZero},
    {FusionFields::kDecelerationFieldNumber, +[](FusionOptions& o) -> double& { return o.roll.deceleration; },
     kAtLeastZero},
    {FusionFields::kDampingFieldNumber, +[](FusionOptions& o) -> double& { return o.roll.damping; },
     kAtLeastZero}};

class WeightedTeamBall final : public TeamBallModeler {
 public:
  explicit WeightedTeamBall(robotlink::SolutionContext& context)
      : TeamBallModeler(context),
        parameters_(context.parameters<FusionFields>()),
        team_(context.input(robotlink::kTeamMessages)) {}

 private:
  TeamBallFusion::Options options() const override { return kFusionTable.read(parameters_); }

  void addReports(std::vector<BallReport>& reports) override {
    if (!team_) return;
    if (team_.isNew()) arrived_ = now();
    for (const robotcontrol::TeamMessage& message : team_->messages()) {
      if (!message.ball_known() || message.seconds_since_ball_seen() > options().memory) continue;
      BallReport report;
      report.robot = message.sender();
      report.position = robotlink::vector2(message.ball_in_field());
      report.velocity = robotlink::vector2(message.ball_velocity_in_field());
      report.covariance =
          ballCovariance(report.position, message.ball_deviation(), robotlink::pose2(message.pose_in_field()),
                         message.position_deviation(), message.heading_deviation());
      const double sent = now() - robotlink::seconds(robotlink::instant(message.timestamp()));
      report.age = std::abs(sent) < kSameClock ? std::max(0.0, sent) : now() - arrived_;
      reports.push_back(report);
    }
  }

  const FusionFields& parameters_;
  robotlink::Input<robotcontrol::TeamMessages> team_;
  double arrived_ = 0;
};

const robotlink::SolutionRegistration kWeightedBall =
    robotlink::SolutionBuilder<WeightedTeamBall>(
        "team-ball", "weighted",
        "Fuses the ball estimates of the team's robots, weighted by their certainty (covariance "
        "intersection).")
        .source(
            "S. Julier, J. Uhlmann: A non-divergent estimation algorithm in the presence of unknown "
            "correlations, 1997.")
        .needs(robotlink::kBallModel)
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kTeamMessages)
        .yields(robotlink::kTeamBall)
        .keys({&kTeamBallKey, &kReportsKey, &kTeamBallPlotKey})
        .parameters<FusionFields>(kFusionTable.rules<FusionFields>());

}  // namespace
}  // namespace modules
