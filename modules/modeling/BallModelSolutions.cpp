// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "ball-model": the position of the ball, whether it is visible or not.
#include "ModelingParameters.pb.h"
#include "modules/modeling/BallFilter.h"
#include "modules/modeling/BallModeler.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::Pose2;

LastBall::Options optionsOf(const robotcontrol::LastPerceptBallParameters& p) {
  return {p.memory()};
}

BallFilter::Options optionsOf(const robotcontrol::FilteredBallParameters& p) {
  return {p.memory(), p.friction(),           p.acceleration(), p.deviation_near(), p.deviation_per_metre(),
          p.gate(),   p.outliers_to_restart()};
}

/// A percept modeler whose parameters are all set in their file.
template <typename Estimator, typename Parameters>
class PlainBallModeler final : public PerceptBallModeler<Estimator> {
 public:
  explicit PlainBallModeler(robotlink::SolutionContext& context)
      : PerceptBallModeler<Estimator>(context, optionsOf(context.parameters<Parameters>())),
        parameters_(context.parameters<Parameters>()) {}

 private:
  typename Estimator::Options options() const override { return optionsOf(parameters_); }
  double minimumConfidence() const override { return parameters_.minimum_confidence(); }

  const Parameters& parameters_;
};

using LastPerceptBall = PlainBallModeler<LastBall, robotcontrol::LastPerceptBallParameters>;

const robotlink::SolutionRegistration kLastPercept =
    robotlink::SolutionBuilder<LastPerceptBall>(
        "ball-model", "last-percept",
        "The ball stays where it was seen last, while the robot moves by dead reckoning.")
        .source("A method of this project.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kBallPositionKey, &kBallAgeKey})
        .parameters<robotcontrol::LastPerceptBallParameters>();

using FilteredBall = PlainBallModeler<BallFilter, robotcontrol::FilteredBallParameters>;

const robotlink::SolutionRegistration kFiltered =
    robotlink::SolutionBuilder<FilteredBall>(
        "ball-model", "filtered",
        "A Kalman filter over position and velocity of the ball in the frame of dead reckoning.")
        .source("R. E. Kalman: A new approach to linear filtering and prediction problems, 1960.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kBallPositionKey, &kBallAgeKey})
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
                                           "The ball's true position, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kBallPositionKey, &kBallAgeKey});

}  // namespace
}  // namespace modules
