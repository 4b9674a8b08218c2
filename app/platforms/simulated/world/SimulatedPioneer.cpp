// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/SimulatedPioneer.h"

#include <algorithm>
#include <utility>

#include "robotlink/base/GroundMap.h"
#include "robotlink/base/Random.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace app {

using robotlink::Instant;
using robotlink::arcos::Packet;
using robotlink::arcos::RobotSensing;
using robotlink::arcos::WheelCommand;

namespace {

/// The largest number of requests between two calls of takeRequests(); further ones are dropped.
constexpr std::size_t kMaxRequests = 64;
constexpr std::size_t kMaxBumpers = 5;
/// Tire errors beyond this are not plausible.
constexpr double kMaxTireError = 0.02;

/// A hash of a robot's name that is the same on every computer, as std::hash is not.
std::uint64_t streamOf(const std::string& name) {
  std::uint64_t stream = 0;
  for (const char character : name)
    stream = robotlink::mixBits(stream ^ static_cast<unsigned char>(character));
  return stream;
}

/// Returns the index of the port with this path in a list of ports.
template <typename List>
std::optional<std::size_t> find(const List& list, const std::string& path) {
  const auto found = std::ranges::find_if(list, [&](const auto& port) { return port.info.path == path; });
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

}  // namespace

robotlink::Result<SimulatedPioneer::Ports> SimulatedPioneer::findPorts(const simcore::Simulation& simulation,
                                                                       const std::string& robot, int sonars) {
  Ports ports;
  const auto drives = simulation.drives();
  const auto drive =
      std::ranges::find_if(drives, [&](const auto& candidate) { return candidate.info.robot == robot; });
  if (drive == drives.end()) {
    return robotlink::failure(
        "pioneer.no-drive", "robot " + robot + " has no drive: no microcontroller can move it", {}, {robot});
  }
  ports.drive = static_cast<std::size_t>(drive - drives.begin());
  const auto sensors = simulation.sensors();
  const auto gyroscope = std::ranges::find_if(sensors, [&](const auto& sensor) {
    return sensor.info.robot == robot && sensor.info.type == "angular_velocity";
  });
  if (gyroscope != sensors.end()) ports.gyroscope = static_cast<std::size_t>(gyroscope - sensors.begin());
  for (std::size_t i = 1; i <= kMaxBumpers; ++i) {
    const std::string number = std::to_string(i);
    if (const auto found = find(sensors, robot + "/frontBumper" + number))
      ports.frontBumpers.push_back(*found);
    if (const auto found = find(sensors, robot + "/rearBumper" + number)) ports.rearBumpers.push_back(*found);
  }
  const auto ranges = simulation.rangeSensors();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (ranges[i].info.robot != robot) continue;
    if (ranges[i].kind == simcore::RangeSensor::Kind::kSonar) ports.sonars.emplace_back(i);
    if (ranges[i].kind == simcore::RangeSensor::Kind::kLaser && !ports.laser) ports.laser = i;
  }
  // The numbers of the sonars are those of the model; missing ones are unset.
  ports.sonars.resize(static_cast<std::size_t>(sonars));
  ports.gripper = PioneerGripper::of(simulation, robot);
  const auto gps = std::ranges::find_if(sensors, [&](const auto& sensor) {
    return sensor.info.robot == robot && sensor.info.type == "position_velocity";
  });
  if (gps != sensors.end()) ports.gps = static_cast<std::size_t>(gps - sensors.begin());
  return ports;
}

robotlink::Result<std::unique_ptr<SimulatedPioneer>> SimulatedPioneer::create(simcore::Simulation& simulation,
                                                                              std::string robot,
                                                                              Options options) {
  auto& settings = options.settings;
  auto found = findPorts(simulation, robot, settings.sonars);
  if (!found) return tl::unexpected(found.error());
  Ports& ports = *found;
  settings.gripper = ports.gripper.has_value();
  // The microcontroller reports the sensors that the model has.
  settings.motion.track = simulation.drives()[ports.drive].track;
  settings.frontBumpers = static_cast<int>(ports.frontBumpers.size());
  settings.rearBumpers = static_cast<int>(ports.rearBumpers.size());
  if (!ports.gyroscope) settings.gyroscope = robotlink::arcos::ServerSettings::Gyroscope::kNone;
  if (!ports.laser) {
    settings.laser.reset();
  } else {
    const auto& laser = simulation.rangeSensors()[*ports.laser];
    settings.laser = {laser.startAngle, laser.endAngle, laser.maximum};
  }
  return std::unique_ptr<SimulatedPioneer>(
      new SimulatedPioneer(simulation, std::move(robot), std::move(options), std::move(ports)));
}

bool SimulatedPioneer::rebind() {
  auto found = findPorts(simulation_, robot_, options_.settings.sonars);
  const auto kept = [](const auto& one, const auto& other) { return one.has_value() == other.has_value(); };
  if (!found || !kept(found->gyroscope, ports_.gyroscope) || !kept(found->laser, ports_.laser) ||
      !kept(found->gripper, ports_.gripper) || !kept(found->gps, ports_.gps) ||
      found->frontBumpers.size() != ports_.frontBumpers.size() ||
      found->rearBumpers.size() != ports_.rearBumpers.size() ||
      !std::ranges::equal(found->sonars, ports_.sonars, kept))
    return false;
  const auto ranges = simulation_.rangeSensors();
  if (found->laser && static_cast<std::size_t>(ranges[*found->laser].readings) != scan_.size()) return false;
  ports_ = std::move(*found);
  return true;
}

SimulatedPioneer::SimulatedPioneer(simcore::Simulation& simulation, std::string robot, Options options,
                                   Ports ports)
    : simulation_(simulation),
      robot_(std::move(robot)),
      options_(std::move(options)),
      ports_(std::move(ports)),
      session_(options_.settings),
      battery_(options_.settings.shutdownVoltage, options_.settings.fullVoltage) {
  if (ports_.laser) {
    scan_.resize(static_cast<std::size_t>(simulation_.rangeSensors()[*ports_.laser].readings));
  }
  start_ = truePose();
  drawTires();
}

void SimulatedPioneer::drawTires() {
  robotlink::Random random(options_.seed, streamOf(robot_));
  const auto draw = [&] {
    return 1 + std::clamp(options_.tireError * random.normal(), -kMaxTireError, kMaxTireError);
  };
  leftTire_ = draw();
  rightTire_ = draw();
}

robotlink::Pose2 SimulatedPioneer::truePose() const {
  const auto pose = simulation_.modelPose(robot_);
  return pose ? robotlink::groundPose(*pose) : robotlink::Pose2{};
}

void SimulatedPioneer::reset(std::uint64_t seed) {
  timeBefore_ += now_.time_since_epoch();
  now_ = {};
  options_.seed = seed;
  drawTires();
  battery_ = PioneerBattery(options_.settings.shutdownVoltage, options_.settings.fullVoltage);
  session_.robotReset();
  start_ = truePose();
  // The simulation's reset has switched the drive on.
  driveOn_ = true;
}

void SimulatedPioneer::worldJumped() {
  session_.encodersJumped();
  // Whether the drive then has power is decided by the microcontroller, as after each step.
  simulation_.setDriveOn(ports_.drive, driveOn_);
}

void SimulatedPioneer::step(Instant now) {
  const robotlink::Duration passed = now - now_;
  now_ = now;
  const RobotSensing sensing = sense();
  const WheelCommand command = session_.step(sensing, *this, now + timeBefore_);
  battery_.discharge(command.motorsOn, (sensing.leftSpeed + sensing.rightSpeed) / 2, passed);
  if (command.motorsOn != driveOn_) simulation_.setDriveOn(ports_.drive, driveOn_ = command.motorsOn);
  if (command.motorsOn) simulation_.requestWheelSpeeds(ports_.drive, command.left, command.right);
  if (ports_.gripper) ports_.gripper->move(simulation_, session_.gripperCommand());
  fulfilRequests();
}

RobotSensing SimulatedPioneer::sense() {
  const simcore::WheelState& wheels = simulation_.wheelState(ports_.drive);
  RobotSensing sensing;
  sensing.leftTravel = wheels.leftTravel * leftTire_;
  sensing.rightTravel = wheels.rightTravel * rightTire_;
  sensing.leftSpeed = wheels.leftSpeed * leftTire_;
  sensing.rightSpeed = wheels.rightSpeed * rightTire_;
  sensing.leftBlocked = wheels.leftBlocked;
  sensing.rightBlocked = wheels.rightBlocked;
  readBumpers(sensing);
  sensing.stopButton = stopButton_;
  sensing.battery = battery_.voltage();
  sensing.charge = battery_.charge();
  if (ports_.gyroscope) sensing.rotationRate = simulation_.sensors()[*ports_.gyroscope].values.at(2);
  if (ports_.gripper) sensing.gripper = ports_.gripper->sense(simulation_);
  const auto map = simulation_.scene().groundMap();
  if (ports_.gps && map && map->origin) {
    const auto& place = simulation_.sensors()[*ports_.gps].values;
    sensing.gps = robotlink::globalPosition(*map->origin, {place[0], place[1], place[2]});
  }
  if (session_.publishesTruth()) senseTruth(sensing);
  return sensing;
}

void SimulatedPioneer::senseTruth(RobotSensing& sensing) const {
  sensing.truePose = truePose();
  sensing.odometryError = (leftTire_ + rightTire_) / 2 - 1;
  const auto map = simulation_.scene().groundMap();
  if (!map || !map->origin) return;
  sensing.globalPosition =
      robotlink::globalPosition(*map->origin, {sensing.truePose.x, sensing.truePose.y, sensing.trueHeight});
}

void SimulatedPioneer::readBumpers(RobotSensing& sensing) const {
  const auto sensors = simulation_.sensors();
  const auto bitsOf = [&](const std::vector<std::size_t>& bumpers) {
    unsigned bits = 0;
    for (std::size_t i = 0; i < bumpers.size(); ++i)
      bits |= (sensors[bumpers[i]].values[0] > 0 ? 1U : 0U) << i;
    return static_cast<std::uint8_t>(bits);
  };
  sensing.frontBumpers = bitsOf(ports_.frontBumpers);
  sensing.rearBumpers = bitsOf(ports_.rearBumpers);
}

double SimulatedPioneer::sonar(int number) {
  const auto port = ports_.sonars.at(static_cast<std::size_t>(number));
  double range = options_.settings.sonarMaximum;
  if (port) simulation_.measure(*port, {&range, 1});
  return range;
}

std::span<const double> SimulatedPioneer::laser() {
  if (ports_.laser) simulation_.measure(*ports_.laser, scan_);
  return scan_;
}

void SimulatedPioneer::fulfilRequests() {
  namespace request = robotlink::arcos::simulator_request;
  // Only the last of several poses counts, since placing a robot is expensive.
  std::optional<robotlink::Pose2> target;
  for (auto& details : session_.takeRequests()) {
    if (const auto* pose = std::get_if<request::SetPose>(&details)) {
      target = pose->pose;
    } else if (std::holds_alternative<request::Reset>(details)) {
      target = start_;
    } else if (requests_.size() < kMaxRequests) {
      requests_.push_back(std::move(details));
    }
  }
  if (target) place(*target);
}

void SimulatedPioneer::place(const robotlink::Pose2& pose) {
  const auto placed = simulation_.placeModel(robot_, pose);
  if (!placed && requests_.size() < kMaxRequests) {
    requests_.emplace_back(robotlink::arcos::simulator_request::Message{placed.error().text});
  }
}

std::vector<robotlink::arcos::SimulatorRequest> SimulatedPioneer::takeRequests() {
  return std::exchange(requests_, {});
}

void SimulatedPioneer::take(const Packet& packet, Instant now) {
  if (listener_ && !outsideClient_.empty()) listener_(packet, false, now);
  session_.take(packet, now + timeBefore_);
}

std::vector<Packet> SimulatedPioneer::takeOutgoing() {
  std::vector<Packet> packets = session_.takeOutgoing();
  if (listener_ && !outsideClient_.empty()) {
    for (const Packet& packet : packets) listener_(packet, true, now_);
  }
  return packets;
}

void SimulatedPioneer::clientGone(Instant now) {
  session_.clientGone(now + timeBefore_);
}

}  // namespace app
