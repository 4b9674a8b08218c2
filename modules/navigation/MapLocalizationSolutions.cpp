// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "self-localisation" of robots on wheels: the robot's pose in its map.
#include <algorithm>
#include <cmath>
#include <optional>

#include "NavigationParameters.pb.h"
#include "foxglove/Ranging.pb.h"
#include "modules/FinitePose.h"
#include "modules/modeling/SelfLocalization.h"
#include "modules/navigation/MonteCarloLocalizer.h"
#include "modules/navigation/OdometryHistory.h"
#include "modules/navigation/RangePackages.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/ParameterTable.h"

namespace modules {
namespace {

using robotlink::FieldDrawingKey;
using robotlink::Instant;
using robotlink::Level;
using robotlink::PlotKey;
using robotlink::Pose2;
using robotlink::Vector2;

const FieldDrawingKey kRaysKey{"self-localisation/rays",
                               "Measurements, as seen from the robot's estimated pose (drawn on the field)"};
const PlotKey kFilterKey{
    "self-localisation/filter",
    "Fraction of the measurements that the pose explains, and the number of particles (plots)"};

/// The limit of drawn particles.
constexpr std::size_t kMaxDrawn = 1000;
/// The estimate without a map: completely uncertain.
constexpr PoseEstimate kNowhere{{}, 1e3, robotlink::kPi};

using robotlink::kAboveZero;
using robotlink::kAtLeastOne;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::ParameterRange;

struct LocalizationOptions : MonteCarloLocalizer::Options {
  /// Time without a scan of the laser after which the sonars are used, s.
  double sonarAfter = 1.0;
};

/// Without any chance of surprises, a measurement could exclude every particle.
constexpr ParameterRange kRandomShare{0, 1, true};
constexpr ParameterRange kFit{0, 1, true};

using FilterFields = robotcontrol::MonteCarloLocalisationParameters;
const robotlink::ParameterTable<LocalizationOptions> kMonteCarloTable{
    {FilterFields::kParticlesPerAreaFieldNumber, &LocalizationOptions::particlesPerArea, kAtLeastZero},
    {FilterFields::kFewestParticlesFieldNumber, &LocalizationOptions::fewest, kAtLeastOne},
    {FilterFields::kMostParticlesFieldNumber, &LocalizationOptions::most, kAtLeastOne},
    {FilterFields::kRaysFieldNumber, +[](LocalizationOptions& o) -> int& { return o.ranges.rays; },
     kAtLeastOne},
    {FilterFields::kEvidenceFieldNumber, +[](LocalizationOptions& o) -> double& { return o.ranges.evidence; },
     kAtLeastZero},
    {FilterFields::kRayDeviationFieldNumber, &LocalizationOptions::rayDeviation, kAboveZero},
    {FilterFields::kStartDeviationFieldNumber, &LocalizationOptions::startDeviation, kAboveZero},
    {FilterFields::kSonarDeviationFieldNumber,
     +[](LocalizationOptions& o) -> double& { return o.ranges.sonarDeviation; }, kAboveZero},
    {FilterFields::kRandomShareFieldNumber,
     +[](LocalizationOptions& o) -> double& { return o.ranges.randomShare; }, kRandomShare},
    {FilterFields::kWayNoiseFieldNumber, &LocalizationOptions::wayNoise, kAtLeastZero},
    {FilterFields::kSkidNoiseFieldNumber, &LocalizationOptions::skidNoise, kAtLeastZero},
    {FilterFields::kTurnNoiseFieldNumber, &LocalizationOptions::turnNoise, kAtLeastZero},
    {FilterFields::kDriftNoiseFieldNumber, &LocalizationOptions::driftNoise, kAtLeastZero},
    {FilterFields::kLeastWayFieldNumber, &LocalizationOptions::leastWay, kAtLeastZero},
    {FilterFields::kLeastTurnFieldNumber, &LocalizationOptions::leastTurn, kAtLeastZero},
    {FilterFields::kGoodFitFieldNumber, &LocalizationOptions::goodFit, kFit},
    {FilterFields::kNewShareFieldNumber, &LocalizationOptions::newShare, kShare},
    {FilterFields::kLostAfterFieldNumber, &LocalizationOptions::lostAfter, kAtLeastZero},
    {FilterFields::kSonarAfterFieldNumber, &LocalizationOptions::sonarAfter, kAtLeastZero}};

/// The growth of the standard deviations, m a meter and rad a radian.
struct WheelDrift {
  double perMeter = 0.05, perRadian = 0.03;
};

using DriftFields = robotcontrol::WheelOdometryParameters;
const robotlink::ParameterTable<WheelDrift> kWheelDriftTable{
    {DriftFields::kDriftPerMetreFieldNumber, &WheelDrift::perMeter, kAtLeastZero},
    {DriftFields::kDriftPerRadianFieldNumber, &WheelDrift::perRadian, kAtLeastZero}};

class MonteCarloLocalization final : public SelfLocalization {
 public:
  explicit MonteCarloLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context),
        parameters_(context.parameters<robotcontrol::MonteCarloLocalisationParameters>()),
        laserMaximum_(context.robot().description.laser ? context.robot().description.laser->maximum : 32),
        map_(context.robot().map),
        drive_(context.input(robotlink::kDriveState)),
        sonar_(context.input(robotlink::kSonar)),
        laser_(context.input(robotlink::kLaser)) {
    if (map_ != nullptr) start();
  }

  void execute() override {
    if (!drive_ || (!drive_.isNew() && !sonar_.isNew() && !laser_.isNew())) return;
    if (!localizer_) {
      if (!warned_)
        debug_.text(Level::kWarning, "self-localisation",
                    "there is no map for localization: open one, or choose the solution wheel-odometry");
      warned_ = true;
      return publish(kNowhere, drive_->timestamp());
    }
    localizer_->setOptions(options());
    takeStep();
    const std::vector<RangeBeam> beams = measured();
    localizer_->see(beams);
    publish(localizer_->estimate(), drive_->timestamp());
    draw(beams);
  }

 private:
  void start() {
    localizer_.emplace(*map_, options());
    const robotlink::GroundMap::Place* home = map_->find(robotlink::GroundMap::Place::Kind::kHome);
    if (parameters_.start_at_home() && home != nullptr) localizer_->startAt(home->pose, 0.5, 0.3);
    if (localizer_->freeSpace().empty())
      debug_.text(Level::kWarning, "self-localisation",
                  "the map has no place where the robot fits: is it the right one?");
  }

  void takeStep() {
    const Pose2 odometry = robotlink::pose2(drive_->odometry());
    if (!drive_.isNew() || !isFinite(odometry)) return;
    const std::optional<Pose2> last = odometry_.latest();
    const bool continued = odometry_.add(robotlink::instant(drive_->timestamp()), odometry);
    // After a reset of the odometry, the motion in between is unknown, but small.
    if (last && continued) localizer_->move(last->inverse() * odometry);
  }

  /// New measurements, relative to the robot's present pose.
  std::vector<RangeBeam> measured() {
    std::vector<RangeBeam> result;
    if (laser_ && laser_.isNew()) {
      result = beams(*laser_, laserMaximum_);
      laserSeenAt_ = robotlink::instant(laser_->timestamp());
    }
    const double waited =
        laserSeenAt_ ? robotlink::seconds(robotlink::instant(drive_->timestamp()) - *laserSeenAt_) : 1e9;
    if (sonar_ && sonar_.isNew() && std::abs(waited) > options().sonarAfter) {
      const std::vector<RangeBeam> cones = beams(*sonar_);
      result.insert(result.end(), cones.begin(), cones.end());
    }
    const std::optional<Pose2> now = odometry_.latest();
    std::erase_if(result, [&](RangeBeam& beam) {
      const std::optional<Pose2> then = odometry_.at(beam.time);
      if (!now || !then) return true;
      beam.sensorInRobot = now->inverse() * *then * beam.sensorInRobot;
      return false;
    });
    return result;
  }

  LocalizationOptions options() const {
    LocalizationOptions options = kMonteCarloTable.read(parameters_);
    options.startDeviation = std::max(options.startDeviation, options.rayDeviation);
    options.seed = static_cast<std::uint64_t>(std::max(0, parameters_.seed())) + 1;
    return options;
  }

  void draw(const std::vector<RangeBeam>& seen) {
    if (debug_.on(kLocatorParticlesKey)) {
      auto drawing = debug_.fieldDrawing(kLocatorParticlesKey);
      const std::span<const Particle> all = localizer_->particles();
      const std::size_t count = std::min(all.size(), kMaxDrawn);
      for (std::size_t i = 0; i < count; ++i)
        drawing.dart(all[i * all.size() / count].pose(), robotlink::colors::kBlue, 0.2);
    }
    if (debug_.on(kRaysKey)) {
      auto drawing = debug_.fieldDrawing(kRaysKey);
      const Pose2 robot = localizer_->estimate().robotInField;
      for (const RangeBeam& beam : seen)
        if (beam.hit()) drawing.dot(robot * beam.endInRobot(), robotlink::colors::kRed, 0.06);
    }
    if (debug_.on(kFilterKey)) {
      debug_.plot(kFilterKey, "fit", localizer_->fit());
      debug_.plot(kFilterKey, "particles", static_cast<double>(localizer_->particles().size()));
    }
  }

  const robotcontrol::MonteCarloLocalisationParameters& parameters_;
  double laserMaximum_;
  std::shared_ptr<const robotlink::GroundMap> map_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  robotlink::Input<robotcontrol::SonarReadings> sonar_;
  robotlink::Input<foxglove::LaserScan> laser_;
  std::optional<MonteCarloLocalizer> localizer_;
  OdometryHistory odometry_;
  std::optional<Instant> laserSeenAt_;
  bool warned_ = false;
};

const robotlink::SolutionRegistration kMonteCarlo =
    robotlink::SolutionBuilder<MonteCarloLocalization>(
        "self-localisation", "monte-carlo",
        "A particle filter over odometry and laser or sonar readings on the map; localizes globally.")
        .source(
            "F. Dellaert, D. Fox, W. Burgard, S. Thrun: Monte Carlo localization for mobile robots, 1999; D. "
            "Fox: Adapting the sample size in particle filters through KLD-sampling, 2003.")
        .needs(robotlink::kDriveState)
        .uses(robotlink::kSonar)
        .uses(robotlink::kLaser)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorParticlesKey, &kLocatorPlotKey, &kRaysKey, &kFilterKey})
        .parameters<robotcontrol::MonteCarloLocalisationParameters>(
            kMonteCarloTable.rules<robotcontrol::MonteCarloLocalisationParameters>());

class WheelLocalization final : public SelfLocalization {
 public:
  explicit WheelLocalization(robotlink::SolutionContext& context)
      : SelfLocalization(context),
        parameters_(context.parameters<robotcontrol::WheelOdometryParameters>()),
        drive_(context.input(robotlink::kDriveState)) {
    const auto map = context.robot().map;
    const auto* home = map ? map->find(robotlink::GroundMap::Place::Kind::kHome) : nullptr;
    if (home != nullptr)
      home_ = home->pose;
    else
      debug_.text(Level::kWarning, "self-localisation",
                  "there is no map with a home to start from: the robot is assumed to have started at 0, 0");
  }

  void execute() override {
    if (!drive_ || !drive_.isNew()) return;
    const Pose2 now = robotlink::pose2(drive_->odometry());
    if (!isFinite(now)) return;
    const Pose2 step = last_.inverse() * now;
    last_ = now;
    way_ += std::hypot(step.x, step.y);
    turn_ += std::abs(step.heading);
    PoseEstimate estimate;
    estimate.robotInField = home_ * now;
    const WheelDrift drift = kWheelDriftTable.read(parameters_);
    estimate.headingDeviation = drift.perRadian * turn_;
    estimate.positionDeviation = drift.perMeter * way_ + 0.5 * way_ * estimate.headingDeviation;
    publish(estimate, drive_->timestamp());
  }

 private:
  const robotcontrol::WheelOdometryParameters& parameters_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  Pose2 home_, last_;
  double way_ = 0, turn_ = 0;
};

const robotlink::SolutionRegistration kWheels =
    robotlink::SolutionBuilder<WheelLocalization>(
        "self-localisation", "wheel-odometry",
        "Dead reckoning from the wheels, starting at the home of the map; its error only grows.")
        .source("Dead reckoning: S. Thrun, W. Burgard, D. Fox: Probabilistic Robotics, 2005, chapter 5.")
        .needs(robotlink::kDriveState)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey})
        .parameters<robotcontrol::WheelOdometryParameters>(
            kWheelDriftTable.rules<robotcontrol::WheelOdometryParameters>());

}  // namespace
}  // namespace modules
