// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "behavior": what the robot does, as requests to motion and head.
#include <algorithm>

#include "BehaviorParameters.pb.h"
#include "modules/BehaviorReport.h"
#include "modules/behavior/BallChaser.h"
#include "modules/behavior/BehaviorRequests.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotcontrol::HeadMode;
using robotcontrol::MotionRequest;
using robotlink::RobotDrawingKey;
using robotlink::Vector2;

const RobotDrawingKey kStateKey{"behavior/state",
                                "The state of the behavior, next to the robot (drawn around the robot)"};
const RobotDrawingKey kTargetKey{
    "behavior/target",
    "Where the robot wants to be, the ball and the goal it plays toward (drawn around the robot)"};

/// Sends the requests for body and head, and the state that they follow from.
class Behavior : public robotlink::Solution {
 public:
  Behavior(robotlink::SolutionContext& context, const char* solution)
      : report_(context, solution), debug_(context.debug()), clock_(context.clock()), requests_(context) {}

 protected:
  BehaviorReport report_;
  robotlink::DebugContext& debug_;
  const robotlink::Clock& clock_;
  BehaviorRequests requests_;
};

class GoToBallAndKick final : public Behavior {
 public:
  explicit GoToBallAndKick(robotlink::SolutionContext& context)
      : Behavior(context, "go-to-ball-and-kick"),
        parameters_(context.parameters<robotcontrol::GoToBallParameters>()),
        goalInField_(opponentGoal(context.robot())),
        ball_(context.input(robotlink::kBallModel)),
        pose_(context.input(robotlink::kRobotPose)),
        regions_(context.input(robotlink::kColorRegions)),
        status_(context.input(robotlink::kMotionStatus)),
        chaser_({}) {}

  void execute() override {
    chaser_.setOptions(options());
    const Situation now = situation();
    Intention intention = chaser_.decide(now);
    if (chaser_.changed())
      debug_.text(robotlink::Level::kInfo, "behavior",
                  std::string(name(chaser_.state())) + ": " + chaser_.reason());
    report_.send(name(chaser_.state()), chaser_.reason());
    draw(now);
    if (intention.motion == Intention::Motion::kKick) intention.kick = parameters_.kick();
    requests_.send(intention);
  }

 private:
  static Vector2 opponentGoal(const robotlink::RobotSetup& robot) {
    const double direction = robot.field->playingDirection(robot.team);
    for (const auto& goal : robot.field->goals)
      if (goal.x * direction > 0) return {goal.x, 0};
    return {direction * 0.5 * robot.field->length, 0};
  }

  BallChaser::Options options() const {
    const robotcontrol::GoToBallParameters& p = parameters_;
    BallChaser::Options options;
    options.forwardSpeed = p.forward_speed();
    options.sidewardSpeed = p.sideward_speed();
    options.turnSpeed = p.turn_speed();
    options.lookAboutTime = p.look_about_time();
    options.turnTime = p.turn_time();
    options.wanderTime = p.wander_time();
    options.wanderSpeed = p.wander_speed();
    options.blindAfter = p.blind_after();
    options.lostAfter = p.lost_after();
    options.glanceTime = p.glance_time();
    options.glanceAgain = p.glance_again();
    options.alignDistance = p.align_distance();
    options.alignTolerance = p.align_tolerance();
    options.alignTime = p.align_time();
    options.kickX = p.kick_x();
    options.kickY = p.kick_y();
    options.kickToleranceX = p.kick_tolerance_x();
    options.kickToleranceY = p.kick_tolerance_y();
    options.positionTime = p.position_time();
    options.kickTimeout = p.kick_timeout();
    return options;
  }

  Situation situation() const {
    Situation now;
    now.time = robotlink::seconds(clock_.now());
    if (ball_ && ball_->known()) {
      now.ballKnown = true;
      now.ball = robotlink::vector2(ball_->position_in_robot());
      // The age in the model is that at its last frame.
      now.ballAge = ball_->seconds_since_seen() +
                    std::max(0.0, now.time - robotlink::seconds(robotlink::instant(ball_->timestamp())));
    }
    if (pose_ && pose_->position_deviation() <= parameters_.goal_position_deviation() &&
        pose_->heading_deviation() <= parameters_.goal_heading_deviation())
      now.goal = robotlink::pose2(pose_->robot_in_field()).inverse() * goalInField_;
    now.fieldSeen = seesField();
    if (status_) {
      now.fallen = status_->fallen();
      now.stable = status_->stable();
      now.kicking = status_->executed().kind() == MotionRequest::KEY_FRAMES;
    }
    return now;
  }

  /// A blind camera shows no color at all. In front of a wall or in a goal there is no green, but white or
  /// the goal's color.
  bool seesField() const {
    // Without regions, only the ball model knows.
    if (!regions_) return ball_ && ball_->known();
    double colored = 0;
    for (const robotcontrol::ColorRegion& region : regions_->regions()) colored += region.area();
    return colored > parameters_.minimum_colored() * regions_->width() * regions_->height();
  }

  void draw(const Situation& now) {
    if (debug_.on(kStateKey))
      debug_.robotDrawing(kStateKey).text(Vector2(-0.2, 0.2), name(chaser_.state()),
                                          robotlink::colors::kBlack);
    if (!debug_.on(kTargetKey)) return;
    auto drawing = debug_.robotDrawing(kTargetKey);
    if (now.ballKnown) drawing.line(Vector2(0, 0), now.ball, robotlink::colors::kOrange);
    if (now.ballKnown && now.goal) drawing.arrow(now.ball, *now.goal, robotlink::colors::kYellow);
    if (chaser_.target()) drawing.dot(*chaser_.target(), robotlink::colors::kRed);
  }

  const robotcontrol::GoToBallParameters& parameters_;
  Vector2 goalInField_;
  robotlink::Input<robotcontrol::BallModel> ball_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Input<robotcontrol::ColorRegions> regions_;
  robotlink::Input<robotcontrol::MotionStatus> status_;
  BallChaser chaser_;
};

const robotlink::SolutionRegistration kGoToBallAndKick =
    robotlink::SolutionBuilder<GoToBallAndKick>("behavior", "go-to-ball-and-kick",
                                                "Looks for the ball, walks to it, gets behind it as seen "
                                                "from the goal, if that is known, and kicks it.")
        .source("A method of this project.")
        .needs(robotlink::kBallModel)
        .uses(robotlink::kRobotPose)
        .uses(robotlink::kColorRegions)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kMotionRequest)
        .yields(robotlink::kHeadMode)
        .yields(robotlink::kBehaviorState)
        .keys({&kStateKey, &kTargetKey, &kBehaviorSpeedKey, &kBehaviorWalkKey})
        .parameters<robotcontrol::GoToBallParameters>();

class Stand final : public Behavior {
 public:
  explicit Stand(robotlink::SolutionContext& context) : Behavior(context, "stand") {}

  void execute() override {
    report_.send("stand");
    auto head = std::make_shared<HeadMode>();
    head->set_kind(HeadMode::LOOK_AHEAD);
    requests_.send(std::make_shared<MotionRequest>(), std::move(head));
  }
};

const robotlink::SolutionRegistration kStand =
    robotlink::SolutionBuilder<Stand>("behavior", "stand", "Stands and looks ahead.")
        .source("A method of this project.")
        .yields(robotlink::kMotionRequest)
        .yields(robotlink::kHeadMode)
        .yields(robotlink::kBehaviorState)
        .keys({&kBehaviorSpeedKey, &kBehaviorWalkKey});

class Obey final : public Behavior {
 public:
  explicit Obey(robotlink::SolutionContext& context)
      : Behavior(context, "obey"), remote_(context.input(robotlink::kRemoteMotion)) {}

  void execute() override {
    auto motion = std::make_shared<MotionRequest>();
    auto head = std::make_shared<HeadMode>();
    if (remote_) {
      if (remote_.isNew()) heard_ = clock_.now();
      *head = remote_->head();
      if (holds(remote_->motion())) *motion = remote_->motion();
    }
    report_.send(motion->kind() == MotionRequest::STAND ? "stand" : "obey");
    requests_.send(std::move(motion), std::move(head));
  }

 private:
  /// Requests are repeated, as on wheels, ten times a second while the user steers. If this stops, the window
  /// hangs or the connection is lost. It is platform time, which may be ten times as fast.
  static constexpr robotlink::Duration kObeyPatience = std::chrono::seconds(2);

  /// A walk continues until it is ended; whatever else is requested ends by itself.
  bool holds(const MotionRequest& motion) const {
    return motion.kind() != MotionRequest::WALK || clock_.now() - heard_ <= kObeyPatience;
  }

  robotlink::Input<robotcontrol::RemoteMotion> remote_;
  robotlink::Instant heard_;
};

const robotlink::SolutionRegistration kObey =
    robotlink::SolutionBuilder<Obey>(
        "behavior", "obey", "Does only what the user requests; stands still before, and when requests stop.")
        .source("A method of this project.")
        .uses(robotlink::kRemoteMotion)
        .yields(robotlink::kMotionRequest)
        .yields(robotlink::kHeadMode)
        .yields(robotlink::kBehaviorState)
        .keys({&kBehaviorSpeedKey, &kBehaviorWalkKey});

}  // namespace
}  // namespace modules
