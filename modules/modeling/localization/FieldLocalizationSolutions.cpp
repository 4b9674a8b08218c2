// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "self-localisation" on a field that combine landmarks and lines.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ModelingParameters.pb.h"
#include "modules/modeling/SelfLocalization.h"
#include "modules/modeling/localization/FieldMonteCarlo.h"
#include "modules/modeling/localization/OdometryBuffer.h"
#include "modules/modeling/localization/PoseKalmanFilter.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {
namespace {

using robotlink::kAboveZero;
using robotlink::kAtLeastOne;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::Pose2;
using robotlink::Vector2;

const robotlink::FieldDrawingKey kFittedLinesKey{
    "self-localisation/lines", "The seen line points, placed by the estimated pose (drawn on the field)"};
const robotlink::PlotKey kLandmarkFitKey{"self-localisation/fit",
                                         "How well the landmarks fit the particles, 0 to 1"};
const robotlink::FieldDrawingKey kHypothesesKey{
    "self-localisation/hypotheses",
    "The hypotheses of the filter, with their deviations (drawn on the field)"};
const robotlink::PlotKey kHypothesisWeightKey{
    "self-localisation/hypothesis-weights",
    "The number of hypotheses, and the weight of the best one (plots)"};

constexpr robotlink::ParameterRange kEvidence{0, 1, true};

/// The common part of both solutions: what an image shows, and the pose by dead reckoning at its time.
/// `Filter` is FieldMonteCarlo or PoseKalmanFilter.
template <typename Filter>
class FieldLocalization : public SelfLocalization {
 public:
  explicit FieldLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context),
        field_(context.robot().field),
        percepts_(context.input(robotlink::kLandmarkPercepts)),
        lines_(context.input(robotlink::kFieldLines)),
        motion_(context.input(robotlink::kMotionStatus)),
        state_(context.input(robotlink::kRobotState)) {}

  void execute() override {
    if (!percepts_ || !percepts_.isNew()) return;
    // The filter is not made in the constructor, because its maps take some milliseconds.
    if (!filter_) filter_.emplace(*field_, options());
    filter_->setOptions(options());
    filter_->update(frame());
    publish(filter_->estimate(), percepts_->timestamp());
    if (debug_.on(kFittedLinesKey)) drawLines();
    draw(*filter_);
  }

 protected:
  virtual typename Filter::Options options() const = 0;
  virtual void draw(const Filter& filter) = 0;

 private:
  typename Filter::Frame frame() {
    typename Filter::Frame frame;
    frame.time = robotlink::seconds(robotlink::instant(percepts_->timestamp()));
    frame.carried = state_ && state_->picked_up();
    bool fallen = false;
    if (motion_) {
      const auto kind = motion_->executed().kind();
      fallen = motion_->fallen();
      frame.shaken = fallen || kind == robotcontrol::MotionRequest::KEY_FRAMES ||
                     kind == robotcontrol::MotionRequest::GET_UP || (state_ && !state_->collisions().empty());
      odometry_.add(robotlink::seconds(robotlink::instant(motion_->timestamp())),
                    robotlink::pose2(motion_->odometry()));
    }
    frame.robotInOdometry = odometry_.at(frame.time);
    landmarks_.clear();
    points_.clear();
    // The camera's pose is unknown while the robot lies or hangs.
    if (fallen || frame.carried) return frame;
    for (const robotcontrol::LandmarkPercept& percept : percepts_->landmarks()) addLandmark(percept);
    // Percepts of an older image would be combined with the wrong pose.
    if (lines_ && robotlink::instant(lines_->timestamp()) == robotlink::instant(percepts_->timestamp())) {
      for (const auto& point : lines_->points())
        points_.push_back({robotlink::vector2(point.position_in_robot()), point.direction()});
    }
    frame.landmarks = landmarks_;
    frame.lines = points_;
    return frame;
  }

  void addLandmark(const robotcontrol::LandmarkPercept& percept) {
    LandmarkMeasurement seen{Vector2::Zero(), percept.bearing(), percept.distance(), percept.confidence(),
                             percept.kind() == robotcontrol::LandmarkPercept::GOAL};
    using Field = robotlink::FieldDescription;
    if (seen.isGoal) {
      const auto goal = std::ranges::find(field_->goals, percept.name(), &Field::Goal::name);
      if (goal == field_->goals.end()) return;
      seen.position = {goal->x + std::copysign(0.5 * field_->goalDepth, goal->x), 0};
    } else {
      const auto beacon = std::ranges::find(field_->beacons, percept.name(), &Field::Beacon::name);
      if (beacon == field_->beacons.end()) return;
      seen.position = beacon->position;
    }
    landmarks_.push_back(seen);
  }

  void drawLines() {
    auto drawing = debug_.fieldDrawing(kFittedLinesKey);
    const Pose2& robot = filter_->estimate().robotInField;
    for (const LineMeasurement& point : points_)
      drawing.dot(robot * point.inRobot, robotlink::colors::kPink, 0.03);
  }

  std::shared_ptr<const robotlink::FieldDescription> field_;
  robotlink::Input<robotcontrol::LandmarkPercepts> percepts_;
  robotlink::Input<robotcontrol::FieldLinePercepts> lines_;
  robotlink::Input<robotcontrol::MotionStatus> motion_;
  robotlink::Input<robotcontrol::RobotState> state_;
  std::optional<Filter> filter_;
  OdometryBuffer odometry_;
  std::vector<LandmarkMeasurement> landmarks_;
  std::vector<LineMeasurement> points_;
};

using ParticleFields = robotcontrol::FieldMonteCarloLocalisationParameters;
using ParticleOptions = FieldMonteCarlo::Options;
const robotlink::ParameterTable<ParticleOptions> kParticleTable{
    {ParticleFields::kParticlesFieldNumber, &ParticleOptions::particles, kAtLeastOne},
    {ParticleFields::kBearingDeviationFieldNumber, &ParticleOptions::bearingDeviation, kAboveZero},
    {ParticleFields::kDistanceDeviationFieldNumber, &ParticleOptions::distanceDeviation, kAboveZero},
    {ParticleFields::kLineDeviationFieldNumber, &ParticleOptions::lineDeviation, kAboveZero},
    {ParticleFields::kLineDeviationPerMetreFieldNumber, &ParticleOptions::lineDeviationPerMeter,
     kAtLeastZero},
    {ParticleFields::kLinePointsFieldNumber, &ParticleOptions::linePoints, kAtLeastZero},
    {ParticleFields::kLandmarkEvidenceFieldNumber, &ParticleOptions::landmarkEvidence, kShare},
    {ParticleFields::kLineEvidenceFieldNumber, &ParticleOptions::lineEvidence, kShare},
    {ParticleFields::kWalkNoiseFieldNumber, &ParticleOptions::walkNoise, kAtLeastZero},
    {ParticleFields::kTurnNoiseFieldNumber, &ParticleOptions::turnNoise, kAtLeastZero},
    {ParticleFields::kDriftNoiseFieldNumber, &ParticleOptions::driftNoise, kAtLeastZero},
    {ParticleFields::kRougheningFieldNumber, &ParticleOptions::roughening, kAtLeastZero},
    {ParticleFields::kGoodFitFieldNumber, &ParticleOptions::goodFit, kShare},
    {ParticleFields::kNewShareFieldNumber, &ParticleOptions::newShare, kShare},
    {ParticleFields::kProbeShareFieldNumber, &ParticleOptions::probeShare, kShare},
    {ParticleFields::kMemoryFieldNumber, &ParticleOptions::memory, kAtLeastZero}};

class FieldMonteCarloLocalization final : public FieldLocalization<FieldMonteCarlo> {
 public:
  explicit FieldMonteCarloLocalization(robotlink::SolutionContext& context)
      : FieldLocalization(context), parameters_(context.parameters<ParticleFields>()) {}

 private:
  FieldMonteCarlo::Options options() const override {
    FieldMonteCarlo::Options options = kParticleTable.read(parameters_);
    options.seed = static_cast<std::uint64_t>(std::max(0, parameters_.seed())) + 1;
    return options;
  }
  void draw(const FieldMonteCarlo& filter) override {
    if (debug_.on(kLandmarkFitKey)) debug_.plot(kLandmarkFitKey, filter.fit());
    if (!debug_.on(kLocatorParticlesKey)) return;
    auto drawing = debug_.fieldDrawing(kLocatorParticlesKey);
    for (const Pose2& particle : filter.particles()) drawing.dart(particle, robotlink::colors::kBlue, 0.08);
  }

  const ParticleFields& parameters_;
};

const robotlink::SolutionRegistration kFieldMonteCarlo =
    robotlink::SolutionBuilder<FieldMonteCarloLocalization>(
        "self-localisation", "field-monte-carlo",
        "A particle filter over dead reckoning, beacons, goals and lines; localizes globally, and again "
        "after the robot was carried away.")
        .source(
            "D. Fox, W. Burgard, F. Dellaert, S. Thrun: Monte Carlo localization, 1999; S. Lenser, M. "
            "Veloso: Sensor resetting localization, 2000; T. R\u00f6fer, M. J\u00fcngel: Vision-based fast "
            "and reactive Monte-Carlo localization, 2003.")
        .needs(robotlink::kLandmarkPercepts)
        .uses(robotlink::kFieldLines)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kRobotState)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorParticlesKey, &kLocatorPlotKey, &kFittedLinesKey, &kLandmarkFitKey})
        .parameters<ParticleFields>(kParticleTable.rules<ParticleFields>());

using KalmanFields = robotcontrol::KalmanLocalisationParameters;
using KalmanOptions = PoseKalmanFilter::Options;
const robotlink::ParameterTable<KalmanOptions> kPoseKalmanTable{
    {KalmanFields::kBearingDeviationFieldNumber, &KalmanOptions::bearingDeviation, kAboveZero},
    {KalmanFields::kDistanceDeviationFieldNumber, &KalmanOptions::distanceDeviation, kAboveZero},
    {KalmanFields::kLineDeviationFieldNumber, &KalmanOptions::lineDeviation, kAboveZero},
    {KalmanFields::kLineDeviationPerMetreFieldNumber, &KalmanOptions::lineDeviationPerMeter, kAtLeastZero},
    {KalmanFields::kLinePointsFieldNumber, &KalmanOptions::linePoints, kAtLeastZero},
    {KalmanFields::kEvidenceFieldNumber, &KalmanOptions::evidence, kEvidence},
    {KalmanFields::kWalkNoiseFieldNumber, &KalmanOptions::walkNoise, kAtLeastZero},
    {KalmanFields::kTurnNoiseFieldNumber, &KalmanOptions::turnNoise, kAtLeastZero},
    {KalmanFields::kDriftNoiseFieldNumber, &KalmanOptions::driftNoise, kAtLeastZero},
    {KalmanFields::kGateFieldNumber, &KalmanOptions::gate, kAboveZero},
    {KalmanFields::kNewWeightFieldNumber, &KalmanOptions::newWeight, kShare},
    {KalmanFields::kMinimumWeightFieldNumber, &KalmanOptions::minimumWeight, kShare},
    {KalmanFields::kMaximumHypothesesFieldNumber, &KalmanOptions::maximumHypotheses, kAtLeastOne},
    {KalmanFields::kMemoryFieldNumber, &KalmanOptions::memory, kAtLeastZero}};

class KalmanLocalization final : public FieldLocalization<PoseKalmanFilter> {
 public:
  explicit KalmanLocalization(robotlink::SolutionContext& context)
      : FieldLocalization(context), parameters_(context.parameters<KalmanFields>()) {}

 private:
  PoseKalmanFilter::Options options() const override { return kPoseKalmanTable.read(parameters_); }
  void draw(const PoseKalmanFilter& filter) override {
    const auto& all = filter.hypotheses();
    if (debug_.on(kHypothesisWeightKey)) {
      debug_.plot(kHypothesisWeightKey, "count", static_cast<double>(all.size()));
      debug_.plot(kHypothesisWeightKey, "weight", all.empty() ? 0 : all.front().weight);
    }
    if (!debug_.on(kHypothesesKey)) return;
    auto drawing = debug_.fieldDrawing(kHypothesesKey);
    for (const PoseKalmanFilter::Hypothesis& one : all) {
      const robotlink::Color color{{40, 90, 230}, 0.3 + 0.7 * one.weight};
      drawing.pose(one.pose, color);
      const Eigen::Matrix2d spread = one.covariance.topLeftCorner<2, 2>();
      const double angle = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
      const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
      drawing.ellipse(one.pose.translation(),
                      {2 * std::sqrt(std::max(0.0, along.dot(spread * along))),
                       2 * std::sqrt(std::max(0.0, across.dot(spread * across)))},
                      angle, color);
    }
  }

  const KalmanFields& parameters_;
};

const robotlink::SolutionRegistration kKalmanLocator =
    robotlink::SolutionBuilder<KalmanLocalization>(
        "self-localisation", "kalman",
        "An extended Kalman filter over dead reckoning, beacons, goals and lines, with several hypotheses.")
        .source("R. E. Kalman, 1960; M. Quinlan, R. Middleton: Multiple model Kalman filters, RoboCup 2009.")
        .needs(robotlink::kLandmarkPercepts)
        .uses(robotlink::kFieldLines)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kRobotState)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey, &kFittedLinesKey, &kHypothesesKey, &kHypothesisWeightKey})
        .parameters<KalmanFields>(kPoseKalmanTable.rules<KalmanFields>());

}  // namespace
}  // namespace modules
