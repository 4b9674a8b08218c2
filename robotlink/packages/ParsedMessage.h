// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace google::protobuf {
class Message;
}

namespace robotlink {

/// Parses a message of a type that this program knows. Null if there is no such type, or if the bytes are
/// none of its messages.
std::shared_ptr<google::protobuf::Message> parsedMessage(const std::string& type, std::string_view bytes);

}  // namespace robotlink
