// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Simulation.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/SimulationState.h"

namespace simcore {
namespace {

/// Separates the solver's random numbers from those of the sensors.
constexpr std::uint64_t kSolverStream = 0x736F6C766572;

/// Whether a model can be placed there: all is finite, and near enough to be computed with.
bool isPlace(const robotlink::Pose2& pose, const std::optional<ModelPosture>& posture) {
  if (!(std::abs(pose.x) < 1e4 && std::abs(pose.y) < 1e4 && std::isfinite(pose.heading))) return false;
  return !posture || (std::abs(posture->height.value_or(0)) < 1e4 && std::isfinite(posture->roll) &&
                      std::isfinite(posture->pitch));
}

/// The transform that moves a model from where it stands to a pose on the ground, tilted if it is to be.
Pose3 moveBetween(const Pose3& now, const robotlink::Pose2& pose,
                  const std::optional<ModelPosture>& posture) {
  const auto lift = [](const robotlink::Pose2& p) {
    return Pose3(Eigen::Translation3d(p.x, p.y, 0) * Eigen::AngleAxisd(p.heading, Vector3::UnitZ()));
  };
  if (!posture) return lift(pose) * lift(robotlink::groundPose(now)).inverse();
  Pose3 then = lift(pose) * Eigen::AngleAxisd(posture->pitch, Vector3::UnitY()) *
               Eigen::AngleAxisd(posture->roll, Vector3::UnitX());
  then.translation().z() = posture->height.value_or(now.translation().z());
  return then * now.inverse();
}

}  // namespace

Simulation::Simulation() = default;
Simulation::~Simulation() = default;

robotlink::Result<std::unique_ptr<Simulation>> Simulation::create(std::shared_ptr<const Scene> scene,
                                                                  SimulationOptions options) {
  std::unique_ptr<Simulation> simulation(new Simulation);
  simulation->implementation_ = std::make_unique<Implementation>(std::move(scene), options);
  if (auto fits = simulation->implementation_->checkPlaces(); !fits) return tl::unexpected(fits.error());
  simulation->startControllers();
  return simulation;
}

void Simulation::step() {
  before_.reset();
  control();
  Implementation& i = *implementation_;
  i.control.isDone = false;
  i.actuation->beforeStep(i.steps, {i.options.noise, i.options.seed});
  i.hands->beforeStep();
  i.physics->step(robotlink::hashBits(i.options.seed, kSolverStream, i.steps));
  ++i.steps;
  i.sensing->afterStep(i.noise());
  i.actuation->afterStep();
  i.countBallContacts();
  for (std::size_t r = 0; r < i.robots.size(); ++r) {
    i.obstacles[r].afterStep(i.physics->touchedObstacle(i.robots[r]));
  }
  i.readWheels();
  for (std::size_t d = 0; d < i.driveUnobstructed.size(); ++d) {
    if (i.physics->touchedObstacle(i.ports.driveModels[d])) i.driveUnobstructed[d] = false;
  }
  i.invalidate();
  i.recordPoses();
  i.doors->afterStep(i.steps, [&](const Door& door) { return i.readingFor(door); });
  i.keepForRewind();
}

std::uint64_t Simulation::steps() const {
  return implementation_->steps;
}

robotlink::Duration Simulation::time() const {
  return kStep * static_cast<std::int64_t>(implementation_->steps);
}

void Simulation::reset(std::uint64_t seed) {
  before_.reset();
  implementation_->options.seed = seed;
  implementation_->start();
  startControllers();
  implementation_->clearRewind();
}

const Scene& Simulation::scene() const {
  return *implementation_->scene;
}

std::shared_ptr<const Scene> Simulation::sharedScene() const {
  return implementation_->scene;
}

std::shared_ptr<const RenderScene> Simulation::renderScene() const {
  return implementation_->scene->contents().renderScene;
}

std::span<const Pose3> Simulation::bodyPoses() const {
  if (!implementation_->posesValid) implementation_->updatePoses();
  return implementation_->poses;
}

std::uint64_t Simulation::posesVersion() const {
  static_cast<void>(bodyPoses());
  return implementation_->posesVersion;
}

std::span<const Sensor> Simulation::sensors() const {
  if (!implementation_->readingsValid) implementation_->updateReadings();
  return implementation_->ports.sensors;
}

std::span<const CameraSensor> Simulation::cameras() const {
  return implementation_->ports.cameras;
}

std::span<const RangeSensor> Simulation::rangeSensors() const {
  return implementation_->ports.ranges;
}

void Simulation::measure(std::size_t rangeSensor, std::span<double> ranges) const {
  implementation_->measure(rangeSensor, ranges);
}

std::span<const Servo> Simulation::servos() const {
  return implementation_->ports.servos;
}

void Simulation::requestAngle(std::size_t servo, double angle) {
  implementation_->note(CommandKind::kAngle, servo, {angle});
  implementation_->actuation->command(servo, angle, implementation_->steps);
}

void Simulation::setTorqueLimit(std::size_t servo, double share) {
  if (std::isnan(share)) return;
  share = std::clamp(share, 0.0, 1.0);
  // Robots ask for it in each of their frames; what changes nothing need not be kept for rewinding.
  if (share == implementation_->actuation->torqueShare(servo)) return;
  implementation_->note(CommandKind::kTorqueLimit, servo, {share});
  implementation_->actuation->setTorqueShare(servo, share);
}

double Simulation::servoTorque(std::size_t servo) const {
  return implementation_->physics->torque(implementation_->ports.servoStates[servo].hinge);
}

std::span<const WheelDrive> Simulation::drives() const {
  return implementation_->ports.drives;
}

const WheelState& Simulation::wheelState(std::size_t drive) const {
  return implementation_->wheelStates[drive];
}

void Simulation::requestWheelSpeeds(std::size_t drive, double left, double right) {
  const double limit = implementation_->ports.drives[drive].maximumSpeed;
  if (std::isnan(left) || std::isnan(right)) return;
  implementation_->note(CommandKind::kWheelSpeeds, drive, {left, right});
  implementation_->driveUnobstructed[drive] = true;
  implementation_->physics->setRimSpeed(2 * drive, std::clamp(left, -limit, limit));
  implementation_->physics->setRimSpeed(2 * drive + 1, std::clamp(right, -limit, limit));
}

void Simulation::setDriveOn(std::size_t drive, bool on) {
  implementation_->note(CommandKind::kDriveOn, drive, {on ? 1.0 : 0.0});
  implementation_->physics->setSideOn(2 * drive, on);
  implementation_->physics->setSideOn(2 * drive + 1, on);
}

std::optional<Pose3> Simulation::modelPose(const std::string& model) const {
  const int index = implementation_->modelIndex(model);
  if (index < 0) return std::nullopt;
  return implementation_->physics->modelInWorld(index);
}

robotlink::Result<void> Simulation::placeModel(const std::string& model, const robotlink::Pose2& pose,
                                               const std::optional<ModelPosture>& posture) {
  Implementation& i = *implementation_;
  const int index = i.modelIndex(model);
  if (index < 0)
    return robotlink::failure("simulation.unknown-model", "there is no '" + model + "' here", {}, {model});
  if (auto free = i.checkFree(index); !free) return free;
  if (!isPlace(pose, posture)) {
    return robotlink::failure("simulation.place", "that place is too far away", {}, {model});
  }
  const ModelPosture tilt = posture.value_or(ModelPosture{});
  i.note(CommandKind::kPlace, posture ? (tilt.height ? 2 : 1) : 0,
         {pose.x, pose.y, pose.heading, tilt.height.value_or(0), tilt.roll, tilt.pitch}, model);
  return i.tryMove(index, moveBetween(i.physics->modelInWorld(index), pose, posture));
}

robotlink::Result<void> SimulationState::tryMove(int index, const Pose3& transform) {
  const auto before = physics->motionOf(index);
  physics->moveModel(index, transform);
  const int other = physics->overlappedModel(index, kMaxOverlap);
  // A model that stays continues as it moved.
  if (other >= 0) physics->setMotion(index, before);
  if (other < 0) sensing->forgetVelocitiesOf(index);
  invalidate();
  recordPoses();
  if (other < 0) return {};
  const std::string& name = world.models[static_cast<std::size_t>(index)].name;
  const std::string& otherName = world.models[static_cast<std::size_t>(other)].name;
  return robotlink::failure("simulation.place",
                            "'" + name + "' does not fit there: '" + otherName + "' is in the way", {},
                            {name, otherName});
}

const LeftOuts& Simulation::overlaps() const {
  return implementation_->overlaps;
}

std::vector<std::string> Simulation::modelsTouching(const std::string& model) const {
  std::vector<std::string> names;
  const int index = implementation_->modelIndex(model);
  if (index < 0) return names;
  for (const int other : implementation_->physics->modelsTouching(index))
    names.push_back(implementation_->world.models[static_cast<std::size_t>(other)].name);
  return names;
}

std::vector<std::string> Simulation::linksAtObstacles(const std::string& model) const {
  const Implementation& i = *implementation_;
  std::vector<std::string> names;
  const int index = i.modelIndex(model);
  if (index < 0) return names;
  const auto& links = i.world.models[static_cast<std::size_t>(index)].type->links;
  const std::size_t first = i.physics->bodiesOf(index).first;
  for (const ObstacleTouch& touch : i.physics->obstacleTouches()) {
    if (touch.body < first || touch.body - first >= links.size()) continue;
    if (i.world.models[static_cast<std::size_t>(touch.other)].type->isBall) continue;
    const std::string& name = links[touch.body - first].name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

double Simulation::heightInAir(const std::string& model) const {
  const Implementation& i = *implementation_;
  const int index = i.modelIndex(model);
  if (index < 0 || !i.physics->isMovedByForces(index) || i.physics->touchesAnything(index)) return 0;
  return i.physics->gapBelow(index);
}

std::uint64_t Simulation::ballContacts() const {
  return implementation_->ballContacts;
}

std::uint64_t Simulation::obstacleContacts(const std::string& robot) const {
  const TouchCount* touches = implementation_->obstaclesOf(robot);
  return touches != nullptr ? touches->count() : 0;
}

robotlink::Duration Simulation::obstacleContactTime(const std::string& robot) const {
  const TouchCount* touches = implementation_->obstaclesOf(robot);
  return kStep * static_cast<std::int64_t>(touches != nullptr ? touches->steps() : 0);
}

std::uint64_t Simulation::digest() const {
  const Implementation& i = *implementation_;
  return robotlink::mixBits(i.physics->digest() ^ i.steps ^ i.control.digest ^
                            i.control.controllers->digest());
}

}  // namespace simcore
