// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/SimulatedWorld.h"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "app/core/program/RobotFiles.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/RobotDescription.h"
#include "simcore/Scene.h"
#include "simcore/devices/Ports.h"

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
  // Robots with the newer controllers call themselves this.
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
  auto pool = std::make_shared<robotlink::ThreadPool>(options.threads);
  options.threads = pool->threads();
  auto simulation =
      simcore::Simulation::create(std::move(scene), {options.seed, options.noise, options.kinematic, pool});
  if (!simulation) return tl::unexpected(simulation.error());
  std::unique_ptr<SimulatedWorld> world(new SimulatedWorld(std::move(*simulation), options, std::move(pool)));
  if (auto made = world->makePioneers(); !made) return tl::unexpected(made.error());
  return world;
}

SimulatedWorld::SimulatedWorld(std::unique_ptr<simcore::Simulation> simulation, Options options,
                               std::shared_ptr<robotlink::ThreadPool> pool)
    : options_(options),
      pool_(std::move(pool)),
      simulation_(std::move(simulation)),
      cameraWork_(*simulation_, pool_, options.shadows),
      cameraSettings_(simulation_->cameras().size()),
      cameraErrorsChosen_(simulation_->cameras().size()) {
  simulation_->setCameraImages([this](std::size_t camera) {
    // In the middle of a change of the scene, it is that of another one.
    return cameraWork_.isUpToDate() ? &preview(camera) : nullptr;
  });
  if (options_.rewindBytes > 0) simulation_->keepForRewind(options_.rewindBytes);
}

void SimulatedWorld::keepCameras() {
  const auto cameras = simulation_->cameras();
  // The errors of removed sensors are those of the scene again.
  for (auto& [path, kept] : keptCameras_) kept.errorsChosen = false;
  for (std::size_t i = 0; i < cameras.size(); ++i)
    keptCameras_[cameras[i].info.path] = {cameraSettings_[i], cameraErrorsChosen_[i]};
}

void SimulatedWorld::findCameras() {
  cameraSettings_.clear();
  cameraErrorsChosen_.clear();
  for (const auto& camera : simulation_->cameras()) {
    const KeptCamera& kept = keptCameras_[camera.info.path];
    cameraSettings_.push_back(kept.setting);
    cameraErrorsChosen_.push_back(kept.errorsChosen);
  }
  cameraWork_.restart();
  held_.forgetMissing(*simulation_);
}

robotlink::Result<simcore::SceneChange> SimulatedWorld::continueIn(
    std::shared_ptr<const simcore::Scene> scene, const simcore::Continuation& how) {
  keepCameras();
  auto change = simulation_->continueIn(std::move(scene), how);
  if (!change || !(change->hasSamePorts || how.otherPorts)) return change;
  findCameras();
  if (auto made = makePioneers(); !made) {
    goBack();
    return tl::unexpected(made.error());
  }
  return change;
}

void SimulatedWorld::goBack() {
  simulation_->goBack();
  findCameras();
  // The microcontrollers exist already, so this creates none.
  static_cast<void>(makePioneers());
}

SimulatedPioneer::Options SimulatedWorld::pioneerOptions(const std::string& robot) const {
  SimulatedPioneer::Options options = options_.pioneers;
  options.seed = options_.seed;
  if (!options_.noise) options.tireError = 0;
  if (const auto description = descriptionOf(simulation_->scene(), robot))
    describe(*description, options.settings);
  return options;
}

robotlink::Result<void> SimulatedWorld::makePioneers() {
  std::vector<std::unique_ptr<SimulatedPioneer>> before = std::move(pioneers_);
  std::ranges::move(gone_, std::back_inserter(before));
  pioneers_.clear();
  gone_.clear();
  robotlink::Result<void> result;
  for (const auto& drive : simulation_->drives()) {
    if (drive.controller != SimulatedPioneer::kController) continue;
    const auto known = std::ranges::find_if(before, [&](const auto& pioneer) {
      return pioneer && pioneer->robot() == drive.info.robot && pioneer->rebind();
    });
    if (known != before.end()) {
      pioneers_.push_back(std::move(*known));
      continue;
    }
    auto made = SimulatedPioneer::create(*simulation_, drive.info.robot, pioneerOptions(drive.info.robot));
    if (made) {
      pioneers_.push_back(std::move(*made));
    } else if (result) {
      result = tl::unexpected(made.error());
    }
  }
  for (auto& pioneer : before) {
    if (pioneer) gone_.push_back(std::move(pioneer));
  }
  return result;
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
      // Controllers override programs, and held actuators override both.
      simulation_->control();
      const auto events = simulation_->events();
      events_.insert(events_.end(), events.begin(), events.end());
      if (commands_ != nullptr) commands_->apply(*simulation_);
      held_.apply(*simulation_);
      simulation_->step();
      ++costs_.steps;
    }
    cameraWork_.renderAhead(orders(), dues());
    clock_.set(robotlink::Instant(simulation_->time() + clockAhead_));
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
  cameraWork_.restart();
  digest_ = 0;
  costs_ = {};
  clockAhead_ = {};
  clock_.set(robotlink::Instant{});
  for (const auto& pioneer : pioneers_) pioneer->reset(seed);
}

bool SimulatedWorld::imageDue(std::size_t camera, std::uint64_t step) const {
  const Duration time = simcore::Simulation::kStep * static_cast<std::int64_t>(step);
  return time % simulation_->cameras()[camera].period < kStep;
}

CameraWork::Orders SimulatedWorld::orders() const {
  return [this](std::size_t camera) { return orderOf(camera); };
}

CameraWork::IsDue SimulatedWorld::dues() const {
  return [this](std::size_t camera, std::uint64_t step) { return imageDue(camera, step); };
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
  const robotlink::Image& image = cameraWork_.image(camera, orders(), dues());
  mixIntoDigest(hashOf(image.data));
  return image;
}

const robotlink::Image& SimulatedWorld::preview(std::size_t camera) {
  return cameraWork_.preview(camera, orders());
}

CameraWork::Order SimulatedWorld::orderOf(std::size_t camera) const {
  const simcore::CameraSensor& sensor = simulation_->cameras()[camera];
  CameraWork::Order order{
      .model = sensor.model, .lighting = lightingOf(camera), .blackout = options_.blackout};
  order.model.vignetting = options_.vignetting.value_or(order.model.vignetting);
  order.noise.sigma = options_.noise ? options_.imageNoise.value_or(sensor.noise) : 0;
  if (cameraErrorsChosen_[camera]) order.noise.sigma = sensor.noise;
  order.noise.sigma *= cameraSettings_[camera].gain;
  order.noise.seed = options_.seed;
  order.noise.stream = simcore::hashOfPath(sensor.info.path);
  order.noise.frame = simulation_->cameraStep(camera);
  return order;
}

const robotlink::Image& SimulatedWorld::trueClasses() {
  const CostMeter meter(costs_.rendering);
  return cameraWork_.trueClasses();
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
  cameraWork_.forgetImages();
  return {};
}

robotlink::Result<void> SimulatedWorld::setSensorErrors(const std::string& path,
                                                        const simcore::SensorErrors& errors) {
  if (const auto set = simulation_->setSensorErrors(path, errors); !set) return set;
  cameraWork_.forgetImages();
  const simcore::Port& port = *simulation_->port(path);
  if (port.kind == simcore::Port::Kind::kCamera) cameraErrorsChosen_[port.index] = true;
  return {};
}

}  // namespace app
