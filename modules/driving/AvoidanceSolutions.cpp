// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "obstacle-avoidance": they convert the behavior's drive requests to requests for
// the motors.
#include <cmath>

#include "DrivingParameters.pb.h"
#include "foxglove/Ranging.pb.h"
#include "modules/driving/DriveSensing.h"
#include "modules/driving/DynamicWindow.h"
#include "modules/driving/SpeedLimiter.h"
#include "modules/driving/VectorField.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::PlotKey;
using robotlink::RobotDrawingKey;
using robotlink::Vector2;

const RobotDrawingKey kPointsKey{
    "obstacle-avoidance/points",
    "The remembered obstacles around the robot, and its outline (drawn around the robot)"};
const RobotDrawingKey kHistogramKey{
    "obstacle-avoidance/histogram",
    "How far it could drive in each direction, with open ones (green) and the "
    "chosen one (drawn around the robot)"};
const RobotDrawingKey kWindowKey{
    "obstacle-avoidance/window",
    "The arcs of the velocities that it could choose (green, red where it could not "
    "brake) (drawn around the robot)"};
const RobotDrawingKey kArcKey{"obstacle-avoidance/arc",
                              "Where its motion leads within a second (drawn around the robot)"};
const PlotKey kSpeedKey{"obstacle-avoidance/speed",
                        "The desired, requested and driven speeds and rotations (plots)"};

using robotlink::kAboveZero;
using robotlink::kAtLeastZero;

using FieldOptions = VectorField::Options;
using FieldFields = robotcontrol::VectorFieldParameters;
const robotlink::ParameterTable<FieldOptions> kVectorFieldTable{
    {FieldFields::kMarginFieldNumber, &FieldOptions::margin, kAtLeastZero},
    {FieldFields::kReachFieldNumber, &FieldOptions::reach, kAboveZero},
    {FieldFields::kNeedFieldNumber, &FieldOptions::need, kAtLeastZero},
    {FieldFields::kNeedAgainFieldNumber, &FieldOptions::needAgain, kAtLeastZero},
    {FieldFields::kWishTimeFieldNumber, &FieldOptions::desiredTime, kAtLeastZero},
    {FieldFields::kWishCostFieldNumber, &FieldOptions::desiredCost, kAtLeastZero},
    {FieldFields::kStraightCostFieldNumber, &FieldOptions::straightCost, kAtLeastZero},
    {FieldFields::kLastCostFieldNumber, &FieldOptions::lastCost, kAtLeastZero},
    {FieldFields::kSteeringFieldNumber, &FieldOptions::steering, kAtLeastZero},
    {FieldFields::kLatencyFieldNumber, &FieldOptions::latency, kAtLeastZero}};

/// Limited, because with too many samples a frame takes too long.
constexpr robotlink::ParameterRange kSampleCount{1, 50};

using WindowOptions = DynamicWindow::Options;
using WindowFields = robotcontrol::DynamicWindowParameters;
const robotlink::ParameterTable<WindowOptions> kDynamicWindowTable{
    {WindowFields::kMarginFieldNumber, &WindowOptions::margin, kAtLeastZero},
    {WindowFields::kWindowFieldNumber, &WindowOptions::window, kAboveZero},
    {WindowFields::kHorizonFieldNumber, &WindowOptions::horizon, kAboveZero},
    {WindowFields::kLatencyFieldNumber, &WindowOptions::latency, kAtLeastZero},
    {WindowFields::kSpeedsFieldNumber, &WindowOptions::speeds, kSampleCount},
    {WindowFields::kRotationsFieldNumber, &WindowOptions::rotations, kSampleCount},
    {WindowFields::kSpeedWeightFieldNumber, &WindowOptions::speedWeight, kAtLeastZero},
    {WindowFields::kRotationWeightFieldNumber, &WindowOptions::rotationWeight, kAtLeastZero},
    {WindowFields::kWayWeightFieldNumber, &WindowOptions::wayWeight, kAtLeastZero},
    {WindowFields::kRoomWeightFieldNumber, &WindowOptions::roomWeight, kAtLeastZero}};

/// The time after which a request has expired, s.
constexpr double kRequestOutdated = 1.0;

/// Has the behavior's request and the robot's limits, and sends requests that the robot can follow.
class Avoidance : public robotlink::Solution {
 public:
  explicit Avoidance(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        clock_(context.clock()),
        limits_(limitsOf(context.robot().description)),
        desired_(context.input(robotlink::kBehaviorDrive)),
        request_(context.output(robotlink::kDriveRequest)) {}

 protected:
  /// The current request of the behavior; zero if it has expired.
  DriveVelocity desired() const {
    if (!desired_) return {};
    const double age = robotlink::seconds(clock_.now() - robotlink::instant(desired_->timestamp()));
    const DriveVelocity desired{desired_->velocity().x(), desired_->velocity().rotation()};
    if (std::abs(age) > kRequestOutdated || !std::isfinite(desired.forward) ||
        !std::isfinite(desired.rotation))
      return {};
    return {std::clamp(desired.forward, -limits_.speed, limits_.speed),
            std::clamp(desired.rotation, -limits_.rotation, limits_.rotation)};
  }

  void send(const DriveVelocity& wanted) {
    const double now = robotlink::seconds(clock_.now());
    const DriveVelocity velocity = limiter_.limit(wanted, limits_, now - sentAt_);
    sentAt_ = now;
    auto request = std::make_shared<robotcontrol::DriveRequest>();
    robotlink::assign(*request->mutable_timestamp(), clock_.now());
    request->mutable_velocity()->set_x(velocity.forward);
    request->mutable_velocity()->set_rotation(velocity.rotation);
    request_.send(std::move(request));
  }

  void plot(const DriveVelocity& driven) {
    if (debug_.on(kArcKey)) {
      const double turned = 0.5 * driven.rotation;
      const Vector2 end = driven.forward * Vector2(std::cos(turned), std::sin(turned));
      debug_.robotDrawing(kArcKey).line(Vector2(0, 0), end, robotlink::colors::kGreen, 3);
    }
    if (!debug_.on(kSpeedKey)) return;
    debug_.plot(kSpeedKey, "desired", desired().forward, "m/s");
    debug_.plot(kSpeedKey, "requested", limiter_.last().forward, "m/s");
    debug_.plot(kSpeedKey, "driven", driven.forward, "m/s");
    debug_.plot(kSpeedKey, "rotation desired", desired().rotation, "rad/s");
    debug_.plot(kSpeedKey, "rotation requested", limiter_.last().rotation, "rad/s");
    debug_.plot(kSpeedKey, "rotation driven", driven.rotation, "rad/s");
  }

  const DriveVelocity& lastRequest() const { return limiter_.last(); }

  robotlink::DebugContext& debug_;
  const robotlink::Clock& clock_;
  const DriveLimits limits_;

 private:
  robotlink::Input<robotcontrol::DriveRequest> desired_;
  robotlink::Output<robotcontrol::DriveRequest> request_;
  SpeedLimiter limiter_;
  double sentAt_ = -1;
};

/// Avoids obstacles seen by the sensors; does not drive without readings.
class SeeingAvoidance : public Avoidance {
 public:
  explicit SeeingAvoidance(robotlink::SolutionContext& context)
      : Avoidance(context), outline_(outlineOf(context.robot().description)), sensing_(context) {}

  void execute() override {
    sensing_.update(lastRequest().forward);
    if (!sensing_.awake()) {
      if (!warned_ && desired() != DriveVelocity{}) {
        debug_.text(robotlink::Level::kWarning, "obstacle-avoidance", "stands: " + sensing_.whyNot());
        warned_ = true;
      }
      return send({});
    }
    warned_ = false;
    const AvoidanceSituation situation{sensing_.emergencyStop() ? DriveVelocity{} : desired(),
                                       sensing_.velocity(), sensing_.points(), limits_, sensing_.time()};
    send(avoid(situation));
    plot(sensing_.velocity());
    drawPoints();
  }

 protected:
  virtual DriveVelocity avoid(const AvoidanceSituation& situation) = 0;
  const Outline& outline() const { return outline_; }

 private:
  void drawPoints() {
    if (!debug_.on(kPointsKey)) return;
    auto drawing = debug_.robotDrawing(kPointsKey);
    const double l = outline_.halfLength, w = outline_.halfWidth;
    const std::array corners{Vector2(l, w), Vector2(-l, w), Vector2(-l, -w), Vector2(l, -w)};
    drawing.polygon(corners, robotlink::colors::kBlack, 2);
    for (const Vector2& point : sensing_.points()) drawing.dot(point, robotlink::colors::kRed, 0.05);
  }

  Outline outline_;
  DriveSensing sensing_;
  bool warned_ = false;
};

/// Avoidance by an engine whose options are parameters of the solution.
template <typename Engine, typename Parameters,
          const robotlink::ParameterTable<typename Engine::Options>& kTable>
class EngineAvoidance : public SeeingAvoidance {
 public:
  explicit EngineAvoidance(robotlink::SolutionContext& context)
      : SeeingAvoidance(context), parameters_(context.parameters<Parameters>()), engine_(options()) {}

 protected:
  const Engine& engine() const { return engine_; }
  /// Draws what the engine has decided.
  virtual void draw() = 0;

 private:
  DriveVelocity avoid(const AvoidanceSituation& situation) override {
    engine_.setOptions(options());
    const DriveVelocity velocity = engine_.decide(situation);
    draw();
    return velocity;
  }

  typename Engine::Options options() const {
    typename Engine::Options options = kTable.read(parameters_);
    options.outline = outline();
    return options;
  }

  const Parameters& parameters_;
  Engine engine_;
};

class VectorFieldAvoidance final
    : public EngineAvoidance<VectorField, robotcontrol::VectorFieldParameters, kVectorFieldTable> {
 public:
  using EngineAvoidance::EngineAvoidance;

 private:
  void draw() override {
    if (!debug_.on(kHistogramKey)) return;
    auto drawing = debug_.robotDrawing(kHistogramKey);
    const auto at = [](double angle, double way) {
      return Vector2(way * std::cos(angle), way * std::sin(angle));
    };
    for (int sector = 0; sector < PolarView::kSectors; ++sector) {
      const double angle = PolarView::angleOf(sector);
      drawing.line(Vector2(0, 0), at(angle, engine().view().free(sector)),
                   engine().open(sector) ? robotlink::colors::kGreen : robotlink::colors::kRed);
    }
    const auto color = engine().escaping() ? robotlink::colors::kOrange : robotlink::colors::kBlue;
    drawing.arrow(Vector2(0, 0), at(engine().direction(), 1), color, 3);
  }
};

const robotlink::SolutionRegistration kVectorField =
    robotlink::SolutionBuilder<VectorFieldAvoidance>(
        "obstacle-avoidance", "vector-field",
        "Chooses the open direction nearest to the desired one, from a polar histogram of recent readings.")
        .source(
            "J. Borenstein, Y. Koren: The vector field histogram, 1991; I. Ulrich, J. Borenstein: VFH+, "
            "1998.")
        .needs(robotlink::kBehaviorDrive)
        .needs(robotlink::kDriveState)
        .uses(robotlink::kSonar)
        .uses(robotlink::kLaser)
        .yields(robotlink::kDriveRequest)
        .keys({&kPointsKey, &kHistogramKey, &kSpeedKey, &kArcKey})
        .parameters<robotcontrol::VectorFieldParameters>(
            kVectorFieldTable.rules<robotcontrol::VectorFieldParameters>());

class DynamicWindowAvoidance final
    : public EngineAvoidance<DynamicWindow, robotcontrol::DynamicWindowParameters, kDynamicWindowTable> {
 public:
  using EngineAvoidance::EngineAvoidance;

 private:
  /// Draws each velocity as the arc that the robot would drive.
  void draw() override {
    if (!debug_.on(kWindowKey)) return;
    auto drawing = debug_.robotDrawing(kWindowKey);
    const auto arc = [&](const DriveVelocity& velocity, double time, robotlink::Color color, double width) {
      Vector2 last(0, 0);
      constexpr int kPieces = 8;
      for (int i = 1; i <= kPieces; ++i) {
        const double t = time * i / kPieces, half = 0.5 * velocity.rotation * t;
        const double chord = velocity.forward * t * (std::abs(half) < 1e-6 ? 1 : std::sin(half) / half);
        const Vector2 next(chord * std::cos(half), chord * std::sin(half));
        drawing.line(last, next, color, width);
        last = next;
      }
    };
    for (const DynamicWindow::Candidate& candidate : engine().candidates())
      arc(candidate.velocity, candidate.freeTime,
          candidate.admissible ? robotlink::colors::kGreen : robotlink::colors::kRed, 1);
    arc(engine().chosen(), 3, engine().escaping() ? robotlink::colors::kOrange : robotlink::colors::kBlue, 3);
  }
};

const robotlink::SolutionRegistration kDynamicWindow =
    robotlink::SolutionBuilder<DynamicWindowAvoidance>(
        "obstacle-avoidance", "dynamic-window",
        "Chooses the velocity nearest to the desired one that its motors can reach and from which it can "
        "brake in time.")
        .source("D. Fox, W. Burgard, S. Thrun: The dynamic window approach to collision avoidance, 1997.")
        .needs(robotlink::kBehaviorDrive)
        .needs(robotlink::kDriveState)
        .uses(robotlink::kSonar)
        .uses(robotlink::kLaser)
        .yields(robotlink::kDriveRequest)
        .keys({&kPointsKey, &kWindowKey, &kSpeedKey, &kArcKey})
        .parameters<robotcontrol::DynamicWindowParameters>(
            kDynamicWindowTable.rules<robotcontrol::DynamicWindowParameters>());

class NoAvoidance final : public Avoidance {
 public:
  explicit NoAvoidance(robotlink::SolutionContext& context) : Avoidance(context) {}
  void execute() override {
    send(desired());
    plot({});
  }
};

const robotlink::SolutionRegistration kNone =
    robotlink::SolutionBuilder<NoAvoidance>(
        "obstacle-avoidance", "none",
        "Passes desired velocities on, ignoring obstacles, within the motors' limits: for experts.")
        .source("A method of this project.")
        .needs(robotlink::kBehaviorDrive)
        .yields(robotlink::kDriveRequest)
        .keys({&kSpeedKey, &kArcKey});

}  // namespace
}  // namespace modules
