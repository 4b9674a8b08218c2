// SPDX-License-Identifier: GPL-3.0-or-later
// The private state of a Simulation; only for its sources.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/PortList.h"
#include "simcore/Rewind.h"
#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/control/ControlState.h"
#include "simcore/devices/Actuation.h"
#include "simcore/devices/Doors.h"
#include "simcore/devices/Hands.h"
#include "simcore/devices/Ports.h"
#include "simcore/devices/PoseHistory.h"
#include "simcore/devices/Sensing.h"
#include "simcore/noise/SampleClock.h"
#include "simcore/physics/Physics.h"
#include "simcore/physics/Step.h"
#include "simcore/ranging/ImageSensing.h"
#include "simcore/ranging/MeasureAhead.h"
#include "simcore/ranging/RangeSensing.h"
#include "simcore/rendering/CameraOptics.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/world/Continuation.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Port.h"
#include "simcore/world/SimulationOptions.h"

namespace simcore {

class StateStream;

/// Counts touches; touches less than kMoment steps apart count as one.
class TouchCount {
 public:
  void afterStep(bool touches) {
    ++stepsSince_;
    if (!touches) return;
    if (stepsSince_ >= kMoment) ++count_;
    stepsSince_ = 0;
    ++steps_;
  }
  std::uint64_t count() const { return count_; }
  std::uint64_t steps() const { return steps_; }
  void transfer(StateStream& stream);

 private:
  static constexpr std::uint64_t kMoment = 25;
  /// The steps since the last touch, if there was one.
  std::uint64_t stepsSince_ = kMoment, count_ = 0, steps_ = 0;
};

/// The timing of a sensor that measures on demand.
struct TimedSensor {
  SensorErrors errors;
  std::optional<SampleClock> clock;
  std::uint64_t stream = 0;
  /// Whether a user chose the errors, instead of the scene.
  bool chosen = false;

  TimedSensor(const SensorErrors& of, const std::string& path) : stream(hashOfPath(path)) { set(of); }
  void set(const SensorErrors& of) {
    errors = of;
    // The poses of the last second are remembered, so that it cannot measure less often.
    if (of.rate > 0) errors.rate = std::max(of.rate, 1.0);
    clock.reset();
    if (of.hasTiming()) clock.emplace(errors, stream, kStepSeconds);
  }
};

struct ModelMotion {
  /// The model that moves so.
  ModelInstance model;
  std::vector<Physics::BodyMotion> bodies;
};

/// Solids that rest on each other overlap a little, m; a deeper overlap means an impossible pose.
inline constexpr double kMaxOverlap = 0.003;

/// Everything that a simulation consists of. One thread at a time.
struct SimulationState {
  std::shared_ptr<const Scene> scene;
  SimulationOptions options;
  const WorldDescription& world;
  Ports ports;
  std::unique_ptr<Physics> physics;
  std::optional<Sensing> sensing;
  std::optional<Actuation> actuation;
  std::optional<Doors> doors;
  std::optional<Hands> hands;
  /// Null unless one may go back.
  std::unique_ptr<Rewind> rewind;
  /// Whether commands are those of before, on the way to an earlier step.
  bool isRepeating = false;
  /// Whether the forces of contacts are measured; a reset keeps it.
  bool readsForces = false;
  // Null if there is nothing to measure.
  std::unique_ptr<RangeSensing> ranging;
  std::unique_ptr<ImageSensing> imaging;
  /// The image sensing of threads other than the caller's; it has the same noise.
  std::vector<std::unique_ptr<ImageSensing>> otherImaging;
  std::optional<MeasureAhead<double>> rangesAhead;
  std::optional<MeasureAhead<float>> imagesAhead;
  /// Renders what cameras truly see; made when it is needed first.
  std::unique_ptr<CameraRenderer> truth;
  // The means of rendering images that no other owner renders, created on first use; keyed by camera.
  std::unique_ptr<CameraRenderer> renderer;
  std::vector<CameraOptics> optics;
  robotlink::Image cameraImage;
  // Keyed by range sensor, image sensor and camera.
  std::vector<TimedSensor> rangeTiming, imageTiming, cameraTiming;
  PoseHistory history;
  ControlState control;
  // Perfect sensors, made when they are needed first; and what they measure.
  std::vector<RangeSensor> trueRangeSensors;
  std::unique_ptr<RangeSensing> trueRanging;
  std::unique_ptr<ImageSensing> trueImaging;
  // The ports of devices and of the truth; the index of each path.
  std::vector<Port> allPorts;
  std::map<std::string, std::size_t> portsByPath;
  // Keyed by drive: whether nothing was touched since the last command.
  std::vector<bool> driveUnobstructed;
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
  // The overlaps at the start.
  LeftOuts overlaps;
  // Keyed by drive.
  std::vector<WheelState> wheelStates;
  /// How often the poses were updated.
  std::uint64_t posesVersion = 0;
  bool readingsValid = false, posesValid = false, rangingValid = false, imagingValid = false;
  // The steps whose poses ranging and imaging have.
  std::uint64_t rangingStep = 0, imagingStep = 0;
  // Errors of sensors that a user chose, by index.
  std::map<std::size_t, SensorErrors> chosenErrors;

  SimulationState(std::shared_ptr<const Scene> ofScene, SimulationOptions with)
      : scene(std::move(ofScene)), options(with), world(scene->contents().world), ports(Ports::of(world)) {
    for (std::size_t i = 0; i < world.models.size(); ++i) {
      if (world.models[i].type->isBall) balls.push_back(static_cast<int>(i));
      if (!world.models[i].type->robot.empty()) robots.push_back(static_cast<int>(i));
    }
    if (!ports.ranges.empty()) {
      ranging =
          std::make_unique<RangeSensing>(scene->contents().renderScene, ports.ranges, ports.rangeOwners);
    }
    if (!ports.images.empty()) {
      imaging =
          std::make_unique<ImageSensing>(scene->contents().renderScene, ports.images, ports.imageOwners);
    }
    for (const RangeSensor& sensor : ports.ranges) rangeTiming.emplace_back(sensor.errors, sensor.info.path);
    for (const ImageSensor& sensor : ports.images) imageTiming.emplace_back(sensor.errors, sensor.info.path);
    for (const CameraSensor& camera : ports.cameras)
      cameraTiming.emplace_back(camera.errors, camera.info.path);
    prepareToMeasureAhead();
    for (const auto* sensors : {&rangeTiming, &imageTiming, &cameraTiming}) {
      for (const TimedSensor& sensor : *sensors) remember(sensor.errors);
    }
    for (const CameraSensor& camera : ports.cameras) remember(camera.errors, camera.shutter);
    allPorts = portsOf(ports, world);
    for (std::size_t i = 0; i < allPorts.size(); ++i) portsByPath.emplace(allPorts[i].info.path, i);
    start();
  }

  // Controllers (SimulationControl.cpp).
  void addOutputPorts();
  /// Fills in what the ray of an event hits now.
  void pick(ViewEvent& event);
  robotlink::Result<std::vector<double>> readOutput(std::size_t index) const;
  /// Writes what controllers remember, or reads it for Simulation::resumeControllers().
  void transferControl(StateStream& stream);
  /// Has controllers continue as those of another simulation do.
  void takeOverControl(const SimulationState& before);

  /// The smallest number that the sensor of a door reads now.
  double readingFor(const Door& door);

  // The ground truth for the oracle.
  std::vector<double> truthOf(const Port& port) const;
  std::vector<double> trueRanges(std::size_t sensor);
  std::vector<double> trueImage(std::size_t sensor);

  /// Has the history reach back as far as a sensor needs it.
  void remember(const SensorErrors& errors, const ShutterModel& shutter = {}) {
    if (!errors.hasTiming() && !shutter.any()) return;
    // The number of samples in a row that may be lost before an older one than the newest remembered counts.
    const double samples = 1 + 20 * errors.dropout;
    const double period = std::max(kStepSeconds, errors.rate > 0 ? 1 / errors.rate : 0);
    const double back = errors.delay + samples * period + shutter.exposure + shutter.readout;
    history.reachBack(static_cast<std::size_t>(
        std::min<double>(back / kStepSeconds + 2, static_cast<double>(PoseHistory::kMaxSteps))));
  }

  void start() {
    physics = std::make_unique<Physics>(
        world, options.kinematic ? Physics::Drives::kKinematic : Physics::Drives::kDynamic, options.pool);
    sensing.emplace(*physics, ports.sources, world);
    actuation.emplace(*physics, ports);
    doors.emplace(ports, *actuation);
    hands.emplace(*physics, world);
    physics->readContacts(readsForces);
    steps = 0;
    history.clear();
    rangesAhead->restart();
    imagesAhead->restart();
    driveUnobstructed.assign(ports.drives.size(), true);
    poses.assign(physics->bodyCount() + 1, Pose3::Identity());
    ballContacts = 0;
    touchedBall.assign(robots.size(), false);
    obstacles.assign(robots.size(), {});
    wheelStates.assign(ports.drives.size(), {});
    // Errors that a user chose outlive a reset.
    for (const auto& [sensor, errors] : chosenErrors) sensing->setErrors(sensor, errors, noise());
    sensing->afterStep(noise());
    invalidate();
    recordPoses();
  }

  NoiseSelection noise() const { return {options.noise, options.seed, steps}; }

  void invalidate() {
    readingsValid = posesValid = rangingValid = imagingValid = false;
    rangesAhead->forget();
    imagesAhead->forget();
  }

  void recordPoses() {
    if (!history.isWanted()) return;
    if (!posesValid) updatePoses();
    history.add(steps, poses);
  }

  /// The step whose state a sensor shows now.
  std::uint64_t stepOf(const TimedSensor& sensor) const {
    if (!sensor.clock || !(options.noise || sensor.chosen)) return steps;
    return sensor.clock->readable(options.seed, steps, history.oldest(steps));
  }
  std::span<const Pose3> posesAt(std::uint64_t step) {
    if (!posesValid) updatePoses();
    if (step >= steps || !history.isWanted()) return poses;
    const auto past = history.at(step);
    return past.empty() ? std::span<const Pose3>(poses) : past;
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
    sensing->read(noise(), ports.sensors);
    readingsValid = true;
  }

  void updatePoses() {
    for (std::size_t i = 0; i < physics->bodyCount(); ++i) poses[i + 1] = physics->linkInWorld(i);
    posesValid = true;
    ++posesVersion;
  }

  const TouchCount* obstaclesOf(const std::string& robot) const {
    for (std::size_t r = 0; r < robots.size(); ++r) {
      if (world.models[static_cast<std::size_t>(robots[r])].name == robot) return &obstacles[r];
    }
    return nullptr;
  }

  // Measures in several threads what depends on the present poses only.
  void prepareToMeasureAhead();
  void measure(std::size_t sensor, std::span<double> ranges);
  void measureImage(std::size_t sensor, std::span<float> values);
  void poseRanging(std::uint64_t step);
  void poseImaging(std::uint64_t step);
  void setImageErrors(std::size_t sensor, const SensorErrors& errors);

  /// Writes or reads everything that changes while it runs; what cannot be read is half overwritten.
  void transfer(StateStream& stream);
  void transferTiming(StateStream& stream);
  /// A number for what the scene is, which is the same for the same scene wherever its file is.
  std::uint64_t fingerprint() const;
  /// The fingerprint, once it was needed.
  mutable std::optional<std::uint64_t> knownFingerprint;
  /// Moves a model unless it does not fit there; then nothing has changed.
  robotlink::Result<void> tryMove(int model, const Pose3& transform);
  /// Fails if a model is fixed to the world, so that it cannot be put elsewhere.
  robotlink::Result<void> checkFree(int model) const;
  /// The body of a link by its path, or the first body of a model by its name; fails unless forces move it.
  robotlink::Result<std::size_t> movableBody(const std::string& path) const;
  /// The index of a model that forces move.
  robotlink::Result<int> movableModel(const std::string& name) const;
  std::string linkPath(std::size_t body) const;
  /// Notes a command for going back, if that is wanted.
  void note(CommandKind kind, std::size_t index, std::span<const double> values,
            const std::string& text = {}) {
    // Commands of controllers are not noted, because the controllers repeat them.
    if (rewind && !isRepeating && !control.isRunning) rewind->note(steps, kind, index, values, text);
  }
  void note(CommandKind kind, std::size_t index, std::initializer_list<double> values,
            const std::string& text = {}) {
    note(kind, index, std::span<const double>(values.begin(), values.size()), text);
  }
  /// Keeps the present state for going back, if one is due.
  void keepForRewind();
  /// The past is that of another world.
  void clearRewind();

  /// Fails if a robot or a ball is inside another model at its start or, if it continues from `before`, where
  /// it is now; notes other overlaps. Models that were inside before may stay so.
  robotlink::Result<void> checkPlaces(const SimulationState* before = nullptr);
  /// Fails if a model is inside another one and was not before.
  robotlink::Result<void> checkFits(const SimulationState& before) const;
  /// Whether a model overlaps none in `before`, or is not there.
  bool wasFree(int model, const SimulationState& before) const;
  /// Takes over how models, servos and drives stand and move from another world; see
  /// Simulation::continueIn().
  robotlink::Result<std::vector<std::string>> takeOver(const SimulationState& before,
                                                       const Continuation& how);
  /// Returns the models that stay at their start; adds the others to `kept`.
  robotlink::Result<std::vector<std::string>> takeOverModels(const SimulationState& before,
                                                             const Continuation& how, std::vector<int>& kept);
  /// Moves new models as they are to begin.
  void beginNewModels(const SimulationState& before, const Continuation& how);
  /// The errors of sensors that a user chose, by the paths of their ports.
  std::map<std::string, SensorErrors> errorsByPath() const;
  void takeOverPorts(const SimulationState& before, const std::vector<int>& kept);

  int modelIndex(const std::string& name) const {
    const auto found = std::ranges::find(world.models, name, &ModelInstance::name);
    return found == world.models.end() ? -1 : static_cast<int>(found - world.models.begin());
  }
};

}  // namespace simcore
