// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "robotlink/arcos/stream/ByteStream.h"

namespace robotlink::arcos {

/// A pair of lines connected in memory: what is written to one is read from the other. Each direction holds
/// kMemoryStreamBytes; a write that does not fit is refused as a whole ("stream.busy"). When an end is closed
/// or destroyed, the other end still reads the remaining bytes, then gets "stream.lost". `name` is the
/// address of both.
inline constexpr std::size_t kMemoryStreamBytes = 1 << 20;
std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> memoryStreams(
    const std::string& name = "memory");

}  // namespace robotlink::arcos
