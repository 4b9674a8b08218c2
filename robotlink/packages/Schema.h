// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace google::protobuf {
class Descriptor;
}

namespace robotlink {

/// The schema that a reader without this program's types needs to decode the messages of `type`: a serialized
/// FileDescriptorSet of its file and those that it imports, imports first, with the types alone that `type`
/// is made of: a link sends one for each channel. Log files store it.
std::string schemaOf(const google::protobuf::Descriptor& type);

}  // namespace robotlink
