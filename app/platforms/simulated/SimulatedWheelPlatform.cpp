// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedWheelPlatform.h"

#include <algorithm>
#include <cmath>

#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"

namespace app {

using robotlink::Blocking;
using robotlink::Instant;
using simcore::RangeSensor;

namespace {

/// Returns the next instant of a period without drift. Missed instants are skipped.
Instant dueAfter(Instant due, robotlink::Duration period, Instant now) {
  return std::max(due + period, now);
}

}  // namespace

SimulatedWheelPlatform::SimulatedWheelPlatform(SimulatedWorld& world, std::string robot,
                                               const robotlink::RobotDescription& description)
    : SimulatedPlatform(world, std::move(robot)),
      description_(description),
      state_(*this, robotlink::kDriveState.name, Blocking::kNo),
      sonar_(*this, robotlink::kSonar.name, Blocking::kNo),
      laser_(*this, robotlink::kLaser.name, Blocking::kNo),
      request_(*this, robotlink::kDriveRequest.name, Blocking::kNo) {}

robotlink::Result<std::unique_ptr<SimulatedPlatform>> SimulatedWheelPlatform::create(
    SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description) {
  auto platform = std::unique_ptr<SimulatedWheelPlatform>(
      new SimulatedWheelPlatform(world, std::move(robot), description));
  if (auto bound = platform->bind(); !bound) return tl::unexpected(bound.error());
  return platform;
}

robotlink::Error SimulatedWheelPlatform::lacks(const std::string& what) const {
  return {"platform.drive",
          "robot " + robot() + " has no " + what + ", which its description " + description_.name +
              " names; correct the model or resources/robots/" + description_.name + ".yaml",
          {robot(), what},
          {world().simulation().scene().file().string(), 0, 0}};
}

robotlink::Result<void> SimulatedWheelPlatform::bind() {
  const simcore::Simulation& simulation = world().simulation();
  const auto drives = simulation.drives();
  const auto own = [this](const auto& port) { return port.info.robot == robot(); };
  const auto drive = std::ranges::find_if(drives, own);
  if (drive == drives.end()) return tl::unexpected(lacks("drive"));
  drive_ = static_cast<std::size_t>(drive - drives.begin());
  const auto ranges = simulation.rangeSensors();
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!own(ranges[i])) continue;
    if (ranges[i].kind == RangeSensor::Kind::kSonar) sonarRangers_.push_back(rangerAt(i));
    if (ranges[i].kind == RangeSensor::Kind::kLaser && !laserRanger_) laserRanger_ = rangerAt(i);
  }
  if (description_.laser && !laserRanger_) return tl::unexpected(lacks("laser"));
  const std::size_t described = description_.sonars ? description_.sonars->sensors.size() : 0;
  if (sonarRangers_.size() < described) return tl::unexpected(lacks(std::to_string(described) + " sonars"));
  sonarRangers_.resize(described);
  if (laserRanger_) scan_.resize(static_cast<std::size_t>(ranges[laserRanger_->port].readings));
  const auto sensors = simulation.sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (own(sensors[i]) && sensors[i].info.type == "angular_velocity") gyroscope_ = i;
  }
  const simcore::WheelState& wheels = simulation.wheelState(drive_);
  stateDue_ = clock().now();
  leftTravel_ = wheels.leftTravel;
  rightTravel_ = wheels.rightTravel;
  return {};
}

bool SimulatedWheelPlatform::rebind() {
  const simcore::Simulation& simulation = world().simulation();
  const auto own = [this](const auto& port) { return port.info.robot == robot(); };
  const auto drive = std::ranges::find_if(simulation.drives(), own);
  if (drive == simulation.drives().end()) return false;
  drive_ = static_cast<std::size_t>(drive - simulation.drives().begin());
  const auto ranges = simulation.rangeSensors();
  std::size_t sonars = 0;
  bool hasLaser = false;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!own(ranges[i])) continue;
    if (ranges[i].kind == RangeSensor::Kind::kSonar && sonars < sonarRangers_.size())
      sonarRangers_[sonars++].port = i;
    if (ranges[i].kind != RangeSensor::Kind::kLaser || hasLaser) continue;
    hasLaser = true;
    if (!laserRanger_ || scan_.size() != static_cast<std::size_t>(ranges[i].readings)) return false;
    laserRanger_->port = i;
  }
  const bool hadGyroscope = gyroscope_.has_value();
  gyroscope_.reset();
  const auto sensors = simulation.sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (own(sensors[i]) && sensors[i].info.type == "angular_velocity") gyroscope_ = i;
  }
  return hasLaser == laserRanger_.has_value() && sonars == sonarRangers_.size() &&
         hadGyroscope == gyroscope_.has_value();
}

SimulatedWheelPlatform::Ranger SimulatedWheelPlatform::rangerAt(std::size_t port) const {
  const robotlink::Duration period = world().simulation().rangeSensors()[port].period;
  return {port, period > robotlink::Duration::zero() ? period : kCycle, clock().now()};
}

// ---- From the program

void SimulatedWheelPlatform::actuate() {
  const Instant now = clock().now();
  const robotcontrol::DriveRequest* request = request_.get();
  if (request != nullptr && request_.isNew()) requestCame_ = now;
  const bool obeys = request != nullptr && now - requestCame_ <= kSilence && motorsOn_ && !mustStand();
  const auto finite = [](double value) { return std::isfinite(value) ? value : 0.0; };
  if (mustStand() || !motorsOn_) forward_ = rotation_ = 0;
  approach(obeys ? finite(request->velocity().x()) : 0, obeys ? finite(request->velocity().rotation()) : 0);
  const double rim = rotation_ * description_.drive->track / 2;
  world().simulation().requestWheelSpeeds(drive_, forward_ - rim, forward_ + rim);
}

void SimulatedWheelPlatform::approach(double forward, double rotation) {
  const auto& drive = *description_.drive;
  const double step = robotlink::seconds(SimulatedWorld::kStep);
  const auto next = [step](double from, double to, double limit, double acceleration) {
    return from + std::clamp(std::clamp(to, -limit, limit) - from, -acceleration * step, acceleration * step);
  };
  forward_ = next(forward_, forward, drive.maximumSpeed, drive.acceleration);
  rotation_ = next(rotation_, rotation, drive.maximumRotation, drive.rotationAcceleration);
}

robotlink::Result<void> SimulatedWheelPlatform::control(const robotcontrol::ControlDrive& details) {
  if (details.packets_size() > 0) {
    return robotlink::failure("drive.no-controller", robot() + " has no microcontroller to send packets to",
                              {}, {robot()});
  }
  if (details.has_motors()) {
    if (details.motors() && stopEngaged())
      return robotlink::failure("drive.stopped", "STOP is engaged; release it first");
    motorsOn_ = details.motors();
  }
  if (details.has_sonar()) sonarsOn_ = details.sonar();
  if (details.reset_odometry()) odometry_ = {};
  return {};
}

// ---- To the program

void SimulatedWheelPlatform::execute() {
  followOdometry();
  const Instant now = clock().now();
  if (now >= stateDue_) {
    stateDue_ = dueAfter(stateDue_, kCycle, now);
    sendState();
  }
  sendSonars();
  sendLaser();
  sendOracle();
  exchangeGame();
}

// Like encoders, this does not notice slip.
void SimulatedWheelPlatform::followOdometry() {
  const simcore::WheelState& wheels = world().simulation().wheelState(drive_);
  const double left = wheels.leftTravel - std::exchange(leftTravel_, wheels.leftTravel);
  const double right = wheels.rightTravel - std::exchange(rightTravel_, wheels.rightTravel);
  const double turn = (right - left) / description_.drive->track;
  const double way = (left + right) / 2;
  const double heading = odometry_.heading + turn / 2;
  odometry_.x += way * std::cos(heading);
  odometry_.y += way * std::sin(heading);
  odometry_.heading += turn;
}

void SimulatedWheelPlatform::sendState() {
  const simcore::WheelState& wheels = world().simulation().wheelState(drive_);
  auto state = std::make_shared<robotcontrol::DriveState>();
  robotlink::assign(*state->mutable_timestamp(), clock().now());
  robotlink::assign(*state->mutable_odometry(), odometry_);
  state->set_left_speed(wheels.leftSpeed);
  state->set_right_speed(wheels.rightSpeed);
  state->mutable_velocity()->set_x((wheels.leftSpeed + wheels.rightSpeed) / 2);
  state->mutable_velocity()->set_rotation((wheels.rightSpeed - wheels.leftSpeed) / description_.drive->track);
  state->set_motors_on(motorsOn_ && !stopEngaged());
  state->set_sonar_on(sonarsOn_ && !sonarRangers_.empty());
  state->set_left_stalled(wheels.leftBlocked);
  state->set_right_stalled(wheels.rightBlocked);
  state->set_emergency_stop(stopEngaged());
  if (gyroscope_) state->set_rotation_rate(world().simulation().sensors()[*gyroscope_].values.at(2));
  state_.send(std::move(state));
}

void SimulatedWheelPlatform::sendSonars() {
  if (sonarRangers_.empty() || !sonarsOn_) return;
  const Instant now = clock().now();
  auto readings = std::make_shared<robotcontrol::SonarReadings>();
  for (std::size_t i = 0; i < sonarRangers_.size(); ++i) {
    if (now < sonarRangers_[i].due) continue;
    sonarRangers_[i].due = dueAfter(sonarRangers_[i].due, sonarRangers_[i].period, now);
    double range = 0;
    world().simulation().measure(sonarRangers_[i].port, {&range, 1});
    auto& reading = *readings->add_readings();
    reading.set_number(static_cast<std::uint32_t>(i));
    robotlink::assign(*reading.mutable_sensor_in_robot(), description_.sonars->sensors[i].inRobot);
    reading.set_range(std::min(range, description_.sonars->maximum));
    robotlink::assign(*reading.mutable_timestamp(), now);
  }
  if (readings->readings_size() == 0) return;
  robotlink::assign(*readings->mutable_timestamp(), now);
  readings->set_opening_angle(description_.sonars->openingAngle);
  readings->set_maximum(description_.sonars->maximum);
  sonar_.send(std::move(readings));
}

void SimulatedWheelPlatform::sendLaser() {
  const Instant now = clock().now();
  if (!laserRanger_ || !description_.laser || now < laserRanger_->due) return;
  laserRanger_->due = dueAfter(laserRanger_->due, laserRanger_->period, now);
  world().simulation().measure(laserRanger_->port, scan_);
  const RangeSensor& port = world().simulation().rangeSensors()[laserRanger_->port];
  const robotlink::Pose2& place = description_.laser->inRobot;
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  pose.translate(robotlink::Vector3(place.x, place.y, 0));
  pose.rotate(Eigen::AngleAxisd(place.heading, robotlink::Vector3::UnitZ()));
  auto scan = std::make_shared<foxglove::LaserScan>();
  robotlink::assign(*scan->mutable_timestamp(), now);
  scan->set_frame_id(robot());
  robotlink::assign(*scan->mutable_pose(), pose);
  scan->set_start_angle(port.startAngle);
  scan->set_end_angle(port.endAngle);
  for (const double range : scan_) scan->add_ranges(range);
  laser_.send(std::move(scan));
}

}  // namespace app
