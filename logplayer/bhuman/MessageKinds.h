// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace logplayer::bhuman {

/// The supported kinds of messages in B-Human's queues of 2009: the first byte of each message.
enum class Kind : std::uint8_t {
  kProcessBegin = 1,
  kProcessFinished = 2,
  kImage = 3,
  kJpegImage = 4,
  kJointData = 5,
  kSensorData = 6,
  kKeyStates = 7,
  kOdometryData = 8,
  kCameraMatrix = 17,
  kImageCoordinateSystem = 18,
  kText = 36,
};

/// The first byte of a message of this kind.
constexpr std::uint8_t idOf(Kind kind) {
  return static_cast<std::uint8_t>(kind);
}

/// Name of a kind in the code of 2009, such as "JPEGImage"; "id 123" if it has none.
std::string kindName(std::uint8_t id);
/// Whether the id exists in the code of 2009.
bool hasName(std::uint8_t id);
/// Size of the payload in bytes, for kinds whose size never varies.
std::optional<std::uint32_t> fixedSize(std::uint8_t id);

}  // namespace logplayer::bhuman
