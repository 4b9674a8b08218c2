// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

#include "robotlink/base/Error.h"
#include "robotlink/ros/Plan.h"

namespace google::protobuf {
class Message;
}

namespace robotlink::ros {

/// Decodes a message in CDR, as ROS 2 sends them: its first four bytes name the encoding. Read are plain
/// XCDR1 and XCDR2, in either byte order. Wide texts are read as Fast CDR writes them in XCDR1 (characters of
/// four bytes), and as UTF-16 in XCDR2. Bytes behind the last value are ignored.
///
/// Lengths are not trusted: what does not fit the rest of the message is an error with its offset, and memory
/// is in proportion to the bytes. `to` then holds what came before. Pure functions.
Result<void> decodeCdr(std::span<const std::uint8_t> data, const StructPlan& plan,
                       google::protobuf::Message& to);

/// Decodes a message in the encoding of ROS 1: little-endian values one after the other.
Result<void> decodeRos1(std::span<const std::uint8_t> data, const StructPlan& plan,
                        google::protobuf::Message& to);

}  // namespace robotlink::ros
