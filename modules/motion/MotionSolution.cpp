// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/MotionSolution.h"

#include <algorithm>
#include <cmath>

#include "MotionParameters.pb.h"
#include "foxglove/Robot.pb.h"
#include "modules/motion/ParameterConversion.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/motions/MotionLibrary.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using robotlink::Level;

namespace {

const robotlink::PlotKey kSpeedKey{"motion/speed",
                                   "The requested speed and that of the gait (plots x, y, rotation)"};
const robotlink::PlotKey kPhaseKey{"motion/phase", "The phase of the gait's cycle, 0 to 1 (plot)"};
const robotlink::PlotKey kUprightKey{"motion/upright",
                                     "The robot's estimate of how upright it is, 1 is level (plot)"};
const robotlink::PlotKey kJointsKey{"motion/joint-errors",
                                    "How far each leg's joints are from what was requested (plots, rad)"};
const robotlink::RobotDrawingKey kPawsKey{
    "motion/paws",
    "Where the paws should be, those on the ground filled, with their step vectors (drawn around the robot)"};
const robotlink::PlotKey kOdometryKey{"motion/odometry",
                                      "Dead reckoning since the program started (plots x, y, heading)"};

constexpr robotlink::Duration kFrame = std::chrono::milliseconds(8);
constexpr int kMaxFrames = 5;
constexpr std::array<const char*, 4> kLegLabels{"front-left", "front-right", "hind-left", "hind-right"};

class RectangleMotion final : public MotionSolution {
 public:
  explicit RectangleMotion(robotlink::SolutionContext& context)
      : MotionSolution(context, FootMode::kRectangle) {}
};

class HalfEllipseMotion final : public MotionSolution {
 public:
  explicit HalfEllipseMotion(robotlink::SolutionContext& context)
      : MotionSolution(context, FootMode::kHalfEllipse) {}
};

template <typename S>
robotlink::SolutionDescription described(const char* name, const char* help) {
  return robotlink::SolutionBuilder<S>("motion", name, help)
      .source(
          "B. Hengst, D. Ibbotson, S. B. Pham, C. Sammut: Omnidirectional locomotion for quadruped robots, "
          "RoboCup 2001; T. R\u00f6fer et al.: GermanTeam RoboCup 2002, team report, 2002.")
      .needs(robotlink::kJointStates)
      .needs(robotlink::kBodySensors)
      .uses(robotlink::kMotionRequest)
      .uses(robotlink::kHeadRequest)
      .uses(robotlink::kMotionTexts)
      .yields(robotlink::kJointRequest)
      .yields(robotlink::kMotionStatus)
      .keys({&kSpeedKey, &kPhaseKey, &kUprightKey, &kJointsKey, &kPawsKey, &kOdometryKey})
      .template parameters<robotcontrol::GaitMotionParameters>(gaitRules());
}

const robotlink::SolutionRegistration kRectangle =
    described<RectangleMotion>("wheel-model-rectangle",
                               "Stands, walks, plays key-frame motions and gets up. Walks in a trot by the "
                               "wheel model of the legs; lifts the paws "
                               "straight up, carries them forward and puts them straight down.");
const robotlink::SolutionRegistration kHalfEllipse =
    described<HalfEllipseMotion>("wheel-model-half-ellipse",
                                 "Stands, walks, plays key-frame motions and gets up. Walks in a trot by the "
                                 "wheel model of the legs; swings the paws "
                                 "forward along half an ellipse.");

const robotlink::SolutionRegistration kFast =
    described<RectangleMotion>("wheel-model-fast",
                               "Like wheel-model-rectangle, with a gait tuned for speed in games: "
                               "short, quick steps.");

const robotlink::SolutionRegistration kTuned =
    described<RectangleMotion>("wheel-model-tuned",
                               "Like wheel-model-rectangle, with the stance and steps that robotctl tune "
                               "found for speed straight ahead.");

WalkSpeed walkSpeed(const robotcontrol::Velocity2& from) {
  return {from.x(), from.y(), from.rotation()};
}

void assign(robotcontrol::Velocity2& to, const WalkSpeed& from) {
  to.set_x(from.x);
  to.set_y(from.y);
  to.set_rotation(from.rotation);
}

MotionCommand::Kind desiredKind(robotcontrol::MotionRequest::Kind kind) {
  switch (kind) {
    case robotcontrol::MotionRequest::WALK:
      return MotionCommand::Kind::kWalk;
    case robotcontrol::MotionRequest::KEY_FRAMES:
      return MotionCommand::Kind::kKeyFrames;
    case robotcontrol::MotionRequest::GET_UP:
      return MotionCommand::Kind::kGetUp;
    case robotcontrol::MotionRequest::JOINTS:
      return MotionCommand::Kind::kJoints;
    default:
      return MotionCommand::Kind::kStand;
  }
}

robotcontrol::MotionRequest::Kind requestKind(MotionCommand::Kind kind) {
  switch (kind) {
    case MotionCommand::Kind::kWalk:
      return robotcontrol::MotionRequest::WALK;
    case MotionCommand::Kind::kKeyFrames:
      return robotcontrol::MotionRequest::KEY_FRAMES;
    case MotionCommand::Kind::kGetUp:
      return robotcontrol::MotionRequest::GET_UP;
    case MotionCommand::Kind::kJoints:
      return robotcontrol::MotionRequest::JOINTS;
    default:
      return robotcontrol::MotionRequest::STAND;
  }
}

/// A net with only its entry, for robots whose motions cannot be loaded.
std::shared_ptr<const robotlink::MotionNet> emptyNet(const std::vector<std::string>& joints) {
  auto net = std::make_shared<robotlink::MotionNet>();
  net->joints = joints;
  net->motions = {robotlink::MotionNet::kEntryName};
  net->nodes.push_back({robotlink::MotionJump{0, 0}, 0, 0});
  return net;
}

}  // namespace

MotionSolution::MotionSolution(robotlink::SolutionContext& context, FootMode mode)
    : context_(context),
      mode_(mode),
      request_(context.input(robotlink::kMotionRequest)),
      head_(context.input(robotlink::kHeadRequest)),
      joints_(context.input(robotlink::kJointStates)),
      sensors_(context.input(robotlink::kBodySensors)),
      texts_(context.input(robotlink::kMotionTexts)),
      jointRequest_(context.output(robotlink::kJointRequest)),
      status_(context.output(robotlink::kMotionStatus)),
      parameters_(context.parameters<robotcontrol::GaitMotionParameters>()) {
  create();
}

MotionSolution::~MotionSolution() = default;

void MotionSolution::create() {
  auto layout = JointLayout::of(context_.robot().description.joints);
  if (!layout) {
    context_.debug().text(Level::kError, "motion", layout.error().describe());
    return;
  }
  auto net = motions(layout->names());
  if (!net) net = emptyNet(layout->names());
  engine_ = std::make_unique<MotionEngine>(std::move(*layout), std::move(net),
                                           gaitParameters(parameters_, mode_), motionOptions(parameters_));
}

/// Returns the motions of the files with those that a user has sent. Null, after the errors were logged, if
/// they do not compile.
std::shared_ptr<const robotlink::MotionNet> MotionSolution::motions(const std::vector<std::string>& joints) {
  auto library = robotlink::MotionLibrary::load(robotlink::resource("motions"));
  if (library && texts_) {
    for (const auto& motion : texts_->motions()) library->replace(motion.name(), motion.text());
  }
  auto net = library.and_then([&](const auto& all) { return all.compile(joints); });
  if (net) return *net;
  for (const auto& error : net.error()) context_.debug().text(Level::kError, "motion", error.describe());
  return nullptr;
}

/// Motions that do not compile leave the robot those that it has.
void MotionSolution::takeMotions() {
  std::vector<std::string> joints;
  for (const auto& joint : context_.robot().description.joints) joints.push_back(joint.name);
  if (auto net = motions(joints)) engine_->setMotions(std::move(net));
}

void MotionSolution::execute() {
  if (!engine_) return;
  if (texts_.isNew()) takeMotions();
  if (!started_ && joints_) {
    engine_->start(measured());
    last_ = context_.clock().now() - kFrame;
    started_ = true;
  }
  engine_->setParameters(gaitParameters(parameters_, mode_), motionOptions(parameters_));
  for (robotlink::Duration time = frameTime(); time.count() > 0; time -= kFrame)
    engine_->advance(frame(kFrame));
  sendJoints();
  sendStatus();
  publish();
  plot();
  draw();
}

/// In the order of the robot's description; NaN where unknown.
std::vector<double> MotionSolution::measured() const {
  const auto& description = context_.robot().description;
  std::vector<double> positions(description.joints.size(), NAN);
  if (!joints_) return positions;
  for (const auto& joint : joints_->joints()) {
    const int i = description.jointIndex(joint.name());
    if (i >= 0) positions[static_cast<std::size_t>(i)] = joint.position();
  }
  return positions;
}

/// The time since the last frame in whole frames; they are counted even if the process was late.
robotlink::Duration MotionSolution::frameTime() {
  const robotlink::Instant now = context_.clock().now();
  const auto frames = std::max<robotlink::Duration::rep>((now - last_) / kFrame, 0);
  last_ = frames > kMaxFrames ? now : last_ + frames * kFrame;
  return std::min<robotlink::Duration::rep>(frames, kMaxFrames) * kFrame;
}

MotionEngine::Frame MotionSolution::frame(robotlink::Duration time) {
  MotionEngine::Frame frame;
  frame.time = time;
  if (request_) {
    frame.desired = {desiredKind(request_->kind()), walkSpeed(request_->walk()), request_->motion(),
                     desiredJoints(), request_->limp()};
  }
  if (frame.desired.limp) {
    measured_ = measured();
    frame.measured = measured_;
  }
  if (head_) frame.head = {head_->tilt(), head_->pan(), head_->roll(), head_->mouth()};
  if (sensors_) {
    acceleration_ = robotlink::vector3(sensors_->acceleration());
    frame.acceleration = &acceleration_;
  }
  return frame;
}

/// The angles that are requested, in the order of the robot's description. Joints that the robot does not
/// have are logged, once.
std::vector<double> MotionSolution::desiredJoints() {
  if (request_->kind() != robotcontrol::MotionRequest::JOINTS) return {};
  const auto& description = context_.robot().description;
  std::vector<double> positions(description.joints.size(), NAN);
  std::string unknown;
  for (const auto& joint : request_->joints()) {
    const int i = description.jointIndex(joint.name());
    if (i >= 0)
      positions[static_cast<std::size_t>(i)] = joint.position();
    else
      unknown = joint.name();
  }
  if (unknown != reportedJoint_ && !unknown.empty())
    context_.debug().text(Level::kWarning, "motion", "the robot has no joint '" + unknown + "'");
  reportedJoint_ = unknown;
  return positions;
}

void MotionSolution::sendJoints() {
  auto request = std::make_shared<robotcontrol::JointRequest>();
  robotlink::assign(*request->mutable_timestamp(), context_.clock().now());
  for (const double position : engine_->positions()) request->add_positions(position);
  request->set_stiffness(engine_->stiffness());
  jointRequest_.send(std::move(request));
}

void MotionSolution::sendStatus() {
  auto status = std::make_shared<robotcontrol::MotionStatus>();
  robotlink::assign(*status->mutable_timestamp(), context_.clock().now());
  const MotionCommand& executed = engine_->executed();
  auto& request = *status->mutable_executed();
  *request.mutable_timestamp() = status->timestamp();
  request.set_kind(requestKind(executed.kind));
  assign(*request.mutable_walk(), executed.walk);
  request.set_motion(executed.motion);
  request.set_limp(executed.limp);
  status->set_stable(engine_->stable());
  status->set_fallen(engine_->falls().fallen());
  robotlink::assign(*status->mutable_odometry(), engine_->odometry());
  assign(*status->mutable_velocity(), engine_->speed());
  status_.send(std::move(status));
}

/// Logs each fact once, when it changes.
void MotionSolution::publish() {
  robotlink::DebugContext& debug = context_.debug();
  if (engine_->refusal() != reportedRefusal_) {
    reportedRefusal_ = engine_->refusal();
    if (!reportedRefusal_.empty()) debug.text(Level::kWarning, "motion", reportedRefusal_);
  }
  if (engine_->falls().fallen() != reportedFallen_) {
    reportedFallen_ = engine_->falls().fallen();
    debug.text(Level::kInfo, "motion", reportedFallen_ ? "the robot fell" : "the robot is upright again");
  }
  if (engine_->executed().motion != reportedMotion_) {
    reportedMotion_ = engine_->executed().motion;
    if (!reportedMotion_.empty()) debug.text(Level::kInfo, "motion", "plays '" + reportedMotion_ + "'");
  }
}

void MotionSolution::plot() {
  robotlink::DebugContext& debug = context_.debug();
  if (debug.on(kSpeedKey)) {
    const WalkSpeed &wanted = engine_->gait().requested(), now = engine_->speed();
    debug.plot(kSpeedKey, "requested-x", wanted.x, "m/s");
    debug.plot(kSpeedKey, "requested-y", wanted.y, "m/s");
    debug.plot(kSpeedKey, "requested-rotation", wanted.rotation, "rad/s");
    debug.plot(kSpeedKey, "x", now.x, "m/s");
    debug.plot(kSpeedKey, "y", now.y, "m/s");
    debug.plot(kSpeedKey, "rotation", now.rotation, "rad/s");
  }
  if (debug.on(kPhaseKey)) debug.plot(kPhaseKey, engine_->gait().phase());
  if (debug.on(kUprightKey)) debug.plot(kUprightKey, engine_->falls().up().z());
  if (debug.on(kOdometryKey)) {
    debug.plot(kOdometryKey, "x", engine_->odometry().x, "m");
    debug.plot(kOdometryKey, "y", engine_->odometry().y, "m");
    debug.plot(kOdometryKey, "heading", engine_->odometry().heading, "rad");
  }
  if (joints_ && debug.on(kJointsKey)) {
    for (const auto& joint : joints_->joints()) {
      const int i = context_.robot().description.jointIndex(joint.name());
      if (i < 0 || !joint.name().starts_with("leg")) continue;
      debug.plot(kJointsKey, joint.name().c_str(),
                 engine_->positions()[static_cast<std::size_t>(i)] - joint.position(), "rad");
    }
  }
}

void MotionSolution::draw() {
  if (!context_.debug().on(kPawsKey)) return;
  auto drawing = context_.debug().robotDrawing(kPawsKey);
  const WheelModelGait& gait = engine_->gait();
  for (const Leg leg : kLegs) {
    const robotlink::Vector3 paw = gait.pawInBody(leg);
    const robotlink::Vector2 at(paw.x(), paw.y());
    const bool down = gait.onGround(leg);
    const auto color = down ? robotlink::colors::kGreen : robotlink::colors::kYellow;
    drawing.circle(at, 0.0125, color, 2,
                   down ? robotlink::Color{color.rgb, 0.6} : robotlink::Color{color.rgb, 0});
    const robotlink::Vector3 step = gait.stepVector(leg) / 2;
    const robotlink::Vector2 half(step.x(), step.y());
    if (half.norm() > 1e-4) drawing.arrow(at - half, at + half, color, 1);
    drawing.text(at, kLegLabels[index(leg)], robotlink::colors::kGray, 9);
  }
}

}  // namespace modules
