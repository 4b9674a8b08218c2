// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

// The CRC-32 of IEEE 802.3, as computed by zlib.

/// The CRC of bytes; with `before` of bytes that follow others whose CRC is `before`.
std::uint32_t crc32(Bytes bytes, std::uint32_t before = 0);

/// The CRC of two concatenated pieces from their individual CRCs and the length of the second one. The cost
/// does not depend on the length.
std::uint32_t joinedCrc32(std::uint32_t first, std::uint32_t second, std::uint64_t secondBytes);

}  // namespace logplayer::mcap
