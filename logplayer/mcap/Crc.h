// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

// The CRC-32 of IEEE 802.3, as computed by zlib.

/// Returns the CRC of bytes, or of more bytes behind those whose CRC `before` is.
std::uint32_t crc32(Bytes bytes, std::uint32_t before = 0);

/// Returns the CRC of two stretches one after the other, from their own CRCs and the second's length. Its
/// cost does not depend on the length.
std::uint32_t joinedCrc32(std::uint32_t first, std::uint32_t second, std::uint64_t secondBytes);

}  // namespace logplayer::mcap
