// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Simulation.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/physics/Physics.h"
#include "simcore/physics/Ports.h"
#include "simcore/physics/Sensing.h"
#include "simcore/ranging/RangeSensing.h"

namespace simcore {
namespace {

// The fraction of the remaining angle that a servo tries to turn in one step; with 1 it would overshoot.
constexpr double kServoGain = 0.4;
// Solids that rest on each other overlap a little; a deeper overlap means an impossible pose.
constexpr double kMaxOverlap = 0.003;

/// Counts touches; touches less than kMoment steps apart count as one.
class TouchCount {
 public:
  void afterStep(bool touches) {
    if (touches && stepsSince_ > kMoment) ++count_;
    stepsSince_ = touches ? 0 : stepsSince_ + 1;
    if (touches) ++steps_;
  }
  std::uint64_t count() const { return count_; }
  std::uint64_t steps() const { return steps_; }

 private:
  static constexpr std::uint64_t kMoment = 25;
  std::uint64_t stepsSince_ = kMoment + 1, count_ = 0, steps_ = 0;
};

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

struct Simulation::Implementation {
  std::shared_ptr<const Scene> scene;
  SimulationOptions options;
  const WorldDescription& world;
  Ports ports;
  std::unique_ptr<Physics> physics;
  std::optional<Sensing> sensing;
  // Null if there is nothing to measure.
  std::unique_ptr<RangeSensing> ranging;
  std::uint64_t steps = 0;
  // Keyed by body of the render scene.
  std::vector<Pose3> poses;
  // Indices of models.
  std::vector<int> balls, robots;
  std::uint64_t ballContacts = 0;
  // Keyed by robot, in the last step.
  std::vector<bool> touchedBall;
  // Keyed by robot.
  std::vector<TouchCount> obstacles;
  LeftOuts overlaps;
  // Keyed by drive.
  std::vector<WheelState> wheelStates;
  bool readingsValid = false, posesValid = false, rangingValid = false;

  Implementation(std::shared_ptr<const Scene> ofScene, SimulationOptions with)
      : scene(std::move(ofScene)), options(with), world(scene->contents().world), ports(Ports::of(world)) {
    for (std::size_t i = 0; i < world.models.size(); ++i) {
      if (world.models[i].type->isBall) balls.push_back(static_cast<int>(i));
      if (!world.models[i].type->robot.empty()) robots.push_back(static_cast<int>(i));
    }
    if (!ports.ranges.empty()) {
      ranging =
          std::make_unique<RangeSensing>(scene->contents().renderScene, ports.ranges, ports.rangeOwners);
    }
    start();
  }

  void start() {
    physics = std::make_unique<Physics>(
        world, options.kinematic ? Physics::Drives::kKinematic : Physics::Drives::kDynamic);
    sensing.emplace(*physics, ports.sources, world.gravity);
    const Ports fresh = Ports::of(world);
    ports.servoStates = fresh.servoStates;
    steps = 0;
    poses.assign(physics->bodyCount() + 1, Pose3::Identity());
    ballContacts = 0;
    touchedBall.assign(robots.size(), false);
    obstacles.assign(robots.size(), {});
    wheelStates.assign(ports.drives.size(), {});
    invalidate();
  }

  void invalidate() { readingsValid = posesValid = rangingValid = false; }

  void driveServos() {
    for (std::size_t i = 0; i < ports.servos.size(); ++i) {
      const ServoState& state = ports.servoStates[i];
      const Servo& servo = ports.servos[i];
      const double missing = state.target - physics->angle(state.hinge);
      const double speed =
          std::clamp(kServoGain * missing / kStepSeconds, -servo.maximumSpeed, servo.maximumSpeed);
      physics->setMotor(state.hinge, speed, servo.maximumTorque * state.torqueShare);
    }
  }

  void countBallContacts() {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const bool touches =
          std::ranges::any_of(balls, [&](int ball) { return physics->touched(robots[i], ball); });
      if (touches && !touchedBall[i]) ++ballContacts;
      touchedBall[i] = touches;
    }
  }

  void readWheels() {
    for (std::size_t i = 0; i < wheelStates.size(); ++i) {
      const Physics::SideState left = physics->sideState(2 * i), right = physics->sideState(2 * i + 1);
      wheelStates[i] = {left.travel, right.travel, left.speed, right.speed, left.blocked, right.blocked};
    }
  }

  void updateReadings() {
    sensing->read({options.noise, options.seed, steps}, ports.sensors);
    readingsValid = true;
  }

  void updatePoses() {
    for (std::size_t i = 0; i < physics->bodyCount(); ++i) poses[i + 1] = physics->linkInWorld(i);
    posesValid = true;
  }

  const TouchCount* obstaclesOf(const std::string& robot) const {
    for (std::size_t r = 0; r < robots.size(); ++r) {
      if (world.models[static_cast<std::size_t>(robots[r])].name == robot) return &obstacles[r];
    }
    return nullptr;
  }

  void measure(std::size_t sensor, std::span<double> ranges) {
    if (!posesValid) updatePoses();
    if (!rangingValid) ranging->setPoses(poses);
    rangingValid = true;
    ranging->measure(sensor, {options.noise, options.seed, steps}, ranges);
  }

  int modelIndex(const std::string& name) const {
    const auto found = std::ranges::find(world.models, name, &ModelInstance::name);
    return found == world.models.end() ? -1 : static_cast<int>(found - world.models.begin());
  }
};

Simulation::Simulation() = default;
Simulation::~Simulation() = default;

robotlink::Result<std::unique_ptr<Simulation>> Simulation::create(std::shared_ptr<const Scene> scene,
                                                                  SimulationOptions options) {
  std::unique_ptr<Simulation> simulation(new Simulation);
  simulation->implementation_ = std::make_unique<Implementation>(std::move(scene), options);
  const Implementation& made = *simulation->implementation_;
  const auto isOurs = [](const ModelInstance& model) {
    return !model.type->robot.empty() || model.type->isBall;
  };
  for (std::size_t i = 0; i < made.world.models.size(); ++i) {
    const int other = made.physics->overlappedModel(static_cast<int>(i), kMaxOverlap);
    if (other < 0) continue;
    const ModelInstance& model = made.world.models[i];
    const ModelInstance& otherModel = made.world.models[static_cast<std::size_t>(other)];
    const std::string text = "'" + model.name + "' starts inside '" + otherModel.name + "'";
    if (isOurs(model) || isOurs(otherModel)) {
      return robotlink::failure("scene.overlap", text + ": move one of them", model.where,
                                {model.name, otherModel.name});
    }
    leaveOut(simulation->implementation_->overlaps,
             {model.where, model.name, text, "they push each other apart"});
  }
  return simulation;
}

void Simulation::step() {
  Implementation& i = *implementation_;
  i.driveServos();
  i.physics->step(robotlink::hashBits(i.options.seed, kSolverStream, i.steps));
  ++i.steps;
  i.sensing->afterStep();
  i.countBallContacts();
  for (std::size_t r = 0; r < i.robots.size(); ++r) {
    i.obstacles[r].afterStep(i.physics->touchedObstacle(i.robots[r]));
  }
  i.readWheels();
  i.invalidate();
}

std::uint64_t Simulation::steps() const {
  return implementation_->steps;
}

robotlink::Duration Simulation::time() const {
  return kStep * static_cast<std::int64_t>(implementation_->steps);
}

void Simulation::reset(std::uint64_t seed) {
  implementation_->options.seed = seed;
  implementation_->start();
}

const Scene& Simulation::scene() const {
  return *implementation_->scene;
}

std::shared_ptr<const RenderScene> Simulation::renderScene() const {
  return implementation_->scene->contents().renderScene;
}

std::span<const Pose3> Simulation::bodyPoses() const {
  if (!implementation_->posesValid) implementation_->updatePoses();
  return implementation_->poses;
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
  const Servo& limits = implementation_->ports.servos[servo];
  if (std::isnan(angle)) return;
  implementation_->ports.servoStates[servo].target = std::clamp(angle, limits.minimum, limits.maximum);
}

void Simulation::setTorqueLimit(std::size_t servo, double share) {
  if (std::isnan(share)) return;
  implementation_->ports.servoStates[servo].torqueShare = std::clamp(share, 0.0, 1.0);
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
  implementation_->physics->setRimSpeed(2 * drive, std::clamp(left, -limit, limit));
  implementation_->physics->setRimSpeed(2 * drive + 1, std::clamp(right, -limit, limit));
}

void Simulation::setDriveOn(std::size_t drive, bool on) {
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
  if (i.world.models[static_cast<std::size_t>(index)].type->isStatic) {
    return robotlink::failure("simulation.static-model", "'" + model + "' is fixed", {}, {model});
  }
  if (!isPlace(pose, posture)) {
    return robotlink::failure("simulation.place", "that place is too far away", {}, {model});
  }
  const auto before = i.physics->motionOf(index);
  i.physics->moveModel(index, moveBetween(i.physics->modelInWorld(index), pose, posture));
  const int other = i.physics->overlappedModel(index, kMaxOverlap);
  // A model that stays goes on as it moved.
  if (other >= 0) i.physics->setMotion(index, before);
  if (other < 0) i.sensing->forgetVelocitiesOf(index);
  i.invalidate();
  if (other < 0) return {};
  const std::string& otherName = i.world.models[static_cast<std::size_t>(other)].name;
  return robotlink::failure("simulation.place",
                            "'" + model + "' does not fit there: '" + otherName + "' is in the way", {},
                            {model, otherName});
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
  return robotlink::mixBits(implementation_->physics->digest() ^ implementation_->steps);
}

}  // namespace simcore
