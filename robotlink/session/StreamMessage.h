// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"

namespace robotlink {

/// One message of a stream. Its value is immutable and shared: history, views and recorders never copy it.
struct StreamMessage {
  std::string path;  ///< "red1/camera/image"
  Instant time;      ///< of the robot's platform
  PackagePtr value;
  std::string process = {};  ///< that told it; empty if it was none of a robot's processes
  std::uint64_t frame = 0;   ///< of that process, FrameInfo.number; 0 if it is not known
  std::size_t bytes = 0;     ///< about what it occupies; 0: not yet known
};

/// About how much memory a message keeps from being freed: the fields of its value and the cost of keeping
/// it.
std::size_t sizeOf(const StreamMessage& message);

}  // namespace robotlink
