// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace google::protobuf {
class Descriptor;
}

namespace robotlink::dds {

/// A number by which two programs recognize that they mean the same by a type of packages: computed from the
/// names, numbers and types of its fields, of the messages in them and of their enumerators, but not from
/// anything else in the same file. It takes some microseconds. Any thread.
std::uint64_t fingerprintOf(const google::protobuf::Descriptor& type);

}  // namespace robotlink::dds
