// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace google::protobuf {
class MessageLite;
}

namespace robotlink {

/// A fingerprint by which two programs can check that they hold the same value: FNV-1a (64 bits) over the
/// serialized message, never 0. The same on all machines, because packages have no map fields. Cost: one
/// serialization.
std::uint64_t checksum(const google::protobuf::MessageLite& message);

}  // namespace robotlink
