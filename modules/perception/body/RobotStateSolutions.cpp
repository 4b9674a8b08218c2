// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "robot-state": whether the robot was picked up, has fallen, or touches something.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <string>
#include <utility>

#include "PerceptionParameters.pb.h"
#include "foxglove/Robot.pb.h"
#include "modules/motion/JointLayout.h"
#include "modules/perception/body/BodyEvents.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {
namespace {

using robotcontrol::RobotState;
using robotlink::kAboveZero;
using robotlink::kAtLeastZero;

const robotlink::RobotDrawingKey kLegStatesKey{
    "robot-state/legs",
    "The paws, red where a leg has collided, and whether the robot lies or hangs (drawn around the robot)"};
const robotlink::PlotKey kEventsKey{
    "robot-state/events", "Whether the robot was picked up, has fallen, and how many legs collided"};
const robotlink::PlotKey kContactsKey{"robot-state/contacts", "The contacts of the paws, 1 on the ground"};
const robotlink::PlotKey kLoadKey{
    "robot-state/load",
    "The torque with which the knees support the body, and the legs' errors in standard deviations"};

constexpr std::array<const char*, 4> kLegNames{"front left", "front right", "hind left", "hind right"};
/// Slower walks do not count, because their steps are too small, m/s and rad/s.
constexpr double kMinSpeed = 0.02, kMinRotation = 0.1;
/// A later frame counts as long as this, s.
constexpr double kLongestFrame = 0.1;

constexpr std::array<std::pair<FallDetector::Side, RobotState::Side>, 6> kSides{
    {{FallDetector::Side::kNone, RobotState::UPRIGHT},
     {FallDetector::Side::kFront, RobotState::ON_NOSE},
     {FallDetector::Side::kRear, RobotState::ON_TAIL},
     {FallDetector::Side::kBack, RobotState::ON_BACK},
     {FallDetector::Side::kLeft, RobotState::ON_LEFT},
     {FallDetector::Side::kRight, RobotState::ON_RIGHT}}};

RobotState::Side sideOf(FallDetector::Side side) {
  return std::ranges::find(kSides, side, [](const auto& pair) { return pair.first; })->second;
}

/// The side that a package says; none if it is not known here.
FallDetector::Side sideOf(RobotState::Side side) {
  const auto found = std::ranges::find(kSides, side, [](const auto& pair) { return pair.second; });
  return found == kSides.end() ? FallDetector::Side::kNone : found->first;
}

/// The common part of all solutions: what the detectors look at, the package, and drawings.
class RobotStateEstimator : public robotlink::Solution {
 public:
  explicit RobotStateEstimator(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        body_(context.input(robotlink::kBodySensors)),
        joints_(context.input(robotlink::kJointStates)),
        motion_(context.input(robotlink::kMotionStatus)),
        layout_(layoutOf(context.robot().description)),
        state_(context.output(robotlink::kRobotState)) {}

  void execute() override {
    if (!body_ || !joints_ || !body_.isNew()) return;
    const double now = robotlink::seconds(robotlink::instant(body_->timestamp()));
    const double passed = std::isfinite(last_) ? std::min(now - last_, kLongestFrame) : 0;
    last_ = now;
    if (passed <= 0) return;
    BodyFrame frame = sensed();
    frame.time = robotlink::fromSeconds(passed);
    const BodyEvents& events = detect(frame);
    const bool changed =
        events.pickedUp != package_.picked_up() || events.fallen != package_.fallen() || !began_;
    began_ = true;
    package_.set_seconds(changed ? 0 : package_.seconds() + passed);
    send(events);
    draw(frame, events);
  }

 protected:
  virtual const BodyEvents& detect(BodyFrame& frame) = 0;
  /// The angles of all legs in a list of positions in the order of the robot's description.
  std::array<LegAngles, 4> legsOf(const std::vector<double>& positions) const {
    std::array<LegAngles, 4> legs;
    for (const Leg leg : kLegs) legs[index(leg)] = layout_.leg(positions, leg);
    return legs;
  }
  const JointLayout& layout() const { return layout_; }

  robotlink::DebugContext& debug_;

 private:
  static JointLayout layoutOf(const robotlink::RobotDescription& description) {
    auto layout = JointLayout::of(description.joints);
    if (!layout) throw std::runtime_error(layout.error().describe());
    return *std::move(layout);
  }

  BodyFrame sensed() {
    BodyFrame frame;
    frame.acceleration = robotlink::vector3(body_->acceleration());
    for (int i = 0; i < body_->paw_contacts_size() && i < 4; ++i)
      frame.contacts[static_cast<std::size_t>(i)] = body_->paw_contacts(i);
    positions_.assign(layout_.size(), 0);
    for (int i = 0; i < joints_->joints_size() && i < static_cast<int>(layout_.size()); ++i)
      positions_[static_cast<std::size_t>(i)] = joints_->joints(i).position();
    frame.measured = frame.requested = legsOf(positions_);
    efforts_.assign(layout_.size(), 0);
    for (int i = 0; i < joints_->joints_size() && i < static_cast<int>(layout_.size()); ++i)
      efforts_[static_cast<std::size_t>(i)] = joints_->joints(i).effort();
    const std::array<LegAngles, 4> torques = legsOf(efforts_);
    for (const Leg leg : kLegs) frame.kneeTorques[index(leg)] = torques[index(leg)].knee;
    if (!motion_) return frame;
    const auto kind = motion_->executed().kind();
    const auto& speed = motion_->velocity();
    frame.walking =
        kind == robotcontrol::MotionRequest::WALK &&
        (std::hypot(speed.x(), speed.y()) > kMinSpeed || std::abs(speed.rotation()) > kMinRotation);
    frame.shaken = kind != robotcontrol::MotionRequest::WALK && kind != robotcontrol::MotionRequest::STAND;
    return frame;
  }

  void send(const BodyEvents& events) {
    *package_.mutable_timestamp() = body_->timestamp();
    package_.set_picked_up(events.pickedUp);
    package_.set_fallen(events.fallen);
    package_.set_side(events.fallen ? sideOf(events.side) : RobotState::UPRIGHT);
    package_.clear_collisions();
    for (const Leg leg : kLegs)
      if (events.collided[index(leg)]) package_.add_collisions(kLegNames[index(leg)]);
    state_.send(std::make_shared<RobotState>(package_));
  }

  void draw(const BodyFrame& frame, const BodyEvents& events) {
    if (debug_.on(kEventsKey)) {
      debug_.plot(kEventsKey, "picked-up", events.pickedUp ? 1 : 0);
      debug_.plot(kEventsKey, "fallen", events.fallen ? 1 : 0);
      debug_.plot(kEventsKey, "collisions", package_.collisions_size());
    }
    if (!debug_.on(kLegStatesKey)) return;
    auto drawing = debug_.robotDrawing(kLegStatesKey);
    for (const Leg leg : kLegs) {
      const robotlink::Vector3 paw =
          kinematics_.hipInBody(leg) + kinematics_.pawInHip(leg, frame.measured[index(leg)]);
      const bool collided = events.collided[index(leg)];
      drawing.circle(paw.head<2>(), 0.02, collided ? robotlink::colors::kRed : robotlink::colors::kGray, 2);
    }
    const char* text = events.fallen ? "fallen" : events.pickedUp ? "picked up" : "";
    if (*text != 0) drawing.text({-0.1, 0.15}, text, robotlink::colors::kRed);
  }

  robotlink::Input<robotcontrol::BodySensors> body_;
  robotlink::Input<foxglove::JointStates> joints_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  JointLayout layout_;
  LegKinematics kinematics_;
  robotlink::Output<RobotState> state_;
  RobotState package_;
  std::vector<double> positions_, efforts_;
  double last_ = NAN;
  bool began_ = false;
};

using ContactFields = robotcontrol::ContactRobotStateParameters;
using ContactOptions = ContactEvents::Options;
const robotlink::ParameterTable<ContactOptions> kContactTable{
    {ContactFields::kPickedUpAfterFieldNumber, &ContactOptions::pickedUpAfter, kAtLeastZero},
    {ContactFields::kPutDownAfterFieldNumber, &ContactOptions::putDownAfter, kAtLeastZero},
    {ContactFields::kStuckAfterFieldNumber, &ContactOptions::stuckAfter, kAboveZero}};

class ContactRobotState final : public RobotStateEstimator {
 public:
  explicit ContactRobotState(robotlink::SolutionContext& context)
      : RobotStateEstimator(context), parameters_(context.parameters<ContactFields>()) {}

 private:
  const BodyEvents& detect(BodyFrame& frame) override {
    if (debug_.on(kContactsKey)) {
      constexpr std::array kCurves{"front-left", "front-right", "hind-left", "hind-right"};
      for (std::size_t i = 0; i < kCurves.size(); ++i)
        debug_.plot(kContactsKey, kCurves[i], frame.contacts[i] ? 1 : 0);
    }
    detector_.setOptions(kContactTable.read(parameters_));
    return detector_.update(frame);
  }

  const ContactFields& parameters_;
  ContactEvents detector_{{}};
};

const robotlink::SolutionRegistration kContactState =
    robotlink::SolutionBuilder<ContactRobotState>(
        "robot-state", "contacts",
        "Uses the foot switches and the accelerometer: a robot without contacts was picked up, and a "
        "leg that does not step has collided.")
        .source("A method of this project.")
        .needs(robotlink::kBodySensors)
        .needs(robotlink::kJointStates)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kRobotState)
        .keys({&kLegStatesKey, &kEventsKey, &kContactsKey})
        .parameters<ContactFields>(kContactTable.rules<ContactFields>());

struct JointErrorOptions : JointErrorEvents::Options {
  /// From a request to the angles that are measured because of it, s.
  double delay = 0.016;
};

using ErrorFields = robotcontrol::JointErrorRobotStateParameters;
const robotlink::ParameterTable<JointErrorOptions> kJointErrorTable{
    {ErrorFields::kLoadFieldNumber, &JointErrorOptions::load, kAtLeastZero},
    {ErrorFields::kLoadTimeFieldNumber, &JointErrorOptions::loadTime, kAtLeastZero},
    {ErrorFields::kDeviationsFieldNumber, &JointErrorOptions::deviations, kAboveZero},
    {ErrorFields::kErrorTimeFieldNumber, &JointErrorOptions::errorTime, kAtLeastZero},
    {ErrorFields::kUsualTimeFieldNumber, &JointErrorOptions::usualTime, kAtLeastZero},
    {ErrorFields::kLearningTimeFieldNumber, &JointErrorOptions::learningTime, kAtLeastZero},
    {ErrorFields::kDelayFieldNumber, &JointErrorOptions::delay, kAtLeastZero}};

class JointErrorRobotState final : public RobotStateEstimator {
 public:
  explicit JointErrorRobotState(robotlink::SolutionContext& context)
      : RobotStateEstimator(context),
        parameters_(context.parameters<ErrorFields>()),
        request_(context.input(robotlink::kJointRequest)) {}

 private:
  const BodyEvents& detect(BodyFrame& frame) override {
    const JointErrorOptions options = kJointErrorTable.read(parameters_);
    detector_.setOptions(options);
    age_ += robotlink::seconds(frame.time);
    if (request_) remember();
    // The newest request that is old enough.
    while (requests_.size() > 1 && age_ - requests_[1].time >= options.delay) requests_.pop_front();
    if (!requests_.empty()) frame.requested = requests_.front().legs;
    const BodyEvents& events = detector_.update(frame);
    if (debug_.on(kLoadKey)) {
      debug_.plot(kLoadKey, "load", detector_.load(), "N m");
      constexpr std::array kCurves{"front-left", "front-right", "hind-left", "hind-right"};
      for (const Leg leg : kLegs) debug_.plot(kLoadKey, kCurves[index(leg)], detector_.excess(leg));
    }
    return events;
  }

  void remember() {
    // Joints without a request keep the last one.
    requested_.resize(layout().size(), 0);
    for (int i = 0; i < request_->positions_size() && i < static_cast<int>(requested_.size()); ++i)
      if (std::isfinite(request_->positions(i)))
        requested_[static_cast<std::size_t>(i)] = request_->positions(i);
    requests_.push_back({age_, legsOf(requested_)});
  }

  struct Request {
    double time = 0;
    std::array<LegAngles, 4> legs;
  };
  const ErrorFields& parameters_;
  robotlink::Input<robotcontrol::JointRequest> request_;
  JointErrorEvents detector_{{}};
  std::vector<double> requested_;
  std::deque<Request> requests_;
  double age_ = 0;
};

const robotlink::SolutionRegistration kJointErrorState =
    robotlink::SolutionBuilder<JointErrorRobotState>(
        "robot-state", "joint-errors",
        "Uses the joints: a robot whose knees support no weight was picked up, and a leg whose angles lag "
        "behind the request more than usual has collided.")
        .source(
            "M. Quinlan, C. Murch, R. Middleton, S. Chalup: Traction monitoring for collision detection with "
            "legged robots, RoboCup 2003.")
        .needs(robotlink::kBodySensors)
        .needs(robotlink::kJointStates)
        .needs(robotlink::kJointRequest)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kRobotState)
        .keys({&kLegStatesKey, &kEventsKey, &kLoadKey})
        .parameters<ErrorFields>(kJointErrorTable.rules<ErrorFields>());

/// Says what truly happens.
class OracleRobotState final : public RobotStateEstimator {
 public:
  explicit OracleRobotState(robotlink::SolutionContext& context)
      : RobotStateEstimator(context), truth_(context.input(robotlink::kOracleState)) {}

 private:
  const BodyEvents& detect(BodyFrame&) override {
    if (!truth_) return events_;
    events_.pickedUp = truth_->picked_up();
    events_.fallen = truth_->fallen();
    events_.side = sideOf(truth_->side());
    for (const Leg leg : kLegs)
      events_.collided[index(leg)] =
          std::ranges::find(truth_->collisions(), kLegNames[index(leg)]) != truth_->collisions().end();
    return events_;
  }

  robotlink::Input<RobotState> truth_;
  BodyEvents events_;
};

const robotlink::SolutionRegistration kOracleRobotState =
    robotlink::SolutionBuilder<OracleRobotState>("robot-state", "oracle",
                                                 "What truly happens to the body, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kBodySensors)
        .needs(robotlink::kJointStates)
        .needs(robotlink::kOracleState)
        .uses(robotlink::kMotionStatus)
        .yields(robotlink::kRobotState)
        .keys({&kLegStatesKey, &kEventsKey});

}  // namespace
}  // namespace modules
