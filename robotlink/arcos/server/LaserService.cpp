// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/LaserService.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

constexpr double kUsualIncrement = 1.0;                             // deg
constexpr double kSmallestIncrement = 0.1, kLargestIncrement = 90;  // deg
constexpr int kMaxReadings = 1801;
constexpr std::uint8_t kMovedFlag = 1;
/// Requests of packets: 0 none, 1 one, 2 all the time.
constexpr int kMaxOfRequest = 2;

std::int16_t wrappedMm(double value) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(std::llround(value) & 0xFFFF));
}

}  // namespace

void LaserService::restore() {
  mode_ = Mode::kOff;
  startDeg_ = laser_ ? degrees(laser_->startAngle) : 0;
  endDeg_ = laser_ ? degrees(laser_->endAngle) : 0;
  incrementDeg_ = kUsualIncrement;
  endFollows_ = false;
}

bool LaserService::obey(const Command& command) {
  if (!laser_) return false;
  const int argument = integerArgument(command);
  const auto inField = [this](int angleDeg) {
    return std::clamp<double>(angleDeg, degrees(laser_->startAngle), degrees(laser_->endAngle));
  };
  const auto id = static_cast<CommandId>(command.id);
  const bool legacy = id >= CommandId::kLegacyLaserEnable && id <= CommandId::kLegacyLaserResolution;
  const bool endFollows = legacy && std::exchange(endFollows_, id == CommandId::kLegacyLaserStart);
  // The same ids also request gripper packets (0, 1, 2) and select an analog port.
  if (id == CommandId::kLegacyLaserEnd && !endFollows && argument >= 0 && argument <= kMaxOfRequest)
    return false;
  if (id == CommandId::kLegacyLaserEnable && (argument < 0 || argument > kMaxOfRequest)) return false;
  switch (id) {
    case CommandId::kSimLaserEnable:
    case CommandId::kLegacyLaserEnable:
      mode_ = argument == 0 ? Mode::kOff : argument == 2 ? Mode::kExtended : Mode::kPlain;
      return true;
    case CommandId::kSimLaserStart:
    case CommandId::kLegacyLaserStart:
      startDeg_ = inField(argument);
      return true;
    case CommandId::kSimLaserEnd:
    case CommandId::kLegacyLaserEnd:
      endDeg_ = inField(argument);
      return true;
    case CommandId::kSimLaserResolution:
    case CommandId::kLegacyLaserResolution:
      if (argument > 0) incrementDeg_ = std::clamp(argument / 100.0, kSmallestIncrement, kLargestIncrement);
      return true;
    default:
      return false;
  }
}

int LaserService::readings() const {
  const double field = std::max(0.0, endDeg_ - startDeg_);
  return std::min(kMaxReadings, static_cast<int>(std::floor(field / incrementDeg_ + 1e-6)) + 1);
}

int LaserService::rangeMm(std::span<const double> ranges, int reading) const {
  const double first = degrees(laser_->startAngle), last = degrees(laser_->endAngle);
  const double share = last > first ? (startDeg_ + reading * incrementDeg_ - first) / (last - first) : 0;
  const auto steps = static_cast<double>(ranges.size() - 1);
  const auto nearest = static_cast<std::size_t>(std::clamp(std::round(share * steps), 0.0, steps));
  const double range = std::isfinite(ranges[nearest]) ? ranges[nearest] : laser_->maximum;
  return static_cast<int>(std::lround(std::clamp(range, 0.0, laser_->maximum) * 1000));
}

std::vector<Packet> LaserService::packets(std::span<const double> ranges, const Pose2& odometry,
                                          bool moved) const {
  std::vector<Packet> packets;
  if (!isOn() || ranges.empty()) return packets;
  const int total = readings();
  LaserPacket part;
  part.extended = mode_ == Mode::kExtended;
  part.total = static_cast<std::uint16_t>(total);
  part.xMm = wrappedMm(odometry.x * 1000);
  part.yMm = wrappedMm(odometry.y * 1000);
  part.headingDeg = wrappedMm(degrees(odometry.heading));
  part.flags = moved ? kMovedFlag : 0;
  for (int first = 0; first < total; first += static_cast<int>(LaserPacket::kMaxReadings)) {
    const int end = std::min(total, first + static_cast<int>(LaserPacket::kMaxReadings));
    part.first = static_cast<std::uint16_t>(first);
    part.readings.clear();
    for (int i = first; i < end; ++i) {
      part.readings.push_back({static_cast<std::uint16_t>(std::min(rangeMm(ranges, i), 0xFFFF)), 0, {}});
    }
    packets.push_back(toPacket(part));
  }
  return packets;
}

}  // namespace robotlink::arcos
