// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/ServerSession.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/server/ServerTelemetry.h"

namespace robotlink::arcos {
namespace {

/// Between two sentences of a GPS receiver.
constexpr Duration kPositionPeriod = std::chrono::seconds(1);
constexpr std::uint8_t kSync0 = 0, kSync1 = 1, kSync2 = 2;
/// Clients take packets with these ids for a restart of the controller, and disconnect.
constexpr std::uint8_t kFirstReserved = 0xFE;
constexpr std::size_t kMaxRequests = 64;
constexpr Duration kGyroPeriod = std::chrono::milliseconds(25);
constexpr std::size_t kMaxGyroReadings = 8;
/// Wheels slower than this count as standing; then the drift of a gyroscope must not change the heading.
constexpr double kStandingSpeed = 0.002;  // m/s

}  // namespace

void ServerSession::Subscription::ask(int argument) {
  once = argument == 1;
  always = argument > 1;
}

bool ServerSession::Subscription::take() {
  return std::exchange(once, false) || always;
}

ServerSession::ServerSession(ServerSettings settings)
    : settings_(std::move(settings)),
      motion_(settings_.motion),
      sonars_(settings_.sonars),
      laser_(settings_.laser) {}

void ServerSession::take(const Packet& packet, Instant now) {
  lastHeard_ = now;
  starved_ = false;
  motion_.hold(false);
  if (state_ == State::kWaiting) {
    takeWaiting(packet);
  } else {
    takeConnected(packet);
  }
}

/// SYNC0 and SYNC1 are echoed, SYNC2 is answered. Id 2 without the other two is a CLOSE that some clients
/// send first; id 1 without SYNC0 comes from a client that thinks it is connected.
void ServerSession::takeWaiting(const Packet& packet) {
  if (packet.id == kSync0) {
    syncs_ = 1;
    send({kSync0, {}});
  } else if (packet.id == kSync1 && syncs_ >= 1) {
    syncs_ = 2;
    send({kSync1, {}});
  } else if (packet.id == kSync2 && syncs_ == 2) {
    state_ = State::kIdentified;
    send(toPacket(identityOf(settings_)));
  } else if (packet.id == kSync2) {
    syncs_ = 0;
  }
}

void ServerSession::takeConnected(const Packet& packet) {
  // Before OPEN a client may not know whether the handshake succeeded: it repeats SYNC2 or starts again.
  if (state_ == State::kIdentified && packet.id == kSync0) {
    close();
    takeWaiting(packet);
  } else if (state_ == State::kIdentified && packet.id == kSync2 && packet.data.empty()) {
    send(toPacket(identityOf(settings_)));
  } else if (const auto command = toCommand(packet); command && !obeySimulator(packet)) {
    obey(*command);
  }
}

void ServerSession::open() {
  if (state_ == State::kOpen) return;
  state_ = State::kOpen;
  motion_.setOdometry({});
  nextCycle_ = lastHeard_ + settings_.cycle;
}

void ServerSession::close() {
  state_ = State::kWaiting;
  syncs_ = 0;
  starved_ = false;
  motion_.hold(false);
  motion_.enable(false);
  motion_.restoreParameters();
  sonars_.restore();
  laser_.restore();
  client_ = {};
}

void ServerSession::clientGone(Instant now) {
  gripper_.halt();
  auxiliary_.reset();
  lastHeard_ = now;
  close();
  outgoing_.clear();
}

void ServerSession::robotReset() {
  motion_.reset();
}

bool ServerSession::publishesTruth() const {
  const Subscription& status = client_.subscriptions[kStatus];
  return status.once || status.always;
}

void ServerSession::send(Packet packet) {
  if (packet.id >= kFirstReserved || packet.count() > kMaxSentCount || outgoing_.size() >= kMaxOutgoing) {
    ++dropped_;
    return;
  }
  outgoing_.push_back(std::move(packet));
}

void ServerSession::ask(SimulatorRequest request) {
  if (requests_.size() < kMaxRequests) requests_.push_back(std::move(request));
}

std::vector<Packet> ServerSession::takeOutgoing() {
  return std::exchange(outgoing_, {});
}

std::vector<SimulatorRequest> ServerSession::takeRequests() {
  return std::exchange(requests_, {});
}

void ServerSession::mapLoaded(const std::string& file, bool loaded, bool byUser) {
  if (state_ != State::kOpen) return;
  // If a path is too long for a packet, its end is sent.
  const std::size_t fitting = kMaxSentData - 3;
  MapChanged changed;
  changed.byUser = byUser;
  changed.loaded = loaded;
  changed.file = file.size() > fitting ? file.substr(file.size() - fitting) : file;
  send(toPacket(changed));
}

void ServerSession::checkWatchdog(Instant now) {
  if (!settings_.watchdogStops || state_ == State::kWaiting || starved_) return;
  if (now - lastHeard_ <= settings_.watchdog) return;
  starved_ = true;
  motion_.hold(true);
}

void ServerSession::checkBumpers(const RobotSensing& sensing) {
  const bool front = (client_.bumpStall & 1) != 0 && sensing.frontBumpers != 0;
  const bool rear = (client_.bumpStall & 2) != 0 && sensing.rearBumpers != 0;
  if (front || rear) motion_.stall(true, true);
}

MotionController::Wheels ServerSession::wheelsOf(const RobotSensing& sensing) const {
  MotionController::Wheels wheels{
      sensing.leftTravel, sensing.rightTravel, sensing.leftBlocked, sensing.rightBlocked, {}};
  if (settings_.gyroscope == ServerSettings::Gyroscope::kRobot && client_.gyroUsed) {
    const bool standing =
        std::abs(sensing.leftSpeed) < kStandingSpeed && std::abs(sensing.rightSpeed) < kStandingSpeed;
    wheels.rotationRate = standing ? 0 : sensing.rotationRate;
  }
  return wheels;
}

WheelCommand ServerSession::step(const RobotSensing& sensing, RangeFinders& ranges, Instant now) {
  const Duration passed = now - lastStep_.value_or(now);
  lastStep_ = now;
  checkWatchdog(now);
  if (sensing.stopButton) motion_.enable(false);
  const WheelCommand command = motion_.step(wheelsOf(sensing), passed);
  checkBumpers(sensing);
  if (settings_.gripper) gripperCommand_ = gripper_.step(sensing.gripper, passed);
  if (state_ != State::kOpen) return command;
  serveAuxiliary(sensing, now);
  fireSonars(ranges, now);
  readGyroscope(sensing, now);
  if (now >= nextCycle_) {
    // Missed cycles are not repeated.
    nextCycle_ += settings_.cycle * ((now - nextCycle_) / settings_.cycle + 1);
    sendCycle(sensing, ranges);
  }
  return command;
}

void ServerSession::serveAuxiliary(const RobotSensing& sensing, Instant now) {
  if (sensing.gps && now >= nextPosition_) {
    auxiliary_.receive(ggaSentence(*sensing.gps, now.time_since_epoch()));
    nextPosition_ = now + kPositionPeriod;
  }
  if (const auto packet = auxiliary_.take()) send(toPacket(*packet));
}

void ServerSession::fireSonars(RangeFinders& ranges, Instant now) {
  if (settings_.allSonarsEachCycle) return;
  for (const int disc : sonars_.due(now)) client_.newSonars[disc] = ranges.sonar(disc);
}

void ServerSession::readGyroscope(const RobotSensing& sensing, Instant now) {
  if (now < client_.nextGyroReading || !subscription(kGyro).always) return;
  // Clients take each reading as the rate over one period, so on average there must be exactly one a period.
  client_.nextGyroReading = std::max(client_.nextGyroReading + kGyroPeriod, now);
  if (client_.gyroReadings.size() < kMaxGyroReadings) client_.gyroReadings.push_back(gyroReadingOf(sensing));
}

void ServerSession::sendCycle(const RobotSensing& sensing, RangeFinders& ranges) {
  if (settings_.allSonarsEachCycle) {
    for (const int disc : sonars_.all()) client_.newSonars[disc] = ranges.sonar(disc);
  }
  // Clients expect gyroscope and joystick before the information packet, everything else after it.
  if (subscription(kGyro).take()) send(toPacket(GyroPacket{std::exchange(client_.gyroReadings, {}), {}}));
  if (subscription(kJoystick).take()) send(toPacket(JoystickPacket{}));
  const ServerReport report{std::exchange(client_.newSonars, {}),
                            client_.testedBattery.value_or(sensing.battery), client_.digitalOut,
                            settings_.gripper ? gripper_.state() : std::uint8_t{0}};
  send(toPacket(informationOf(settings_, sensing, motion_, sonars_, report)));
  if (subscription(kIo).take()) send(toPacket(ioOf(settings_, sensing, report)));
  sendRequested(sensing);
  if (!laser_.isOn()) return;
  for (Packet& part : laser_.packets(ranges.laser(), motion_.odometry(), motion_.moving()))
    send(std::move(part));
}

void ServerSession::sendRequested(const RobotSensing& sensing) {
  if (subscription(kEncoder).take()) send(toPacket(encodersOf(settings_, sensing)));
  if (subscription(kImu).take()) send(toPacket(imuOf(sensing)));
  if (subscription(kBattery).take()) send(toPacket(batteryOf(sensing)));
  if (subscription(kGripper).take()) {
    // The type 2 is one at the robot's general inputs and outputs.
    const GripperPacket present{2, gripper_.switches(), gripper_.graspTime(), {}};
    send(toPacket(settings_.gripper ? present : GripperPacket{}));
  }
  if (subscription(kStatus).take()) send(toPacket(statusOf(settings_, sensing)));
}

}  // namespace robotlink::arcos
