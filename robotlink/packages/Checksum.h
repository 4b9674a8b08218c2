// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace google::protobuf {
class MessageLite;
}

namespace robotlink {

/// Tells whether two programs hold the same value: FNV-1a (64 bits) over the serialised message, never 0. The
/// same on all machines, as packages have no map fields.
std::uint64_t checksum(const google::protobuf::MessageLite& message);

}  // namespace robotlink
