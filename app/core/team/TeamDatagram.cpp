// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/team/TeamDatagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "robotcontrol/Game.pb.h"
#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

namespace app {
namespace {

constexpr std::uint32_t kTeamMagic = 0x4D544352;  // "RCTM"
constexpr std::uint16_t kTeamVersion = 1;
constexpr std::size_t kMaxNameBytes = 100;

auto damagedTeamMessage(const std::string& what) {
  return robotlink::failure("team.datagram", "a message of a team " + what);
}

/// CRC-32 as in IEEE 802.3, bit by bit: messages are short.
std::uint32_t crcOf(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xFFFFFFFF;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

bool isFiniteMessage(const robotcontrol::TeamMessage& message) {
  const std::array numbers{message.pose_in_field().x(),          message.pose_in_field().y(),
                           message.pose_in_field().heading(),    message.position_deviation(),
                           message.heading_deviation(),          message.ball_in_field().x(),
                           message.ball_in_field().y(),          message.ball_velocity_in_field().x(),
                           message.ball_velocity_in_field().y(), message.ball_deviation(),
                           message.seconds_since_ball_seen(),    message.seconds_to_ball()};
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

bool isName(const std::string& name) {
  return !name.empty() && name.size() <= kMaxNameBytes;
}

}  // namespace

robotlink::Result<std::vector<std::uint8_t>> teamDatagram(const robotcontrol::TeamMessage& message) {
  const std::string text = message.SerializeAsString();
  if (text.size() > kMaxTeamBytes)
    return damagedTeamMessage("is " + std::to_string(text.size()) + " bytes long; at most " +
                              std::to_string(kMaxTeamBytes) + " are sent");
  const std::vector<std::uint8_t> rest(text.begin(), text.end());
  std::vector<std::uint8_t> datagram;
  robotlink::ByteWriter writer(datagram);
  writer.put(kTeamMagic);
  writer.put(kTeamVersion);
  writer.put(static_cast<std::uint16_t>(rest.size()));
  writer.put(crcOf(rest));
  datagram.insert(datagram.end(), rest.begin(), rest.end());
  return datagram;
}

robotlink::Result<std::shared_ptr<const robotcontrol::TeamMessage>> teamMessageIn(
    std::span<const std::uint8_t> datagram) {
  robotlink::ByteReader reader(datagram);
  const auto magic = reader.take<std::uint32_t>();
  const auto version = reader.take<std::uint16_t>();
  const auto length = reader.take<std::uint16_t>();
  const auto crc = reader.take<std::uint32_t>();
  if (!reader.good() || magic != kTeamMagic) return damagedTeamMessage("begins with other bytes");
  if (version != kTeamVersion) return damagedTeamMessage("has version " + std::to_string(version));
  if (length > kMaxTeamBytes || length != reader.rest().size())
    return damagedTeamMessage("has a different length than it states");
  if (crc != crcOf(reader.rest())) return damagedTeamMessage("was damaged on its way");
  auto message = std::make_shared<robotcontrol::TeamMessage>();
  if (!message->ParseFromArray(reader.rest().data(), length)) return damagedTeamMessage("cannot be read");
  if (!isName(message->sender()) || !isName(message->team()))
    return damagedTeamMessage("does not name its sender");
  if (!isFiniteMessage(*message)) return damagedTeamMessage("has values that are not numbers");
  return std::shared_ptr<const robotcontrol::TeamMessage>(std::move(message));
}

}  // namespace app
