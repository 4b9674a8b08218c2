// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "ball-model": the position of the ball, whether it is visible or not.
#include <optional>

#include "ModelingParameters.pb.h"
#include "modules/modeling/BallFilter.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::PlotKey;
using robotlink::Pose2;
using robotlink::RobotDrawingKey;

const RobotDrawingKey kBallKey{
    "ball-model/ball",
    "The ball's estimated position, its certainty, and where it rolls (drawn around the robot)"};
const PlotKey kPositionKey{"ball-model/position",
                           "Place of the ball in the robot's frame, and its deviation"};
const PlotKey kAgeKey{"ball-model/age", "Seconds since the ball was seen"};

/// Sends an estimate, and draws and plots it.
class BallModeler : public robotlink::Solution {
 public:
  explicit BallModeler(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        ballRadius_(context.robot().field->ballRadius),
        model_(context.output(robotlink::kBallModel)) {}

 protected:
  void publish(const BallEstimate& ball, const google::protobuf::Timestamp& time) {
    auto package = std::make_shared<robotcontrol::BallModel>();
    *package->mutable_timestamp() = time;
    package->set_known(ball.known);
    robotlink::assign(*package->mutable_position_in_robot(), ball.position);
    robotlink::assign(*package->mutable_velocity_in_robot(), ball.velocity);
    package->set_seconds_since_seen(ball.secondsSinceSeen);
    package->set_standard_deviation(ball.deviation);
    draw(ball);
    model_.send(std::move(package));
  }

 private:
  void draw(const BallEstimate& ball) {
    if (debug_.on(kAgeKey)) debug_.plot(kAgeKey, ball.secondsSinceSeen, "s");
    if (!ball.known) return;
    if (debug_.on(kBallKey)) {
      auto drawing = debug_.robotDrawing(kBallKey);
      drawing.circle(ball.position, ballRadius_, robotlink::colors::kOrange, 2);
      drawing.circle(ball.position, ballRadius_ + ball.deviation, robotlink::colors::kGray);
      if (ball.velocity.norm() > 0.02)
        drawing.arrow(ball.position, ball.position + ball.velocity, robotlink::colors::kOrange);
    }
    if (debug_.on(kPositionKey)) {
      debug_.plot(kPositionKey, "x", ball.position.x(), "m");
      debug_.plot(kPositionKey, "y", ball.position.y(), "m");
      debug_.plot(kPositionKey, "deviation", ball.deviation, "m");
    }
  }

  robotlink::DebugContext& debug_;
  double ballRadius_;
  robotlink::Output<robotcontrol::BallModel> model_;
};

LastBall::Options optionsOf(const robotcontrol::LastPerceptBallParameters& p) {
  return {p.memory()};
}

BallFilter::Options optionsOf(const robotcontrol::FilteredBallParameters& p) {
  return {p.memory(), p.friction(),           p.acceleration(), p.deviation_near(), p.deviation_per_metre(),
          p.gate(),   p.outliers_to_restart()};
}

/// The common part of the two solutions based on percepts; `Estimator` is LastBall or BallFilter.
template <typename Estimator, typename Parameters>
class PerceptBallModeler final : public BallModeler {
 public:
  explicit PerceptBallModeler(robotlink::SolutionContext& context)
      : BallModeler(context),
        parameters_(context.parameters<Parameters>()),
        percept_(context.input(robotlink::kBallPercept)),
        motion_(context.input(robotlink::kMotionStatus)),
        estimator_(optionsOf(parameters_)) {}

  void execute() override {
    if (!percept_ || !percept_.isNew()) return;
    std::optional<BallMeasurement> seen;
    if (percept_->seen() && percept_->confidence() >= parameters_.minimum_confidence())
      seen = BallMeasurement{robotlink::vector2(percept_->position_in_robot()), percept_->confidence()};
    const Pose2 odometry = motion_ ? robotlink::pose2(motion_->odometry()) : Pose2{};
    estimator_.setOptions(optionsOf(parameters_));
    estimator_.update(robotlink::seconds(robotlink::instant(percept_->timestamp())), odometry, seen);
    publish(estimator_.estimate(), percept_->timestamp());
  }

 private:
  const Parameters& parameters_;
  robotlink::Input<robotcontrol::BallPercept> percept_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  Estimator estimator_;
};

using LastPerceptBall = PerceptBallModeler<LastBall, robotcontrol::LastPerceptBallParameters>;

const robotlink::SolutionRegistration kLastPercept =
    robotlink::SolutionBuilder<LastPerceptBall>(
        "ball-model", "last-percept",
        "The ball stays where it was seen last, while the robot moves by dead reckoning.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kPositionKey, &kAgeKey})
        .parameters<robotcontrol::LastPerceptBallParameters>();

using FilteredBall = PerceptBallModeler<BallFilter, robotcontrol::FilteredBallParameters>;

const robotlink::SolutionRegistration kFiltered =
    robotlink::SolutionBuilder<FilteredBall>(
        "ball-model", "filtered",
        "A Kalman filter over place and velocity of the ball in the frame of dead reckoning.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kPositionKey, &kAgeKey})
        .parameters<robotcontrol::FilteredBallParameters>();

class OracleBall final : public BallModeler {
 public:
  explicit OracleBall(robotlink::SolutionContext& context)
      : BallModeler(context), world_(context.input(robotlink::kOracleWorld)) {}

  void execute() override {
    if (!world_ || !world_.isNew()) return;
    const robotlink::Vector3 ball = robotlink::vector3(world_->ball_in_field());
    BallEstimate estimate;
    estimate.known = true;
    estimate.position =
        robotlink::pose2(world_->robot_in_field()).inverse() * robotlink::Vector2(ball.head<2>());
    publish(estimate, world_->timestamp());
  }

 private:
  robotlink::Input<robotcontrol::OracleWorld> world_;
};

const robotlink::SolutionRegistration kOracleBall =
    robotlink::SolutionBuilder<OracleBall>("ball-model", "oracle",
                                           "The ball's true place, from the simulator.")
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kPositionKey, &kAgeKey});

}  // namespace
}  // namespace modules
