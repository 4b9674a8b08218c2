// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/ManualSteering.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/steering/SteeringState.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;
using State = ManualControl::State;

namespace {

/// In the order of HeadTarget::Kind.
constexpr std::array<std::string_view, 4> kHeadModes{"look-ahead", "search-ball", "track-ball",
                                                     "look-around"};

}  // namespace

ManualSteering::ManualSteering(ViewContext& context, QObject* parent) : QObject(parent), context_(context) {}

bool ManualSteering::hasWheels() const {
  return description_ != nullptr && description_->drive.has_value();
}

const robotcontrol::MotionStatus* ManualSteering::status() const {
  return context_.session.store().latestAs<robotcontrol::MotionStatus>(
      robot_ + '/' + robotlink::kMotionStatus.name, context_.session.timeline().newest());
}

void ManualSteering::follow() {
  robotlink::Session& session = context_.session;
  const std::string& robot = session.selectedRobot();
  if (robot != robot_) {
    commander_.halt();
    if (commander_.tick(nullptr)) send();
    commander_.setActive(false);
    robot_ = robot;
    control_ = {};
    axes_ = {};
    tables_.clear();
    isStatusRequested_ = isCommanded_ = false;
  }
  // The description of a remote robot is known later than its name.
  const auto known = context_.robots.find(robot);
  description_ = known == context_.robots.end() ? nullptr : known->second;
  const auto tables =
      latestTable(session.store(), robot, robotlink::streams::kSolutions, session.timeline().newest());
  auto values = valuesOf(tables);
  if (values != tables_) {
    tables_ = std::move(values);
    control_.update(tasksOf(tables));
  }
  commander_.setActive(isTaken());
  if (isTaken() || control_.state() == State::kSwitching) return;
  commander_.halt();
  isCommanded_ = false;
}

void ManualSteering::tick() {
  follow();
  const auto steering = steeringState(context_.session, robot_);
  const bool isOthers = steering && steering->isOthers();
  // After they are gone, the robot waits for a new command of this window.
  if (isOthers) isCommanded_ = false;
  if (commander_.tick(status()) && !isOthers) send();
}

bool ManualSteering::isSteeredHere() const {
  if (isCommanded_ || !context_.session.remoteRobots().contains(robot_)) return true;
  const auto steering = steeringState(context_.session, robot_);
  return steering && steering->who == SteeringState::Who::kThisPerson;
}

void ManualSteering::send() {
  if (isLost(context_.session, robot_) || !isSteeredHere()) return;
  robotcontrol::Request request;
  *request.mutable_motion() = commander_.command();
  robotlink::assign(*request.mutable_motion()->mutable_timestamp(), context_.session.timeline().newest());
  ask(context_.session, robot_, std::move(request));
}

Result<void> ManualSteering::takeOver(bool take) {
  if (auto robot = requireRobot(); !robot) return robot;
  if (!take) {
    commander_.halt();
    if (commander_.tick(nullptr)) send();
  }
  const bool isSo = take ? isTaken() : control_.state() == State::kFree;
  const std::string solution = control_.begin(take);
  if (solution.empty() && !isSo && control_.state() != State::kSwitching)
    return failure("robot.take-over", control_.text().toStdString(), {}, {robot_});
  isCommanded_ = take;
  if (!solution.empty()) {
    robotcontrol::Request request;
    request.mutable_select_solution()->set_task(control_.task());
    request.mutable_select_solution()->set_solution(solution);
    ask(context_.session, robot_, std::move(request), this,
        [this, robot = robot_](bool accepted, const QString& reason) {
          if (accepted) return;
          if (robot == robot_) control_.refused(reason);
          context_.session.reportRefusal("manual control of " + robot, reason.toStdString());
        });
  }
  if (take) {
    claim();
    requestStatus();
  }
  return {};
}

/// A remote robot announces at once, not only after the first motion, whom it obeys. A client that already
/// steers it is left alone.
void ManualSteering::claim() {
  if (!context_.session.remoteRobots().contains(robot_) || isLost(context_.session, robot_)) return;
  const auto steering = steeringState(context_.session, robot_);
  const bool isFree = !steering || steering->who == SteeringState::Who::kNobody || steering->isSilent;
  // Objections of the robot are shown as an error of the window.
  if (isFree) static_cast<void>(context_.commands.run("robot.steer", {robot_, true}));
}

void ManualSteering::requestStatus() {
  if (isStatusRequested_ || hasWheels()) return;
  isStatusRequested_ = true;
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(std::string("package/") + robotlink::kMotionStatus.name);
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  ask(context_.session, robot_, std::move(request));
}

void ManualSteering::setAxes(const WalkAxes& axes) {
  const bool isUntouched = axes.zero() && axes_.zero();
  axes_ = axes;
  if (isUntouched) return;
  if (commander_.active()) isCommanded_ = true;
  commander_.setAxes(commander_.active() ? axes : WalkAxes{});
}

void ManualSteering::setHead(const HeadTarget& head) {
  if (commander_.active()) isCommanded_ = true;
  commander_.setHead(head);
}

void ManualSteering::releaseAxes() {
  if (axes_.zero()) return;
  setAxes({});
  if (commander_.tick(nullptr)) send();
}

Result<void> ManualSteering::requireRobot() {
  follow();
  if (!robot_.empty()) return {};
  return failure("robot.none", "there is no robot; open a scene or a log, or connect one first");
}

Result<void> ManualSteering::requireControl() {
  if (auto robot = requireRobot(); !robot) return robot;
  if (isTaken() || control_.state() == State::kSwitching) {
    isCommanded_ = true;
    return {};
  }
  return failure("robot.not-taken",
                 robot_ + " is controlled by its program; take it over first: robot.take-over on", {},
                 {robot_});
}

Result<void> ManualSteering::requireLegs(const char* what) {
  return requireControl().and_then([&]() -> Result<void> {
    if (!hasWheels()) return {};
    return failure("robot.wheels", robot_ + " has wheels, and no " + what, {}, {robot_});
  });
}

Result<void> ManualSteering::walk(const Speed& velocity) {
  return requireControl().map([&] { commander_.walk(velocity); });
}

Result<void> ManualSteering::stand() {
  return requireControl().map([&] { commander_.halt(); });
}

Result<void> ManualSteering::play(const std::string& motion) {
  return requireLegs("key-frame motions").map([&] { commander_.play(motion); });
}

Result<void> ManualSteering::setHeadMode(const std::string& mode) {
  const auto found = std::ranges::find(kHeadModes, mode);
  if (found == kHeadModes.end()) {
    return failure("robot.head", "the head's mode is look-ahead, search-ball, track-ball or look-around", {},
                   {mode});
  }
  return requireLegs("head").map([&] {
    HeadTarget head = commander_.head();
    head.kind = static_cast<HeadTarget::Kind>(found - kHeadModes.begin());
    commander_.setHead(head);
  });
}

Result<void> ManualSteering::requireJoint(const char* id, const std::string& joint, const std::string& shown,
                                          double angle) const {
  if (description_ == nullptr) return {};
  const int index = description_->jointIndex(joint);
  if (index < 0) return failure(id, robot_ + " has no joint " + shown, {}, {robot_, shown});
  const auto& limits = description_->joints[static_cast<std::size_t>(index)];
  if (angle >= limits.minimum && angle <= limits.maximum) return {};
  return failure(id,
                 QStringLiteral("%1 goes from %2 to %3 rad")
                     .arg(QString::fromStdString(shown))
                     .arg(limits.minimum, 0, 'g', 3)
                     .arg(limits.maximum, 0, 'g', 3)
                     .toStdString(),
                 {}, {shown});
}

Result<void> ManualSteering::setJoint(const std::string& joint, double angle) {
  return requireLegs("joints that can be turned")
      .and_then([&] { return requireJoint("robot.joint", joint, joint, angle); })
      .map([&] { commander_.setJoint(joint, angle); });
}

Result<void> ManualSteering::setLimp(bool limp) {
  return requireLegs("joints that can be limp").map([&] { commander_.setLimp(limp); });
}

Result<void> ManualSteering::setHeadJoint(const std::string& joint, double angle) {
  const auto found = std::ranges::find(kHeadJoints, joint, &HeadJoint::name);
  if (found == kHeadJoints.end())
    return failure("robot.head-joint", "a head has no joint " + joint, {}, {joint});
  return requireLegs("head")
      .and_then([&] { return requireJoint("robot.head-joint", found->joint, found->name, angle); })
      .map([&] {
        HeadTarget head = commander_.head();
        head.kind = HeadTarget::Kind::kAngles;
        head.*(found->angle) = angle;
        commander_.setHead(head);
      });
}

ManualSteering& manualSteering(ViewContext& context) {
  if (context.steering == nullptr) context.steering = std::make_shared<ManualSteering>(context);
  return *context.steering;
}

}  // namespace widgets
