// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation: ports by path, errors of sensors, and the ground truth for the oracle.
#include <cmath>

#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"

namespace simcore {
namespace {

template <typename Devices>
void addPorts(std::vector<Port>& ports, const Devices& devices, Port::Kind kind) {
  for (std::size_t i = 0; i < devices.size(); ++i) ports.push_back({devices[i].info, kind, i});
}

template <typename Devices>
std::optional<std::size_t> indexOf(const Devices& devices, const std::string& path) {
  for (std::size_t i = 0; i < devices.size(); ++i) {
    if (devices[i].info.path == path) return i;
  }
  return std::nullopt;
}

/// How the paths of what a sensor truly measures end.
constexpr std::string_view kTrue = "/true";

auto unknownPort(const std::string& path, const char* what) {
  return robotlink::failure("simulation.unknown-port", "there is no " + std::string(what) + " '" + path + "'",
                            {}, {path});
}

std::vector<double> valuesOf(const ActuatorState& state) {
  return {state.reached ? 1.0 : 0.0, state.unobstructed ? 1.0 : 0.0};
}

/// Notes the errors of a sensor: three numbers for its timing, then those of each channel; see
/// SimulationState::note().
void noteErrors(SimulationState& state, const std::string& path, const SensorErrors& errors) {
  std::vector<double> values{errors.delay, errors.rate, errors.dropout};
  for (const NoiseModel& noise : errors.noise) {
    values.insert(values.end(), {noise.mean, noise.stddev, noise.biasMean, noise.biasStddev,
                                 noise.driftStddev, noise.driftTime, noise.precision});
  }
  state.note(CommandKind::kErrors, 0, values, path);
}

/// Adds a visible pixel to a percept.
void addPixel(TruePercept& percept, int x, int y) {
  const bool first = percept.pixels++ == 0;
  percept.left = first ? x : std::min(percept.left, x);
  percept.right = first ? x : std::max(percept.right, x);
  percept.top = first ? y : std::min(percept.top, y);
  percept.bottom = first ? y : std::max(percept.bottom, y);
}

}  // namespace

std::vector<Port> portsOf(const Ports& ports, const WorldDescription& world) {
  std::vector<Port> result;
  addPorts(result, ports.sensors, Port::Kind::kSensor);
  addPorts(result, ports.cameras, Port::Kind::kCamera);
  addPorts(result, ports.ranges, Port::Kind::kRange);
  addPorts(result, ports.images, Port::Kind::kImage);
  addPorts(result, ports.servos, Port::Kind::kServo);
  addPorts(result, ports.drives, Port::Kind::kDrive);
  addPorts(result, ports.guides, Port::Kind::kGuide);
  addPorts(result, ports.doors, Port::Kind::kDoor);
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const std::string& name = world.models[i].name;
    result.push_back({{name + "/true_pose", name, "pose", {7}, "m, quaternion"}, Port::Kind::kTruePose, i});
    result.push_back(
        {{name + "/true_velocity", name, "velocity", {6}, "m/s, rad/s"}, Port::Kind::kTrueVelocity, i});
  }
  return result;
}

std::span<const Port> Simulation::ports() const {
  return implementation_->allPorts;
}

const Port* Simulation::port(const std::string& path) const {
  const auto& ports = implementation_->allPorts;
  const auto found = implementation_->portsByPath.find(path);
  return found == implementation_->portsByPath.end() ? nullptr : &ports[found->second];
}

std::vector<std::string> Simulation::readablePaths() const {
  std::vector<std::string> paths;
  for (const Port& port : ports()) paths.push_back(port.info.path);
  for (const Port& port : ports()) {
    if (sensorErrors(port.info.path) != nullptr) paths.push_back(port.info.path + std::string(kTrue));
  }
  return paths;
}

const Port* Simulation::portOfTruth(const std::string& path) const {
  if (!path.ends_with(kTrue)) return nullptr;
  const Port* found = port(path.substr(0, path.size() - kTrue.size()));
  return found != nullptr && sensorErrors(found->info.path) != nullptr ? found : nullptr;
}

robotlink::Result<std::vector<double>> Simulation::read(const std::string& path) const {
  const Port* found = port(path);
  if (found == nullptr) {
    if (const Port* of = portOfTruth(path)) return readTruth(of->info.path);
    return unknownPort(path, "port");
  }
  Implementation& i = *implementation_;
  switch (found->kind) {
    case Port::Kind::kSensor:
      return sensors()[found->index].values;
    case Port::Kind::kRange: {
      std::vector<double> values(static_cast<std::size_t>(i.ports.ranges[found->index].readings));
      measure(found->index, values);
      return values;
    }
    case Port::Kind::kImage: {
      std::vector<float> values(i.ports.images[found->index].values());
      measureImage(found->index, values);
      return std::vector<double>(values.begin(), values.end());
    }
    case Port::Kind::kCamera:
      return robotlink::failure("simulation.port",
                                "the images of '" + path + "' are rendered by a CameraRenderer", {}, {path});
    case Port::Kind::kServo:
      return valuesOf(servoState(found->index));
    case Port::Kind::kGuide:
      return valuesOf(guideState(found->index));
    case Port::Kind::kDrive:
      return valuesOf(driveState(found->index));
    case Port::Kind::kDoor:
      return valuesOf(servoState(i.ports.doors[found->index].servo));
    case Port::Kind::kTruePose:
    case Port::Kind::kTrueVelocity:
      return i.truthOf(*found);
    case Port::Kind::kOutput:
      return i.readOutput(found->index);
  }
  return unknownPort(path, "port");
}

robotlink::Result<std::vector<double>> Simulation::readTruth(const std::string& path) const {
  const Port* found = port(path);
  Implementation& i = *implementation_;
  if (found == nullptr || found->isActuator() || found->kind == Port::Kind::kCamera)
    return unknownPort(path, "sensor");
  switch (found->kind) {
    case Port::Kind::kSensor: {
      std::vector<double> values(i.ports.sources[found->index].size);
      i.sensing->readExactly(found->index, values);
      return values;
    }
    case Port::Kind::kRange:
      return i.trueRanges(found->index);
    case Port::Kind::kImage:
      return i.trueImage(found->index);
    case Port::Kind::kOutput:
      return i.readOutput(found->index);
    default:
      return i.truthOf(*found);
  }
}

robotlink::Result<void> Simulation::write(const std::string& path, std::span<const double> values) {
  const Port* found = port(path);
  if (found == nullptr || !found->isActuator()) return unknownPort(path, "actuator");
  const std::size_t size = found->info.shape.empty() ? 1 : static_cast<std::size_t>(found->info.shape[0]);
  const bool finite = std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
  if (values.size() != size || !finite) {
    return robotlink::failure("simulation.port",
                              "'" + path + "' needs " + std::to_string(size) + " finite numbers", {}, {path});
  }
  if (found->kind == Port::Kind::kServo) requestAngle(found->index, values[0]);
  if (found->kind == Port::Kind::kGuide) guide(found->index, values);
  if (found->kind == Port::Kind::kDoor) moveDoor(found->index, values[0] >= 0.5);
  if (found->kind == Port::Kind::kDrive) requestWheelSpeeds(found->index, values[0], values[1]);
  return {};
}

std::vector<double> SimulationState::truthOf(const Port& port) const {
  const int model = static_cast<int>(port.index);
  const Pose3 pose = physics->modelInWorld(model);
  if (port.kind == Port::Kind::kTruePose) {
    const Eigen::Quaterniond q(pose.linear());
    const Vector3& p = pose.translation();
    return {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()};
  }
  if (world.models[port.index].type->isStatic) return std::vector<double>(6);
  const Vector3 velocity = physics->velocityOfModel(model), rate = physics->turningRateOfModel(model);
  return {velocity.x(), velocity.y(), velocity.z(), rate.x(), rate.y(), rate.z()};
}

std::vector<double> SimulationState::trueRanges(std::size_t sensor) {
  if (!posesValid) updatePoses();
  // A separate RangeSensing, so that this reading does not disturb those with noise.
  if (!trueRanging) {
    trueRangeSensors = ports.ranges;
    for (RangeSensor& each : trueRangeSensors) each.errors = {};
    trueRanging =
        std::make_unique<RangeSensing>(scene->contents().renderScene, trueRangeSensors, ports.rangeOwners);
  }
  trueRanging->setPoses(poses);
  std::vector<double> values(static_cast<std::size_t>(ports.ranges[sensor].readings));
  trueRanging->measure(sensor, {false, 0, steps}, values);
  return values;
}

std::vector<double> SimulationState::trueImage(std::size_t sensor) {
  if (!posesValid) updatePoses();
  if (!trueImaging) {
    trueImaging =
        std::make_unique<ImageSensing>(scene->contents().renderScene, ports.images, ports.imageOwners);
  }
  trueImaging->setPoses(poses);
  std::vector<float> values(ports.images[sensor].values());
  trueImaging->measure(sensor, {false, 0, steps}, values);
  return {values.begin(), values.end()};
}

std::vector<TruePercept> Simulation::truePercepts(std::size_t camera) const {
  Implementation& i = *implementation_;
  const CameraSensor& sensor = i.ports.cameras[camera];
  std::vector<Pose3> poses;
  cameraPoses(camera, 0, poses);
  const auto scene = i.scene->contents().renderScene;
  if (!i.truth) i.truth = std::make_unique<CameraRenderer>(scene, CameraRenderer::Options{.shadows = false});
  i.truth->setPoses(poses);
  const Pose3 pose = poses[static_cast<std::size_t>(sensor.body)] * sensor.cameraInBody;
  std::vector<float> models(static_cast<std::size_t>(sensor.model.width) *
                            static_cast<std::size_t>(sensor.model.height));
  i.truth->renderDepth(pose, sensor.model, models);
  // The part of an instance's name before the first slash is that of its model.
  std::vector<float> labels;
  for (const RenderInstance& instance : scene->instances)
    labels.push_back(static_cast<float>(i.modelIndex(instance.name.substr(0, instance.name.find('/')))));
  i.truth->labelValues(labels, -1, models);
  std::vector<TruePercept> percepts(i.world.models.size());
  for (std::size_t at = 0; at < models.size(); ++at) {
    if (models[at] < 0) continue;
    const int x = static_cast<int>(at) % sensor.model.width, y = static_cast<int>(at) / sensor.model.width;
    addPixel(percepts[static_cast<std::size_t>(models[at])], x, y);
  }
  for (std::size_t m = 0; m < percepts.size(); ++m) {
    percepts[m].model = i.world.models[m].name;
    percepts[m].modelInCamera = pose.inverse(Eigen::Isometry) * i.physics->modelInWorld(static_cast<int>(m));
  }
  std::erase_if(percepts, [](const TruePercept& percept) { return percept.pixels == 0; });
  return percepts;
}

const SensorErrors* Simulation::sensorErrors(const std::string& path) const {
  const Implementation& i = *implementation_;
  const Port* found = port(path);
  if (found == nullptr) return nullptr;
  switch (found->kind) {
    case Port::Kind::kSensor:
      return &i.sensing->errors(found->index);
    case Port::Kind::kCamera:
      return &i.cameraTiming[found->index].errors;
    case Port::Kind::kRange:
      return &i.rangeTiming[found->index].errors;
    case Port::Kind::kImage:
      return &i.imageTiming[found->index].errors;
    default:
      return nullptr;
  }
}

SensorErrors Simulation::errorsInUse(const std::string& path) const {
  const SensorErrors* errors = sensorErrors(path);
  const bool areUsed = implementation_->options.noise || implementation_->errorsByPath().contains(path);
  return errors != nullptr && areUsed ? *errors : SensorErrors{};
}

robotlink::Result<void> Simulation::setSensorErrors(const std::string& path, const SensorErrors& errors) {
  Implementation& i = *implementation_;
  if (sensorErrors(path) == nullptr) return unknownPort(path, "sensor");
  if (const std::string wrong = wrongErrors(errors); !wrong.empty())
    return robotlink::failure("simulation.noise", wrong, {}, {path});
  const Port& found = *port(path);
  noteErrors(i, path, errors);
  i.remember(errors);
  if (found.kind == Port::Kind::kSensor) {
    i.sensing->setErrors(found.index, errors, i.noise());
    i.chosenErrors[found.index] = errors;
  } else {
    auto& timing = found.kind == Port::Kind::kCamera  ? i.cameraTiming
                   : found.kind == Port::Kind::kRange ? i.rangeTiming
                                                      : i.imageTiming;
    timing[found.index].set(errors);
    timing[found.index].chosen = true;
  }
  if (found.kind == Port::Kind::kCamera) i.ports.cameras[found.index].noise = errors.of(0).stddev;
  if (found.kind == Port::Kind::kRange)
    i.ranging->setErrors(found.index, errors, {true, i.options.seed, i.steps});
  if (found.kind == Port::Kind::kImage) i.setImageErrors(found.index, errors);
  i.readingsValid = false;
  i.rangesAhead->forget();
  i.imagesAhead->forget();
  i.recordPoses();
  return {};
}

void Simulation::cameraPoses(std::size_t camera, double age, std::vector<Pose3>& poses) const {
  Implementation& i = *implementation_;
  const std::uint64_t step = i.stepOf(i.cameraTiming[camera]);
  const double back = std::max(0.0, age) / kStepSeconds;
  const double at = std::max(static_cast<double>(i.history.oldest(step)), static_cast<double>(step) - back);
  interpolatePoses(
      at, [&i](std::uint64_t one) { return i.posesAt(one); }, poses);
}

std::optional<ComingImage> Simulation::comingImage(std::size_t camera, std::uint64_t at) const {
  Implementation& i = *implementation_;
  const TimedSensor& timing = i.cameraTiming[camera];
  if (!timing.clock || !(i.options.noise || timing.chosen) || at < i.steps) return std::nullopt;
  const ShutterModel& shutter = i.ports.cameras[camera].shutter;
  const double open = (shutter.exposure + shutter.readout) / kStepSeconds;
  const auto back = static_cast<std::uint64_t>(std::ceil(open));
  const std::uint64_t oldest = i.history.oldestAt(at);
  const std::uint64_t step = timing.clock->readable(i.options.seed, at, oldest);
  // Models may still be placed in the present step; and the memory limits how old poses can be.
  if (step >= i.steps || step <= oldest + back) return std::nullopt;
  ComingImage coming{.step = step};
  for (std::uint64_t one = step - back; one <= step; ++one) {
    const auto poses = i.posesAt(one);
    coming.past.emplace_back(poses.begin(), poses.end());
  }
  return coming;
}

void ComingImage::poses(double age, std::vector<Pose3>& poses) const {
  const std::uint64_t first = step + 1 - past.size();
  const double at = static_cast<double>(step) - std::max(0.0, age) / kStepSeconds;
  interpolatePoses(
      std::max(at, static_cast<double>(first)),
      [&](std::uint64_t one) { return std::span<const Pose3>(past[one - first]); }, poses);
}

std::uint64_t Simulation::cameraStep(std::size_t camera) const {
  return implementation_->stepOf(implementation_->cameraTiming[camera]);
}

std::span<const ImageSensor> Simulation::imageSensors() const {
  return implementation_->ports.images;
}

void Simulation::measureImage(std::size_t imageSensor, std::span<float> values) const {
  implementation_->measureImage(imageSensor, values);
}

std::span<const Guide> Simulation::guides() const {
  return implementation_->ports.guides;
}

void Simulation::guide(std::size_t guide, std::span<const double> values) {
  implementation_->note(CommandKind::kGuide, guide, values);
  implementation_->actuation->guide(guide, values);
}

double SimulationState::readingFor(const Door& door) {
  std::vector<double> values;
  if (door.sensor.kind == DoorSensor::Kind::kRange) {
    values.resize(static_cast<std::size_t>(ports.ranges[door.sensor.index].readings));
    measure(door.sensor.index, values);
  } else {
    sensing->read(noise(), door.sensor.index, ports.sensors[door.sensor.index]);
    values = ports.sensors[door.sensor.index].values;
  }
  return *std::ranges::min_element(values);
}

std::span<const Door> Simulation::doors() const {
  return implementation_->ports.doors;
}

void Simulation::moveDoor(std::size_t door, bool open) {
  implementation_->note(CommandKind::kDoor, door, {open ? 1.0 : 0.0});
  implementation_->doors->command(door, open, implementation_->steps);
}

bool Simulation::isDoorOpen(std::size_t door) const {
  return implementation_->doors->isOpen(door);
}

ActuatorState Simulation::servoState(std::size_t servo) const {
  return implementation_->actuation->servoState(servo);
}

ActuatorState Simulation::guideState(std::size_t guide) const {
  return implementation_->actuation->guideState(guide);
}

ActuatorState Simulation::driveState(std::size_t drive) const {
  const Implementation& i = *implementation_;
  const auto near = [&](std::size_t side) {
    const double most = i.ports.drives[drive].maximumSpeed;
    return std::abs(i.physics->sideState(side).speed - i.physics->rimTarget(side)) <= 0.02 * most;
  };
  return {near(2 * drive) && near(2 * drive + 1), i.driveUnobstructed[drive]};
}

}  // namespace simcore
