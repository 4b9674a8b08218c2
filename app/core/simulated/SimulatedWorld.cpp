// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/SimulatedWorld.h"

#include <cstring>

#include "app/core/program/RobotFiles.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/Scene.h"

namespace app {
namespace {

using robotlink::Duration;

/// Adds the real time between its construction and destruction to a sum.
class CostMeter {
 public:
  explicit CostMeter(Duration& sum) : sum_(sum) {}
  ~CostMeter() { sum_ += std::chrono::steady_clock::now() - start_; }
  CostMeter(const CostMeter&) = delete;
  CostMeter& operator=(const CostMeter&) = delete;

 private:
  Duration& sum_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Hashes all bytes but the last few that do not fill a word.
std::uint64_t hashOf(const std::vector<std::uint8_t>& bytes) {
  std::uint64_t hash = bytes.size();
  for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, 8);
    hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 32U;
  }
  return hash;
}

/// Makes an image in YCbCr 4:2:2 black.
void blacken(robotlink::Image& image) {
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = i % 2 == 0 ? 0 : 128;
}

/// The description of a robot in a scene; null if it has none or a broken one, which its program reports.
std::shared_ptr<const robotlink::RobotDescription> descriptionOf(const simcore::Scene& scene,
                                                                 const std::string& robot) {
  for (const auto& each : scene.robots()) {
    if (each.name != robot) continue;
    auto read = readRobot(each.description);
    return read ? std::move(*read) : nullptr;
  }
  return nullptr;
}

/// Sets what a microcontroller has from the description of its robot: type, limits of motion, sonars,
/// battery.
void describe(const robotlink::RobotDescription& robot, robotlink::arcos::ServerSettings& settings) {
  // As robots with the newer controllers call themselves.
  settings.subclass = robot.name + "-sh";
  if (const auto& drive = robot.drive) {
    settings.motion.speed = drive->maximumSpeed;
    settings.motion.rotation = drive->maximumRotation;
    settings.motion.acceleration = settings.motion.deceleration = drive->acceleration;
    settings.motion.rotationAcceleration = settings.motion.rotationDeceleration = drive->rotationAcceleration;
  }
  if (const auto& sonars = robot.sonars) {
    settings.sonars = static_cast<int>(sonars->sensors.size());
    settings.sonarMaximum = sonars->maximum;
  }
  if (const auto& battery = robot.battery) {
    settings.fullVoltage = battery->full;
    settings.lowVoltage = battery->low;
    settings.shutdownVoltage = battery->empty;
  }
}

}  // namespace

robotlink::Result<std::unique_ptr<SimulatedWorld>> SimulatedWorld::create(
    std::shared_ptr<const simcore::Scene> scene, Options options) {
  auto simulation =
      simcore::Simulation::create(std::move(scene), {options.seed, options.noise, options.kinematic});
  if (!simulation) return tl::unexpected(simulation.error());
  std::unique_ptr<SimulatedWorld> world(new SimulatedWorld(std::move(*simulation), options));
  if (auto made = world->makePioneers(); !made) return tl::unexpected(made.error());
  return world;
}

SimulatedWorld::SimulatedWorld(std::unique_ptr<simcore::Simulation> simulation, Options options)
    : options_(options), simulation_(std::move(simulation)), trueClasses_(*simulation_->renderScene()) {
  makeRenderer();
}

void SimulatedWorld::makeRenderer() {
  renderer_.reset();
  posesRendered_ = ~std::uint64_t{0};
  cameraSettings_.resize(simulation_->cameras().size());
  cameraErrorsChosen_.resize(simulation_->cameras().size());
  optics_.resize(simulation_->cameras().size());
  if (simulation_->cameras().empty()) return;
  renderer_ = std::make_unique<simcore::CameraRenderer>(simulation_->renderScene(),
                                                        simcore::CameraRenderer::Options{options_.shadows});
}

robotlink::Result<simcore::SceneChange> SimulatedWorld::continueIn(
    std::shared_ptr<const simcore::Scene> scene) {
  auto change = simulation_->continueIn(std::move(scene));
  if (!change || !change->hasSamePorts) return change;
  trueClasses_ = TrueClasses(*simulation_->renderScene());
  makeRenderer();
  return change;
}

std::vector<std::string> SimulatedWorld::continueFrom(const SimulatedWorld& before) {
  std::vector<std::string> putBack = simulation_->continueFrom(*before.simulation_);
  clock_.set(before.clock_.now());
  costs_ = before.costs_;
  digest_ = before.digest_;
  return putBack;
}

robotlink::Result<void> SimulatedWorld::makePioneers() {
  SimulatedPioneer::Options options = options_.pioneers;
  options.seed = options_.seed;
  if (!options_.noise) options.tireError = 0;
  for (const auto& drive : simulation_->drives()) {
    if (drive.controller != SimulatedPioneer::kController) continue;
    SimulatedPioneer::Options own = options;
    if (const auto description = descriptionOf(simulation_->scene(), drive.info.robot))
      describe(*description, own.settings);
    auto pioneer = SimulatedPioneer::create(*simulation_, drive.info.robot, std::move(own));
    if (!pioneer) return tl::unexpected(pioneer.error());
    pioneers_.push_back(std::move(*pioneer));
  }
  return {};
}

SimulatedPioneer* SimulatedWorld::pioneer(const std::string& robot) const {
  for (const auto& pioneer : pioneers_) {
    if (pioneer->robot() == robot) return pioneer.get();
  }
  return nullptr;
}

void SimulatedWorld::mixIntoDigest(std::uint64_t value) {
  digest_ = robotlink::mixBits(digest_ ^ value);
}

void SimulatedWorld::advance() {
  events_.clear();
  for (Duration done{}; done < kStep; done += simcore::Simulation::kStep) {
    {
      const CostMeter meter(costs_.physics);
      // Controllers override programs, and whoever holds an actuator overrides both.
      simulation_->control();
      const auto events = simulation_->events();
      events_.insert(events_.end(), events.begin(), events.end());
      if (commands_ != nullptr) commands_->apply(*simulation_);
      held_.apply(*simulation_);
      simulation_->step();
      ++costs_.steps;
    }
    clock_.set(robotlink::Instant(simulation_->time()));
    if (pioneers_.empty()) continue;
    const CostMeter meter(costs_.pioneers);
    for (const auto& pioneer : pioneers_) pioneer->step(clock_.now());
  }
  const CostMeter meter(costs_.physics);
  mixIntoDigest(simulation_->digest());
}

void SimulatedWorld::reset(std::uint64_t seed) {
  options_.seed = seed;
  held_.forget();
  simulation_->reset(seed);
  posesRendered_ = ~std::uint64_t{0};
  digest_ = 0;
  costs_ = {};
  clock_.set(robotlink::Instant{});
  for (const auto& pioneer : pioneers_) pioneer->reset(seed);
}

bool SimulatedWorld::imageDue(std::size_t camera) const {
  return simulation_->time() % simulation_->cameras()[camera].period < kStep;
}

simcore::LightAdjustment SimulatedWorld::lightingOf(std::size_t camera) const {
  simcore::LightAdjustment lighting = options_.lighting;
  lighting.brightness *= cameraSettings_[camera].exposure * cameraSettings_[camera].gain;
  lighting.whiteBalance = cameraSettings_[camera].whiteBalance;
  return lighting;
}

const robotlink::Image& SimulatedWorld::render(std::size_t camera) {
  const CostMeter meter(costs_.rendering);
  ++costs_.images;
  draw(camera);
  mixIntoDigest(hashOf(image_.data));
  return image_;
}

const robotlink::Image& SimulatedWorld::preview(std::size_t camera) {
  draw(camera);
  return image_;
}

void SimulatedWorld::draw(std::size_t camera) {
  const simcore::CameraSensor& sensor = simulation_->cameras()[camera];
  simcore::ImageNoise noise;
  noise.sigma = options_.noise ? options_.imageNoise.value_or(sensor.noise) : 0;
  if (cameraErrorsChosen_[camera]) noise.sigma = sensor.noise;
  noise.sigma *= cameraSettings_[camera].gain;
  noise.seed = options_.seed;
  noise.stream = camera;
  noise.frame = simulation_->cameraStep(camera);
  simcore::CameraModel model = sensor.model;
  model.vignetting = options_.vignetting.value_or(model.vignetting);
  renderer_->setLighting(lightingOf(camera));
  take(camera, model, noise);
  if (options_.blackout) blacken(image_);
}

void SimulatedWorld::take(std::size_t camera, const simcore::CameraModel& model,
                          const simcore::ImageNoise& noise) {
  const simcore::CameraSensor& sensor = simulation_->cameras()[camera];
  lastCamera_ = camera;
  const simcore::SensorErrors* errors = simulation_->sensorErrors(sensor.info.path);
  if (!model.distortion.any() && !sensor.shutter.any() && !errors->hasTiming()) {
    const auto poses = simulation_->bodyPoses();
    // All such cameras share the poses of a step.
    if (posesRendered_ != simulation_->steps()) renderer_->setPoses(poses);
    posesRendered_ = simulation_->steps();
    renderer_->render(poses[static_cast<std::size_t>(sensor.body)] * sensor.cameraInBody, model,
                      robotlink::PixelFormat::kYuyv, noise, image_);
    return;
  }
  const auto posesAt = [&](double age, std::vector<simcore::Pose3>& poses) {
    simulation_->cameraPoses(camera, age, poses);
  };
  posesRendered_ = ~std::uint64_t{0};
  optics_[camera].render(*renderer_, posesAt, {sensor.body, sensor.cameraInBody}, model, sensor.shutter,
                         robotlink::PixelFormat::kYuyv, noise, image_);
}

const robotlink::Image& SimulatedWorld::trueClasses() {
  const CostMeter meter(costs_.rendering);
  renderer_->label(trueClasses_.ofInstances(), TrueClasses::kBackground, classes_);
  optics_[lastCamera_].distortLabels(TrueClasses::kBackground, image_.width, classes_);
  TrueClasses::ignoreMixedPairs(classes_);
  return classes_;
}

robotlink::Result<void> SimulatedWorld::setLighting(const simcore::LightAdjustment& lighting) {
  // Written so that a NaN is out of range, too.
  if (!(lighting.brightness >= 0 && lighting.brightness <= simcore::LightAdjustment::kMaxBrightness)) {
    return robotlink::failure("simulation.light",
                              "the brightness must be between 0 and 10 times that of the scene");
  }
  if (!(lighting.warmth >= -1 && lighting.warmth <= 1)) {
    return robotlink::failure("simulation.light", "the warmth must be between -1 (bluish) and 1 (reddish)");
  }
  options_.lighting = lighting;
  return {};
}

robotlink::Result<void> SimulatedWorld::setSensorErrors(const std::string& path,
                                                        const simcore::SensorErrors& errors) {
  if (const auto set = simulation_->setSensorErrors(path, errors); !set) return set;
  const simcore::Port& port = *simulation_->port(path);
  if (port.kind == simcore::Port::Kind::kCamera) cameraErrorsChosen_[port.index] = true;
  return {};
}

}  // namespace app
