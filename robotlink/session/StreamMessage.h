// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotlink {

/// A message of a stream. Its value is immutable and shared: history, views and recorders never copy it.
struct StreamMessage {
  std::string path;  ///< "red1/camera/image"
  /// The time, by the clock of the robot's platform.
  Instant time;
  PackagePtr value;
  /// The process that sent it; empty if it was not one of a robot's processes.
  std::string process = {};
  /// The process's frame (FrameInfo.number); 0 if unknown.
  std::uint64_t frame = 0;
  /// Approximate memory that it holds; 0 if not yet computed.
  std::size_t bytes = 0;
};

/// Approximately how much memory is freed when the message is dropped: the fields of its value and the
/// overhead of storing it.
std::size_t sizeOf(const StreamMessage& message);

}  // namespace robotlink
