// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/PioneerClient.h"

#include <array>

#include "robotlink/arcos/WireUnits.h"

namespace robotlink::arcos {
namespace {

/// A packet whose rest has not arrived after this time is given up.
constexpr Duration kPartialTime = std::chrono::milliseconds(100);
/// The arguments of the laser's commands: a reading each degree, and packets with reflectances.
constexpr int kEachDegree = 100, kExtendedPackets = 2;

}  // namespace

PioneerClient::PioneerClient(Listener& listener, const ClientSession::Options& options)
    : listener_(listener), options_(options), session_(options), decoder_(robotType({})) {}

void PioneerClient::reset() {
  parser_ = {};
  session_ = ClientSession(options_);
  decoder_ = StateDecoder(robotType({}));
  scan_.reset();
  connected_ = false;
}

void PioneerClient::linkOpened(Instant now) {
  parser_.clear();
  session_.linkOpened(now);
}

void PioneerClient::tick(Instant now) {
  session_.tick(now);
  if (session_.isConnected() == connected_) return;
  connected_ = !connected_;
  listener_.connectionChanged(connected_, now);
}

void PioneerClient::take(std::span<const std::uint8_t> bytes, Instant now) {
  parser_.push(bytes);
  while (const auto found = parser_.next()) {
    if (const auto* packet = std::get_if<Packet>(&*found)) {
      listener_.packetPassed(Direction::kFromRobot, *packet, parser_.frame(), now);
      use(session_.take(*packet, now), now);
    } else {
      const DamagedBytes& damage = std::get<DamagedBytes>(*found);
      listener_.damageCame(damage, now);
      session_.take(damage, now);
    }
  }
}

void PioneerClient::take(const Packet& packet, Instant now) {
  listener_.packetPassed(Direction::kFromRobot, packet, {}, now);
  use(session_.take(packet, now), now);
}

void PioneerClient::overhear(const Packet& packet, Direction direction, Instant now) {
  listener_.packetPassed(direction, packet, {}, now);
  if (direction == Direction::kFromRobot) use(session_.overhear(packet, now), now);
}

void PioneerClient::lineSilent(Duration duration) {
  if (duration >= kPartialTime && parser_.isPartial()) parser_.dropPartial();
}

void PioneerClient::use(ClientSession::News news, Instant now) {
  switch (news) {
    case ClientSession::News::kNothing:
      break;
    case ClientSession::News::kIdentity:
      decoder_ = StateDecoder(robotType(session_.identity()->subclass));
      listener_.robotIdentified();
      break;
    case ClientSession::News::kConfiguration:
      listener_.configurationCame(*session_.configuration());
      break;
    case ClientSession::News::kInformation:
      decoder_.take(*session_.information(), now);
      listener_.stateCame(*session_.information(), now);
      break;
    case ClientSession::News::kScan:
      scan_ = toRangeScan(*session_.laserScan());
      listener_.scanCame(*scan_);
      break;
  }
}

RangeScan PioneerClient::toRangeScan(const LaserScan& laser) const {
  RangeScan scan;
  scan.time = laser.takenAt;
  scan.robot = decoder_.odometryAt(laser.xMm, laser.yMm, radians(laser.headingDeg));
  scan.laserInRobot = decoder_.type().laserInRobot;
  scan.startAngle = scanStart_;
  const std::size_t count = laser.rangesMm.size();
  if (count > 1) scan.angleStep = (scanEnd_ - scanStart_) / static_cast<double>(count - 1);
  scan.ranges.reserve(count);
  for (const std::uint16_t range : laser.rangesMm) scan.ranges.push_back(range / 1000.0);
  return scan;
}

Result<void> PioneerClient::resetOdometry(Instant now) {
  decoder_.expectReset(now);
  return send(command(CommandId::kSetO), now);
}

Result<void> PioneerClient::startLaser(double startAngle, double endAngle, LaserCommands commands,
                                       Instant now) {
  const bool legacy = commands == LaserCommands::kLegacy;
  const std::array asked{
      command(legacy ? CommandId::kLegacyLaserStart : CommandId::kSimLaserStart, inDegrees(startAngle)),
      command(legacy ? CommandId::kLegacyLaserEnd : CommandId::kSimLaserEnd, inDegrees(endAngle)),
      command(legacy ? CommandId::kLegacyLaserResolution : CommandId::kSimLaserResolution, kEachDegree),
      command(legacy ? CommandId::kLegacyLaserEnable : CommandId::kSimLaserEnable, kExtendedPackets)};
  for (const Command& each : asked) {
    if (const auto sent = send(each, now); !sent) return sent;
  }
  scanStart_ = startAngle;
  scanEnd_ = endAngle;
  return {};
}

Result<void> PioneerClient::stopLaser(Instant now) {
  scan_.reset();
  return send(command(CommandId::kSimLaserEnable, 0), now);
}

std::vector<Packet> PioneerClient::takeOutgoing(Instant now) {
  std::vector<Packet> packets = session_.takePackets();
  for (const Packet& packet : packets) listener_.packetPassed(Direction::kFromClient, packet, {}, now);
  return packets;
}

std::vector<Bytes> PioneerClient::takeOutgoingFrames(Instant now) {
  std::vector<Bytes> frames;
  for (const Packet& packet : session_.takePackets()) {
    frames.push_back(encode(packet));
    listener_.packetPassed(Direction::kFromClient, packet, frames.back(), now);
  }
  return frames;
}

bool PioneerClient::isSimulated() const {
  const Configuration* configuration = session_.configuration();
  const Identity* identity = session_.identity();
  return (configuration != nullptr && configuration->serialNumber == "SIM") ||
         (identity != nullptr && identity->name == "MobileSim");
}

}  // namespace robotlink::arcos
