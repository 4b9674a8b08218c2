// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "robotlink/arcos/stream/ByteStream.h"

namespace robotlink::arcos {

/// Two lines joined in memory: what is written to one is read from the other. For tests, and for programs
/// that have both ends. Each direction holds kMemoryStreamBytes; what does not fit is refused at once
/// ("stream.busy"), none of it is written. When an end is closed or destroyed, the other still reads what is
/// under way, then "stream.lost". `name` is their address.
inline constexpr std::size_t kMemoryStreamBytes = 1 << 20;
std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> memoryStreams(
    const std::string& name = "memory");

}  // namespace robotlink::arcos
