// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

/// What a reader that does not know a type needs to read its messages: a serialised FileDescriptorSet of its
/// file and all that this imports, imports first.
std::string schemaOf(const google::protobuf::Descriptor& type);

}  // namespace robotlink
