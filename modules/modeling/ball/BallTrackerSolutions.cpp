// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "ball-model" that tell a rolling ball from a resting one.
#include <algorithm>
#include <cmath>

#include "ModelingParameters.pb.h"
#include "modules/modeling/BallModeler.h"
#include "modules/modeling/ball/ParticleBall.h"
#include "modules/modeling/ball/RollingBallFilter.h"
#include "robotlink/debugging/ParameterTable.h"

namespace modules {
namespace {

using robotlink::kAboveZero;
using robotlink::kAtLeastOne;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::Pose2;

const robotlink::PlotKey kRollingKey{"ball-model/rolling",
                                     "The probability that the ball rolls, and its speed"};
const robotlink::RobotDrawingKey kBallParticlesKey{
    "ball-model/particles", "The particles of the filter, with velocities (drawn around the robot)"};

constexpr robotlink::ParameterRange kBallEvidence{0, 1, true};

template <typename Options>
struct BallOptions : Options {
  double minimumConfidence = 0.2;
  /// See PerceptBallModeler::absentImages().
  int absentImages = 10;
};

template <typename Options, auto Member>
double& rolls(Options& options) {
  return options.roll.*Member;
}

using RollingOptions = BallOptions<RollingBallFilter::Options>;
using RollingFields = robotcontrol::KalmanBallParameters;
const robotlink::ParameterTable<RollingOptions> kRollingTable{
    {RollingFields::kMemoryFieldNumber, &RollingOptions::memory, kAtLeastZero},
    {RollingFields::kMinimumConfidenceFieldNumber, &RollingOptions::minimumConfidence, kShare},
    {RollingFields::kAbsentImagesFieldNumber, &RollingOptions::absentImages, kAtLeastZero},
    {RollingFields::kDecelerationFieldNumber, rolls<RollingOptions, &RollingBall::deceleration>,
     kAtLeastZero},
    {RollingFields::kDampingFieldNumber, rolls<RollingOptions, &RollingBall::damping>, kAtLeastZero},
    {RollingFields::kAccelerationFieldNumber, &RollingOptions::acceleration, kAtLeastZero},
    {RollingFields::kDriftFieldNumber, &RollingOptions::drift, kAtLeastZero},
    {RollingFields::kStartRateFieldNumber, &RollingOptions::startRate, kAtLeastZero},
    {RollingFields::kStopRateFieldNumber, &RollingOptions::stopRate, kAtLeastZero},
    {RollingFields::kDeviationNearFieldNumber,
     +[](RollingOptions& o) -> double& { return o.accuracy.deviationNear; }, kAboveZero},
    {RollingFields::kDeviationPerMetreFieldNumber,
     +[](RollingOptions& o) -> double& { return o.accuracy.deviationPerMeter; }, kAtLeastZero},
    {RollingFields::kBearingDeviationFieldNumber,
     +[](RollingOptions& o) -> double& { return o.accuracy.bearingDeviation; }, kAtLeastZero},
    {RollingFields::kGateFieldNumber, &RollingOptions::gate, kAboveZero},
    {RollingFields::kOutliersToRestartFieldNumber, &RollingOptions::outliersToRestart, kAtLeastOne}};

class KalmanBall final : public PerceptBallModeler<RollingBallFilter> {
 public:
  explicit KalmanBall(robotlink::SolutionContext& context)
      : PerceptBallModeler(context, {}), parameters_(context.parameters<RollingFields>()) {}

 private:
  RollingBallFilter::Options options() const override { return kRollingTable.read(parameters_); }
  double minimumConfidence() const override { return kRollingTable.read(parameters_).minimumConfidence; }
  int absentImages() const override { return kRollingTable.read(parameters_).absentImages; }
  void drawMore(const RollingBallFilter& filter, const Pose2&) override {
    if (!debug_.on(kRollingKey)) return;
    debug_.plot(kRollingKey, "probability", filter.rolling());
    debug_.plot(kRollingKey, "speed", filter.estimate().velocity.norm(), "m/s");
  }

  const RollingFields& parameters_;
};

const robotlink::SolutionRegistration kKalmanBall =
    robotlink::SolutionBuilder<KalmanBall>(
        "ball-model", "kalman",
        "Two Kalman filters with velocity, for a resting and a rolling ball, weighted by how well they fit.")
        .source("H. Blom, Y. Bar-Shalom: The interacting multiple model algorithm, 1988.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kBallPositionKey, &kBallAgeKey, &kRollingKey})
        .parameters<RollingFields>(kRollingTable.rules<RollingFields>());

using BallParticleOptions = BallOptions<ParticleBall::Options>;
using BallParticleFields = robotcontrol::ParticleBallParameters;
const robotlink::ParameterTable<BallParticleOptions> kBallParticleTable{
    {BallParticleFields::kParticlesFieldNumber, &BallParticleOptions::particles, kAtLeastOne},
    {BallParticleFields::kMemoryFieldNumber, &BallParticleOptions::memory, kAtLeastZero},
    {BallParticleFields::kMinimumConfidenceFieldNumber, &BallParticleOptions::minimumConfidence, kShare},
    {BallParticleFields::kAbsentImagesFieldNumber, &BallParticleOptions::absentImages, kAtLeastZero},
    {BallParticleFields::kDecelerationFieldNumber, rolls<BallParticleOptions, &RollingBall::deceleration>,
     kAtLeastZero},
    {BallParticleFields::kDampingFieldNumber, rolls<BallParticleOptions, &RollingBall::damping>,
     kAtLeastZero},
    {BallParticleFields::kStartRateFieldNumber, &BallParticleOptions::startRate, kAtLeastZero},
    {BallParticleFields::kStopRateFieldNumber, &BallParticleOptions::stopRate, kAtLeastZero},
    {BallParticleFields::kStartSpeedFieldNumber, &BallParticleOptions::startSpeed, kAtLeastZero},
    {BallParticleFields::kVelocityNoiseFieldNumber, &BallParticleOptions::velocityNoise, kAtLeastZero},
    {BallParticleFields::kDriftFieldNumber, &BallParticleOptions::drift, kAtLeastZero},
    {BallParticleFields::kDeviationNearFieldNumber,
     +[](BallParticleOptions& o) -> double& { return o.accuracy.deviationNear; }, kAboveZero},
    {BallParticleFields::kDeviationPerMetreFieldNumber,
     +[](BallParticleOptions& o) -> double& { return o.accuracy.deviationPerMeter; }, kAtLeastZero},
    {BallParticleFields::kBearingDeviationFieldNumber,
     +[](BallParticleOptions& o) -> double& { return o.accuracy.bearingDeviation; }, kAtLeastZero},
    {BallParticleFields::kNewShareFieldNumber, &BallParticleOptions::newShare, kShare},
    {BallParticleFields::kEvidenceFieldNumber, &BallParticleOptions::evidence, kBallEvidence}};

class ParticleBallModeler final : public PerceptBallModeler<ParticleBall> {
 public:
  explicit ParticleBallModeler(robotlink::SolutionContext& context)
      : PerceptBallModeler(context, seeded(context.parameters<BallParticleFields>())),
        parameters_(context.parameters<BallParticleFields>()) {}

 private:
  static ParticleBall::Options seeded(const BallParticleFields& parameters) {
    ParticleBall::Options options = kBallParticleTable.read(parameters);
    options.seed = static_cast<std::uint64_t>(std::max(0, parameters.seed())) + 1;
    return options;
  }
  ParticleBall::Options options() const override { return kBallParticleTable.read(parameters_); }
  double minimumConfidence() const override { return kBallParticleTable.read(parameters_).minimumConfidence; }
  int absentImages() const override { return kBallParticleTable.read(parameters_).absentImages; }
  void drawMore(const ParticleBall& filter, const Pose2& robotInOdometry) override {
    if (!debug_.on(kBallParticlesKey)) return;
    auto drawing = debug_.robotDrawing(kBallParticlesKey);
    const Pose2 odometryInRobot = robotInOdometry.inverse();
    for (const ParticleBall::Particle& particle : filter.particles()) {
      const robotlink::Vector2 place = odometryInRobot * particle.position;
      drawing.dot(place, robotlink::colors::kOrange, 0.015);
      if (!particle.velocity.isZero())
        drawing.line(place, place + 0.3 * (Pose2{0, 0, odometryInRobot.heading} * particle.velocity),
                     robotlink::colors::kOrange);
    }
  }

  const BallParticleFields& parameters_;
};

const robotlink::SolutionRegistration kParticleBall =
    robotlink::SolutionBuilder<ParticleBallModeler>(
        "ball-model", "particle",
        "A particle filter over position and velocity of the ball; each particle rests or rolls.")
        .source("C. Kwok, D. Fox: Map-based multiple model tracking of a moving object, RoboCup 2004.")
        .needs(robotlink::kBallPercept)
        .uses(robotlink::kMotionStatus)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kBallModel)
        .keys({&kBallKey, &kBallPositionKey, &kBallAgeKey, &kBallParticlesKey})
        .parameters<BallParticleFields>(kBallParticleTable.rules<BallParticleFields>());

}  // namespace
}  // namespace modules
