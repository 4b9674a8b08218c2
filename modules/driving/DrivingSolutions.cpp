// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "driving" that decide where the robot goes without regard to obstacles, or leave
// that to the user.
#include <array>
#include <cmath>
#include <optional>

#include "DrivingParameters.pb.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Ranging.pb.h"
#include "modules/driving/DriveSensing.h"
#include "modules/driving/DrivingSolution.h"
#include "modules/driving/PathFollower.h"
#include "modules/driving/Wanderer.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/ParameterTable.h"

namespace modules {
namespace {

using robotlink::FieldDrawingKey;
using robotlink::Level;
using robotlink::Pose2;
using robotlink::RobotDrawingKey;
using robotlink::Vector2;

const RobotDrawingKey kDirectionKey{
    "driving/direction", "Where wandering wants to go, next to the robot (drawn around the robot)"};
const FieldDrawingKey kTargetKey{
    "driving/target",
    "The point on the path that the robot steers toward, and the state of following it (drawn on the field)"};

using robotlink::kAboveZero;
using robotlink::kAtLeastZero;

using WanderFields = robotcontrol::WanderParameters;
const robotlink::ParameterTable<Wanderer::Options> kWanderTable{
    {WanderFields::kSpeedFieldNumber, &Wanderer::Options::speed, kAtLeastZero},
    {WanderFields::kRotationFieldNumber, &Wanderer::Options::rotation, kAtLeastZero},
    {WanderFields::kRoomFieldNumber, &Wanderer::Options::room, kAtLeastZero},
    {WanderFields::kRoomAgainFieldNumber, &Wanderer::Options::roomAgain, kAtLeastZero},
    {WanderFields::kEasyRoomFieldNumber, &Wanderer::Options::easyRoom, kAboveZero},
    {WanderFields::kLikingTimeFieldNumber, &Wanderer::Options::likingTime, kAtLeastZero},
    {WanderFields::kNoveltyFieldNumber, &Wanderer::Options::novelty, kAtLeastZero},
    {WanderFields::kHalfWidthFieldNumber, &Wanderer::Options::halfWidth, kAtLeastZero}};

Wanderer::Options wanderOptions(const robotcontrol::WanderParameters& parameters) {
  Wanderer::Options options = kWanderTable.read(parameters);
  options.seed = static_cast<std::uint64_t>(std::max(0, parameters.seed())) + 1;
  return options;
}

struct FollowPathOptions : PathFollower::Options {
  /// Deviations of the pose, m: above the first the robot is lost, until it is below the second.
  double lostDeviation = 1.0, foundDeviation = 0.3;
};

using FollowFields = robotcontrol::FollowPathParameters;
const robotlink::ParameterTable<FollowPathOptions> kFollowPathTable{
    {FollowFields::kSpeedFieldNumber, &FollowPathOptions::speed, kAtLeastZero},
    {FollowFields::kRotationFieldNumber, &FollowPathOptions::rotation, kAtLeastZero},
    {FollowFields::kLookAheadFieldNumber, &FollowPathOptions::lookAhead, kAboveZero},
    {FollowFields::kBrakingFieldNumber, &FollowPathOptions::braking, kAboveZero},
    {FollowFields::kNearFieldNumber, &FollowPathOptions::near, kAboveZero},
    {FollowFields::kHeadingNearFieldNumber, &FollowPathOptions::headingNear, kAboveZero},
    {FollowFields::kTurnOnSpotFieldNumber, &FollowPathOptions::turnOnSpot, kAboveZero},
    {FollowFields::kLostDeviationFieldNumber, &FollowPathOptions::lostDeviation, kAboveZero},
    {FollowFields::kFoundDeviationFieldNumber, &FollowPathOptions::foundDeviation, kAboveZero}};

/// Steers by the sensors; stands still without readings.
class Roaming {
 public:
  Roaming(robotlink::SolutionContext& context, const Wanderer::Options& options)
      : debug_(context.debug()), sensing_(context), wanderer_(options) {}

  void update(double requested) { sensing_.update(requested); }
  DriveVelocity wander(const Wanderer::Options& options) {
    if (!sensing_.awake()) return {};
    wanderer_.setOptions(options);
    const DriveVelocity desired =
        wanderer_.decide(sensing_.points(), sensing_.robotInOdometry(), sensing_.time());
    if (debug_.on(kDirectionKey)) {
      const double direction = wanderer_.direction();
      debug_.robotDrawing(kDirectionKey)
          .arrow(Vector2(0, 0), Vector2(std::cos(direction), std::sin(direction)), robotlink::colors::kGreen,
                 2);
    }
    return desired;
  }
  const DriveSensing& sensing() const { return sensing_; }

 private:
  robotlink::DebugContext& debug_;
  DriveSensing sensing_;
  Wanderer wanderer_;
};

class Wander final : public DrivingSolution {
 public:
  explicit Wander(robotlink::SolutionContext& context)
      : DrivingSolution(context, "wander"),
        parameters_(context.parameters<robotcontrol::WanderParameters>()),
        roaming_(context, wanderOptions(parameters_)) {}

  void execute() override {
    roaming_.update(last_.forward);
    last_ = roaming_.wander(wanderOptions(parameters_));
    report_.send(roaming_.sensing().awake() ? "wander" : "no readings");
    want(last_);
  }

 private:
  const robotcontrol::WanderParameters& parameters_;
  Roaming roaming_;
  DriveVelocity last_;
};

const robotlink::SolutionRegistration kWander =
    robotlink::SolutionBuilder<Wander>(
        "driving", "wander", "Wanders, using sonars and laser, to where it has not been for a while.")
        .source("A method of this project.")
        .needs(robotlink::kDriveState)
        .uses(robotlink::kSonar)
        .uses(robotlink::kLaser)
        .yields(robotlink::kBehaviorDrive)
        .yields(robotlink::kBehaviorState)
        .keys({&kDrivingSpeedKey, &kDrivingArcKey, &kDirectionKey})
        .parameters<robotcontrol::WanderParameters>(kWanderTable.rules<robotcontrol::WanderParameters>());

class FollowPath final : public DrivingSolution {
 public:
  explicit FollowPath(robotlink::SolutionContext& context)
      : DrivingSolution(context, "follow-path"),
        parameters_(context.parameters<robotcontrol::FollowPathParameters>()),
        path_(context.input(robotlink::kDrivePath)),
        pose_(context.input(robotlink::kRobotPose)),
        roaming_(context, {}),
        follower_({}) {}

  void execute() override {
    roaming_.update(last_.forward);
    last_ = decide();
    report_.send(state_, said_);
    want(last_);
  }

 private:
  DriveVelocity decide() {
    if (!path_ || !path_->has_goal() || path_->goal().cancelled()) return stand("idle", "nothing to do");
    if (isLost()) {
      if (parameters_.wait_when_lost()) return stand("lost", "not localized: waits");
      state_ = "wander";
      say("not localized: wanders until it is");
      follower_.decide({}, {}, {});
      return roaming_.wander({});
    }
    if (path_->blocked()) return stand("blocked", "no way: " + path_->reason());
    return follow();
  }

  bool isLost() {
    if (!pose_) return true;
    const FollowPathOptions options = kFollowPathTable.read(parameters_);
    lost_ = !(pose_->position_deviation() < (lost_ ? options.foundDeviation : options.lostDeviation));
    return lost_;
  }

  /// If another process computed the pose, it is slightly old.
  Pose2 robotNow() const {
    const Pose2 robot = robotlink::pose2(pose_->robot_in_field());
    const OdometryHistory& odometry = roaming_.sensing().odometry();
    const auto then = odometry.at(robotlink::instant(pose_->timestamp())), now = odometry.latest();
    return then && now ? robot * (then->inverse() * *now) : robot;
  }

  DriveVelocity follow() {
    follower_.setOptions(kFollowPathTable.read(parameters_));
    std::vector<Vector2> points;
    for (const auto& point : path_->points_in_field()) points.push_back(robotlink::vector2(point));
    const robotcontrol::DriveGoal& goal = path_->goal();
    const auto heading = goal.any_heading() ? std::optional<double>() : goal.pose_in_field().heading();
    const DriveVelocity desired = follower_.decide(robotNow(), points, heading);
    using State = PathFollower::State;
    const std::string to = goal.name().empty() ? "the goal" : "“" + goal.name() + "”";
    static constexpr std::array kStates{"no path", "drive", "turn", "there"};
    state_ = kStates[static_cast<std::size_t>(follower_.state())];
    if (follower_.state() == State::kDriving) say("drives to " + to);
    if (follower_.state() == State::kThere) say("is at " + to);
    if (debug_.on(kTargetKey)) {
      auto drawing = debug_.fieldDrawing(kTargetKey);
      drawing.line(robotNow().translation(), follower_.target(), robotlink::colors::kOrange);
      drawing.dot(follower_.target(), robotlink::colors::kRed, 0.1);
      drawing.text(robotNow().translation(), said_, robotlink::colors::kBlack);
    }
    return desired;
  }

  DriveVelocity stand(const char* state, const std::string& why) {
    state_ = state;
    say(why);
    follower_.decide({}, {}, {});
    return {};
  }

  void say(const std::string& what) {
    if (what == said_) return;
    said_ = what;
    debug_.text(Level::kInfo, "driving", what);
  }

  const robotcontrol::FollowPathParameters& parameters_;
  robotlink::Input<robotcontrol::DrivePath> path_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  Roaming roaming_;
  PathFollower follower_;
  DriveVelocity last_;
  bool lost_ = true;
  std::string said_;
  std::string state_;
};

const robotlink::SolutionRegistration kFollowPath =
    robotlink::SolutionBuilder<FollowPath>(
        "driving", "follow-path",
        "Follows the path to the goal that the user set; wanders while it is not localized.")
        .source("R. C. Coulter: Implementation of the pure pursuit path tracking algorithm, 1992.")
        .needs(robotlink::kDrivePath)
        .needs(robotlink::kRobotPose)
        .needs(robotlink::kDriveState)
        .uses(robotlink::kSonar)
        .uses(robotlink::kLaser)
        .yields(robotlink::kBehaviorDrive)
        .yields(robotlink::kBehaviorState)
        .keys({&kDrivingSpeedKey, &kDrivingArcKey, &kDirectionKey, &kTargetKey})
        .parameters<robotcontrol::FollowPathParameters>(
            kFollowPathTable.rules<robotcontrol::FollowPathParameters>());

class ObeyOnWheels final : public DrivingSolution {
 public:
  explicit ObeyOnWheels(robotlink::SolutionContext& context)
      : DrivingSolution(context, "obey"), remote_(context.input(robotlink::kRemoteMotion)) {}

  void execute() override {
    DriveVelocity desired;
    if (remote_ && remote_.isNew()) heard_ = clock_.now();
    const bool fresh = remote_ && clock_.now() - heard_ <= kPatience;
    if (fresh && remote_->motion().kind() == robotcontrol::MotionRequest::WALK)
      desired = {remote_->motion().walk().x(), remote_->motion().walk().rotation()};
    report_.send(desired == DriveVelocity{} ? "stand" : "obey");
    want(desired);
  }

 private:
  /// While the user steers, the request is repeated ten times a second. If it stops, the window hangs or the
  /// connection is lost.
  static constexpr robotlink::Duration kPatience = std::chrono::seconds(2);

  robotlink::Input<robotcontrol::RemoteMotion> remote_;
  robotlink::Instant heard_;
};

const robotlink::SolutionRegistration kObey =
    robotlink::SolutionBuilder<ObeyOnWheels>(
        "driving", "obey", "Drives as the user requests; stays stopped before, and when requests stop.")
        .source("A method of this project.")
        .uses(robotlink::kRemoteMotion)
        .yields(robotlink::kBehaviorDrive)
        .yields(robotlink::kBehaviorState)
        .keys({&kDrivingSpeedKey, &kDrivingArcKey});

class Halt final : public DrivingSolution {
 public:
  explicit Halt(robotlink::SolutionContext& context) : DrivingSolution(context, "halt") {}
  void execute() override {
    report_.send("halt");
    want({});
  }
};

const robotlink::SolutionRegistration kHalt =
    robotlink::SolutionBuilder<Halt>("driving", "halt", "Stays stopped, regardless of the user's requests.")
        .source("A method of this project.")
        .yields(robotlink::kBehaviorDrive)
        .yields(robotlink::kBehaviorState)
        .keys({&kDrivingSpeedKey, &kDrivingArcKey});

}  // namespace
}  // namespace modules
