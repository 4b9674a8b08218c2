// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerDriver.h"

#include <algorithm>
#include <cmath>

#include "robotlink/arcos/WireUnits.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/MapPackages.h"
#include "robotlink/packages/Packages.h"

namespace app {

namespace arcos = robotlink::arcos;
using arcos::CommandId;
using robotlink::Blocking;
using robotlink::Duration;
using robotlink::Instant;

namespace {

/// Interval in which unchanged speeds are repeated, as ARIA does.
constexpr Duration kRepeat = std::chrono::milliseconds(500);
constexpr Duration kStatusPeriod = std::chrono::milliseconds(500);

/// Splits bytes that the user wants to send; they must be whole packets and nothing else.
robotlink::Result<std::vector<arcos::Packet>> packetsOf(const std::string& bytes) {
  arcos::PacketParser parser;
  parser.push({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  std::vector<arcos::Packet> packets;
  while (auto found = parser.next()) {
    if (auto* packet = std::get_if<arcos::Packet>(&*found)) {
      packets.push_back(std::move(*packet));
    } else {
      return robotlink::failure("drive.packet",
                                std::string("the bytes to send hold no packet: ") +
                                    arcos::describe(std::get<arcos::DamagedBytes>(*found).kind));
    }
  }
  if (parser.isPartial()) return robotlink::failure("drive.packet", "the bytes to send end within a packet");
  return packets;
}

/// Returns " MobileSim (p3at-sh)", or an empty text before the robot has reported its identity.
std::string robotNameOf(const arcos::ClientSession& session) {
  const auto* identity = session.identity();
  return identity != nullptr ? " " + identity->name + " (" + identity->subclass + ")" : std::string();
}

/// The gripper's package; null if the robot sent nothing of it.
std::shared_ptr<const robotcontrol::GripperState> gripperPackage(const arcos::RobotState& state,
                                                                 Instant now) {
  if (!state.gripper) return nullptr;
  auto gripper = std::make_shared<robotcontrol::GripperState>();
  robotlink::assign(*gripper->mutable_timestamp(), now);
  gripper->set_open(state.gripper->open);
  gripper->set_closed(state.gripper->closed);
  gripper->set_moving(state.gripper->moving);
  gripper->set_lift_up(state.gripper->liftUp);
  gripper->set_lift_down(state.gripper->liftDown);
  gripper->set_lift_moving(state.gripper->liftMoving);
  return gripper;
}

robotcontrol::LinkStatus::State stateOf(const arcos::ClientSession& session) {
  using robotcontrol::LinkStatus;
  switch (session.state()) {
    case arcos::ClientSession::State::kClosed:
      return LinkStatus::CLOSED;
    case arcos::ClientSession::State::kConnected:
      return LinkStatus::CONNECTED;
    case arcos::ClientSession::State::kFailed:
    case arcos::ClientSession::State::kPausing:
      return LinkStatus::LOST;
    default:
      return LinkStatus::CONNECTING;
  }
}

}  // namespace

PioneerDriver::PioneerDriver(robotlink::Process& platform, std::string robot,
                             const robotlink::RobotDescription& description, Options options)
    : options_(std::move(options)),
      description_(description),
      packages_(std::move(robot), description),
      motorsWanted_(options_.motorsOn),
      stateSender_(platform, robotlink::kDriveState.name, Blocking::kNo),
      sonarSender_(platform, robotlink::kSonar.name, Blocking::kNo),
      laserSender_(platform, robotlink::kLaser.name, Blocking::kNo),
      gripperSender_(platform, robotlink::kGripper.name, Blocking::kNo),
      statusSender_(platform, robotlink::kLinkStatus.name, Blocking::kNo),
      packetsSender_(platform, robotlink::kLinkPackets.name, Blocking::kNo),
      request_(platform, robotlink::kDriveRequest.name, Blocking::kNo) {
  client_.open(platform.clock().now());
}

// ---- From the robot

void PioneerDriver::lineOpened(Instant now) {
  lineOpened_ = now;
  client_.linkOpened(now);
}

void PioneerDriver::lineLost(const robotlink::Error& why, Instant now) {
  client_.linkClosed(why, now);
}

void PioneerDriver::take(std::span<const std::uint8_t> bytes, Instant now) {
  lastBytes_ = now;
  client_.take(bytes, now);
}

void PioneerDriver::take(const arcos::Packet& packet, Instant now) {
  client_.take(packet, now);
}

void PioneerDriver::overhear(const arcos::Packet& packet, bool fromRobot, Instant now) {
  client_.overhear(packet, fromRobot ? arcos::Direction::kFromRobot : arcos::Direction::kFromClient, now);
}

void PioneerDriver::setOtherClient(const std::string& address, Instant now) {
  if (address == otherClient_) return;
  otherClient_ = address;
  if (address.empty()) {
    client_.open(now);
  } else {
    client_.close(now);
    // Drop the closing packets: the line belongs to the other client now.
    client_.dropOutgoing();
  }
}

void PioneerDriver::packetPassed(arcos::Direction direction, const arcos::Packet& packet,
                                 std::span<const std::uint8_t> frame, Instant now) {
  meter_.packet(direction == arcos::Direction::kFromRobot, packet, frame, now);
}

void PioneerDriver::damageCame(const arcos::DamagedBytes& damage, Instant now) {
  meter_.damage(damage.bytes, now);
}

void PioneerDriver::configurationCame(const arcos::Configuration& configuration) {
  hasGripper_ = configuration.gripper != 0;
  packages_.setBumpers(configuration.frontBumpers, configuration.rearBumpers);
  packages_.setBattery(configuration.lowBatteryDecivolts / 10.0, configuration.shutdownDecivolts / 10.0);
}

void PioneerDriver::stateCame(const arcos::StandardInformation& information, Instant now) {
  meter_.cycle(now);
  state_ = packages_.state(client_.state(), information, now);
  if (hasGripper_ == true) gripper_ = gripperPackage(client_.state(), now);
  if (auto sonars = packages_.sonars(information, client_.type().range, now)) sonars_ = std::move(sonars);
}

void PioneerDriver::scanCame(const arcos::RangeScan& scan) {
  laser_ = packages_.laser(scan);
}

void PioneerDriver::takeScan(const arcos::RangeScan& scan) {
  auto message = packages_.laser(scan);
  if (message == nullptr) return;
  // Its own angles, not those of the laser that the robot is described with.
  auto own = std::make_shared<foxglove::LaserScan>(*message);
  own->set_start_angle(scan.startAngle);
  own->set_end_angle(scan.angle(scan.ranges.empty() ? 0 : scan.ranges.size() - 1));
  laser_ = std::move(own);
}

// ---- To the robot

void PioneerDriver::command(CommandId id, int argument, Instant now) {
  // Without a connection the command is dropped; setUp() sends what is still valid.
  if (client_.isConnected()) (void)client_.send(arcos::command(id, argument), now);
}

void PioneerDriver::actuate(bool stopEngaged, Instant now) {
  client_.lineSilent(now - lastBytes_);
  client_.tick(now);
  if (stopEngaged != held_) {
    held_ = stopEngaged;
    driving_ = false;
    // Requests made before STOP do not count after it.
    if (held_) requestCame_.reset();
    if (held_) command(CommandId::kEStop, 0, now);
    command(CommandId::kEnable, !held_ && motorsWanted_ ? 1 : 0, now);
  }
  if (!held_) drive(now);
}

void PioneerDriver::connectionChanged(bool connected, Instant now) {
  if (connected) {
    setUp(now);
  } else {
    packages_.restart();
    meter_.restart();
  }
}

void PioneerDriver::setUp(Instant now) {
  driving_ = false;
  command(CommandId::kSonar, 1, now);
  const bool laser = options_.laser && description_.laser && client_.isSimulated();
  if (laser) {
    (void)client_.startLaser(description_.laser->startAngle, description_.laser->endAngle,
                             arcos::PioneerClient::LaserCommands::kLegacy, now);
  }
  const bool motors = motorsWanted_ && !held_;
  if (motors) command(CommandId::kEnable, 1, now);
  const auto milliseconds = static_cast<long>(std::lround(1000 * robotlink::seconds(now - lineOpened_)));
  report_ = "The robot" + robotNameOf(session()) + " was set up in " + std::to_string(milliseconds) +
            " ms: sonars on, " + (laser ? "laser on, " : "") + "motors " + (motors ? "on." : "off.");
}

void PioneerDriver::drive(Instant now) {
  const robotcontrol::DriveRequest* request = request_.get();
  if (request != nullptr && request_.isNew()) requestCame_ = now;
  if (request == nullptr || !requestCame_ || now - *requestCame_ > kSilence) {
    if (driving_) command(CommandId::kStop, 0, now);
    driving_ = false;
    return;
  }
  const auto& limits = *description_.drive;
  const auto limited = [](double value, double limit) {
    return std::isfinite(value) ? std::clamp(value, -limit, limit) : 0.0;
  };
  const int speedMmS = arcos::inMillimeters(limited(request->velocity().x(), limits.maximumSpeed));
  const int rotationDegS = arcos::inDegrees(limited(request->velocity().rotation(), limits.maximumRotation));
  const bool same = driving_ && speedMmS == speedMmS_ && rotationDegS == rotationDegS_;
  if (same && now - commandSent_ < kRepeat) return;
  command(CommandId::kVel, speedMmS, now);
  command(CommandId::kRvel, rotationDegS, now);
  speedMmS_ = speedMmS;
  rotationDegS_ = rotationDegS;
  commandSent_ = now;
  driving_ = true;
}

robotlink::Result<void> PioneerDriver::control(const robotcontrol::ControlDrive& details, Instant now) {
  if (!client_.isConnected()) {
    return robotlink::failure("drive.not-connected",
                              otherClient_.empty() ? "the robot is not connected: " + session().describe()
                                                   : "a client at " + otherClient_ + " drives the robot now");
  }
  std::vector<arcos::Packet> packets;
  for (const std::string& bytes : details.packets()) {
    auto found = packetsOf(bytes);
    if (!found) return tl::unexpected(found.error());
    packets.insert(packets.end(), found->begin(), found->end());
  }
  const auto moves = [](const arcos::Packet& packet) {
    return packet.id == static_cast<std::uint8_t>(CommandId::kGripper);
  };
  if (hasGripper_ == false && std::ranges::any_of(packets, moves))
    return robotlink::failure("drive.no-gripper", "the robot has no gripper");
  if (details.has_motors()) {
    if (details.motors() && held_)
      return robotlink::failure("drive.stopped", "STOP is engaged; release it first");
    motorsWanted_ = details.motors();
    command(CommandId::kEnable, details.motors() ? 1 : 0, now);
  }
  if (details.has_sonar()) command(CommandId::kSonar, details.sonar() ? 1 : 0, now);
  if (details.reset_odometry()) packages_.resetOdometry();
  for (const arcos::Packet& packet : packets) {
    if (auto sent = client_.send(packet, now); !sent) return sent;
  }
  return {};
}

// ---- To the program

std::vector<robotlink::AnySender*> PioneerDriver::senders() {
  return {&stateSender_, &sonarSender_, &laserSender_, &gripperSender_, &statusSender_, &packetsSender_};
}

void PioneerDriver::sendPackages(Instant now) {
  meter_.setKeeping(packetsSender_.connected());
  if (state_) stateSender_.send(std::exchange(state_, nullptr));
  if (sonars_) sonarSender_.send(std::exchange(sonars_, nullptr));
  if (gripper_) gripperSender_.send(std::exchange(gripper_, nullptr));
  if (laser_) laserSender_.send(std::exchange(laser_, nullptr));
  if (auto packets = meter_.takePackets(now)) packetsSender_.send(std::move(packets));
  if (statusSent_ == Instant{} || now - statusSent_ >= kStatusPeriod) sendStatus(now);
}

void PioneerDriver::sendStatus(Instant now) {
  statusSent_ = now;
  auto status = std::make_shared<robotcontrol::LinkStatus>();
  robotlink::assign(*status->mutable_timestamp(), now);
  status->set_state(otherClient_.empty() ? stateOf(session()) : robotcontrol::LinkStatus::CONNECTED);
  status->set_address(options_.address);
  status->set_client(otherClient_);
  if (const arcos::Identity* identity = session().identity()) {
    status->set_robot_name(identity->name);
    status->set_robot_class(identity->robotClass);
    status->set_robot_subclass(identity->subclass);
  }
  meter_.fill(*status, now);
  status->set_checksum_errors(client_.received().checksumErrors);
  status->set_skipped_bytes(client_.received().skippedBytes);
  const auto& statistics = session().statistics();
  status->set_round_trip(robotlink::seconds(statistics.roundTrip));
  status->set_reconnects(statistics.connections > 0 ? statistics.connections - 1 : 0);
  std::string text = otherClient_.empty() ? session().describe() : "driven by a client at " + otherClient_;
  if (!laserText_.empty()) text += "; " + laserText_;
  status->set_text(std::move(text));
  statusSender_.send(std::move(status));
}

}  // namespace app
