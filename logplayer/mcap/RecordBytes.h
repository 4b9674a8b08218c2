// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "logplayer/mcap/Records.h"
#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

// Types and functions for reading and writing the bytes of MCAP records.
namespace logplayer::mcap {

using robotlink::ByteReader;
using robotlink::ByteWriter;
using robotlink::loadNumber;
using robotlink::storeNumber;

/// The characters of a text as bytes, and back, without a copy.
inline Bytes bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string_view textOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace logplayer::mcap
