// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace logplayer::bhuman {

/// The kinds of messages of B-Human's queues of 2009 that are read here; the first byte of each message.
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

constexpr std::uint8_t idOf(Kind kind) {
  return static_cast<std::uint8_t>(kind);
}

/// "JPEGImage"; "id 123" where the code of 2009 has no name.
std::string kindName(std::uint8_t id);
bool hasName(std::uint8_t id);
/// Bytes of the payload, of kinds that always have as many.
std::optional<std::uint32_t> fixedSize(std::uint8_t id);

}  // namespace logplayer::bhuman
