// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "head-control": they connect a HeadController to packages.
#include "MotionParameters.pb.h"
#include "foxglove/Robot.pb.h"
#include "modules/motion/HeadController.h"
#include "modules/motion/ParameterConversion.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

const robotlink::PlotKey kAnglesKey{"head-control/angles",
                                    "Tilt and pan, requested and reached (plots, rad)"};
const robotlink::PlotKey kStateKey{"head-control/state",
                                   "0 still, 1 at the ball, 2 searching for it, 3 looking around (plot)"};
const robotlink::RobotDrawingKey kGazeKey{
    "head-control/gaze",
    "Where the head looks, from above, and the ball that it tracks (drawn around the robot)"};

/// The common part of both solutions: converts packages to the controller's values and back.
class HeadControlSolution : public robotlink::Solution {
 public:
  explicit HeadControlSolution(robotlink::SolutionContext& context)
      : context_(context),
        mode_(context.input(robotlink::kHeadMode)),
        ball_(context.input(robotlink::kBallModel)),
        joints_(context.input(robotlink::kJointStates)),
        request_(context.output(robotlink::kHeadRequest)),
        parameters_(context.parameters<robotcontrol::HeadControlParameters>()),
        controller_(headParameters(parameters_)) {}

  void execute() override {
    controller_.setParameters(headParameters(parameters_));
    const robotlink::Instant now = context_.clock().now();
    const robotlink::Duration frame = started_ ? std::min(now - last_, kLongestFrame) : robotlink::Duration{};
    last_ = now;
    started_ = true;
    const HeadAngles head = measured();
    const HeadAngles wanted = decide(controller_, head, frame);
    send(wanted);
    publish(wanted, head);
  }

 protected:
  virtual HeadAngles decide(HeadController& controller, const HeadAngles& head,
                            robotlink::Duration frame) = 0;

  HeadCommand desired() const {
    HeadCommand desired;
    if (!mode_) return desired;
    desired.angles = {mode_->tilt(), mode_->pan(), mode_->roll(), mode_->mouth()};
    switch (mode_->kind()) {
      case robotcontrol::HeadMode::SEARCH_BALL:
        desired.kind = HeadCommand::Kind::kSearchBall;
        break;
      case robotcontrol::HeadMode::TRACK_BALL:
        desired.kind = HeadCommand::Kind::kTrackBall;
        break;
      case robotcontrol::HeadMode::LOOK_AROUND:
        desired.kind = HeadCommand::Kind::kLookAround;
        break;
      case robotcontrol::HeadMode::ANGLES:
        desired.kind = HeadCommand::Kind::kAngles;
        break;
      default:
        break;
    }
    return desired;
  }

  std::optional<BallSight> ball() const {
    if (!ball_ || !ball_->known()) return std::nullopt;
    return BallSight{robotlink::vector2(ball_->position_in_robot()), ball_->seconds_since_seen()};
  }

 private:
  static constexpr robotlink::Duration kLongestFrame = std::chrono::milliseconds(100);

  HeadAngles measured() const {
    HeadAngles angles;
    if (!joints_) return angles;
    for (const auto& joint : joints_->joints()) {
      if (joint.name() == "neckTilt") angles.tilt = joint.position();
      if (joint.name() == "headPan") angles.pan = joint.position();
      if (joint.name() == "headRoll") angles.roll = joint.position();
      if (joint.name() == "mouth") angles.mouth = joint.position();
    }
    return angles;
  }

  void send(const HeadAngles& angles) {
    auto request = std::make_shared<robotcontrol::HeadRequest>();
    robotlink::assign(*request->mutable_timestamp(), last_);
    request->set_tilt(angles.tilt);
    request->set_pan(angles.pan);
    request->set_roll(angles.roll);
    request->set_mouth(angles.mouth);
    request_.send(std::move(request));
  }

  void publish(const HeadAngles& wanted, const HeadAngles& head) {
    robotlink::DebugContext& debug = context_.debug();
    if (debug.on(kAnglesKey)) {
      debug.plot(kAnglesKey, "wanted-tilt", wanted.tilt, "rad");
      debug.plot(kAnglesKey, "wanted-pan", wanted.pan, "rad");
      debug.plot(kAnglesKey, "tilt", head.tilt, "rad");
      debug.plot(kAnglesKey, "pan", head.pan, "rad");
    }
    if (debug.on(kStateKey)) debug.plot(kStateKey, static_cast<double>(controller_.state()));
    if (debug.on(kGazeKey)) draw(head);
  }

  void draw(const HeadAngles& head) {
    auto drawing = context_.debug().robotDrawing(kGazeKey);
    const robotlink::Vector2 neck(RobotDimensions{}.neckX, 0);
    const robotlink::Vector2 gaze(std::cos(head.pan), std::sin(head.pan));
    drawing.arrow(neck, neck + 0.3 * gaze, robotlink::colors::kSkyBlue, 2);
    if (controller_.state() != HeadController::State::kTracking) return;
    drawing.circle(ball()->position, headParameters(parameters_).ballRadius, robotlink::colors::kOrange, 2);
    drawing.line(neck, ball()->position, robotlink::colors::kOrange, 1);
  }

  robotlink::SolutionContext& context_;
  robotlink::Input<robotcontrol::HeadMode> mode_;
  robotlink::Input<robotcontrol::BallModel> ball_;
  robotlink::Input<foxglove::JointStates> joints_;
  robotlink::Output<robotcontrol::HeadRequest> request_;
  const robotcontrol::HeadControlParameters& parameters_;
  HeadController controller_;
  robotlink::Instant last_;
  bool started_ = false;
};

class SearchAndTrack final : public HeadControlSolution {
 public:
  using HeadControlSolution::HeadControlSolution;
  HeadAngles decide(HeadController& controller, const HeadAngles& head, robotlink::Duration frame) override {
    return controller.advance(desired(), ball(), head, frame);
  }
};

class LookAround final : public HeadControlSolution {
 public:
  using HeadControlSolution::HeadControlSolution;
  HeadAngles decide(HeadController& controller, const HeadAngles& head, robotlink::Duration frame) override {
    const HeadCommand wanted = desired();
    if (wanted.kind == HeadCommand::Kind::kAngles)
      return controller.advance(wanted, std::nullopt, head, frame);
    return controller.lookAround(head, frame);
  }
};

template <typename S>
robotlink::SolutionDescription headSolution(const char* name, const char* help) {
  return robotlink::SolutionBuilder<S>("head-control", name, help)
      .source("A method of this project.")
      .needs(robotlink::kJointStates)
      .uses(robotlink::kHeadMode)
      .uses(robotlink::kBallModel)
      .yields(robotlink::kHeadRequest)
      .keys({&kAnglesKey, &kStateKey, &kGazeKey})
      .template parameters<robotcontrol::HeadControlParameters>(headRules());
}

const robotlink::SolutionRegistration kSearchAndTrack =
    headSolution<SearchAndTrack>("search-and-track",
                                 "Looks at the ball while it is known, searches for it in two sweeps, far "
                                 "and near, when it is lost, and follows the other head modes.");
const robotlink::SolutionRegistration kLookAround =
    headSolution<LookAround>("look-around",
                             "Sweeps from side to side at the height of beacons and goals regardless of "
                             "requests, except for given angles: for tests of localization.");

}  // namespace
}  // namespace modules
