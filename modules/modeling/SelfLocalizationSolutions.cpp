// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "self-localisation" on a field: the robot's pose.
#include <algorithm>
#include <cmath>

#include "ModelingParameters.pb.h"
#include "modules/modeling/LandmarkLocalizer.h"
#include "modules/modeling/SelfLocalization.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"

namespace modules {
namespace {

using robotlink::Pose2;

/// Start poses are those of a team that plays toward +x; for the other one the field is rotated by half a
/// turn.
Pose2 startPose(const robotcontrol::Pose2& start, const robotlink::RobotSetup& robot) {
  const Pose2 pose = robotlink::pose2(start);
  return robot.field && robot.field->playingDirection(robot.team) < 0 ? Pose2{0, 0, robotlink::kPi} * pose
                                                                      : pose;
}

class OdometryLocalization final : public SelfLocalization {
 public:
  explicit OdometryLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context),
        parameters_(context.parameters<robotcontrol::OdometryLocalisationParameters>()),
        robot_(context.robot()),
        motion_(context.input(robotlink::kMotionStatus)) {}

  void execute() override {
    if (!motion_ || !motion_.isNew()) return;
    const Pose2 now = robotlink::pose2(motion_->odometry());
    const Pose2 step = last_.inverse() * now;
    last_ = now;
    way_ += std::hypot(step.x, step.y);
    turn_ += std::abs(step.heading);
    PoseEstimate estimate;
    estimate.robotInField = startPose(parameters_.start(), robot_) * now;
    estimate.headingDeviation = parameters_.drift_per_radian() * turn_;
    estimate.positionDeviation =
        parameters_.drift_per_metre() * way_ + 0.5 * way_ * estimate.headingDeviation;
    publish(estimate, motion_->timestamp());
  }

 private:
  const robotcontrol::OdometryLocalisationParameters& parameters_;
  const robotlink::RobotSetup& robot_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  Pose2 last_;
  double way_ = 0, turn_ = 0;
};

const robotlink::SolutionRegistration kOdometry =
    robotlink::SolutionBuilder<OdometryLocalization>(
        "self-localisation", "odometry", "Dead reckoning from a known start; its error only grows.")
        .source("Dead reckoning: S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics, 2005, chapter 5.")
        .needs(robotlink::kMotionStatus)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey})
        .parameters<robotcontrol::OdometryLocalisationParameters>();

class LandmarkLocalization final : public SelfLocalization {
 public:
  explicit LandmarkLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context),
        field_(context.robot().field),
        percepts_(context.input(robotlink::kLandmarkPercepts)),
        motion_(context.input(robotlink::kMotionStatus)),
        parameters_(context.parameters<robotcontrol::LandmarkLocalisationParameters>()),
        localizer_(options(), startPose(parameters_.start(), context.robot()),
                   parameters_.start_deviation()) {}

  void execute() override {
    if (!percepts_ || !percepts_.isNew()) return;
    seen_.clear();
    for (const robotcontrol::LandmarkPercept& percept : percepts_->landmarks()) addMeasurement(percept);
    localizer_.setOptions(options());
    const auto executed = motion_ ? motion_->executed().kind() : robotcontrol::MotionRequest::STAND;
    const bool shaken = executed == robotcontrol::MotionRequest::KEY_FRAMES ||
                        executed == robotcontrol::MotionRequest::GET_UP;
    localizer_.update(motion_ ? robotlink::pose2(motion_->odometry()) : Pose2{}, shaken, seen_);
    publish(localizer_.estimate(), percepts_->timestamp());
    if (debug_.on(kLocatorParticlesKey)) {
      auto drawing = debug_.fieldDrawing(kLocatorParticlesKey);
      for (const Pose2& particle : localizer_.particles())
        drawing.dart(particle, robotlink::colors::kBlue, 0.08);
    }
  }

 private:
  LandmarkLocalizer::Options options() const {
    LandmarkLocalizer::Options options;
    options.particles = parameters_.particles();
    options.fieldLength = field_->length;
    options.fieldWidth = field_->width;
    options.bearingDeviation = parameters_.bearing_deviation();
    options.distanceDeviation = parameters_.distance_deviation();
    options.walkNoise = parameters_.walk_noise();
    options.turnNoise = parameters_.turn_noise();
    options.driftNoise = parameters_.drift_noise();
    options.newShare = parameters_.new_share();
    options.roughening = parameters_.roughening();
    options.evidence = parameters_.evidence();
    return options;
  }

  void addMeasurement(const robotcontrol::LandmarkPercept& percept) {
    LandmarkMeasurement seen{robotlink::Vector2::Zero(), percept.bearing(), percept.distance(),
                             percept.confidence(), percept.kind() == robotcontrol::LandmarkPercept::GOAL};
    const auto beacon =
        std::ranges::find(field_->beacons, percept.name(), &robotlink::FieldDescription::Beacon::name);
    const auto goal =
        std::ranges::find(field_->goals, percept.name(), &robotlink::FieldDescription::Goal::name);
    if (!seen.isGoal && beacon != field_->beacons.end())
      seen.position = beacon->position;
    else if (seen.isGoal && goal != field_->goals.end())
      seen.position = {goal->x + std::copysign(0.5 * field_->goalDepth, goal->x), 0};
    else
      return;
    seen_.push_back(seen);
  }

  std::shared_ptr<const robotlink::FieldDescription> field_;
  robotlink::Input<robotcontrol::LandmarkPercepts> percepts_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  const robotcontrol::LandmarkLocalisationParameters& parameters_;
  LandmarkLocalizer localizer_;
  std::vector<LandmarkMeasurement> seen_;
};

const robotlink::SolutionRegistration kLandmarks =
    robotlink::SolutionBuilder<LandmarkLocalization>(
        "self-localisation", "landmarks",
        "A particle filter over dead reckoning and the bearings and distances of beacons and goals.")
        .source(
            "F. Dellaert, D. Fox, W. Burgard, S. Thrun: Monte Carlo localization for mobile robots, 1999.")
        .needs(robotlink::kLandmarkPercepts)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorParticlesKey, &kLocatorPlotKey})
        .parameters<robotcontrol::LandmarkLocalisationParameters>();

class OracleLocalization final : public SelfLocalization {
 public:
  explicit OracleLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context), world_(context.input(robotlink::kOracleWorld)) {}

  void execute() override {
    if (!world_ || !world_.isNew()) return;
    publish({robotlink::pose2(world_->robot_in_field()), 0, 0}, world_->timestamp());
  }

 private:
  robotlink::Input<robotcontrol::OracleWorld> world_;
};

const robotlink::SolutionRegistration kOracleLocator =
    robotlink::SolutionBuilder<OracleLocalization>("self-localisation", "oracle",
                                                   "The robot's true pose, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey});

}  // namespace
}  // namespace modules
