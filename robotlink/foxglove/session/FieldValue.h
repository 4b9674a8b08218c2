// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotlink/foxglove/protocol/Value.h"

namespace google::protobuf {
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink::websocket {

// Single fields of messages as values of the protocol.

/// The value of a field that is no message; a list as a whole if it is repeated. Nothing for messages and
/// bytes.
std::optional<Value> fieldValue(const google::protobuf::Message& message,
                                const google::protobuf::FieldDescriptor& field);
/// Sets such a field. Returns what is wrong with the value ("is a number"), without a change then; empty:
/// nothing.
std::string setFieldValue(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field,
                          const Value& value);

}  // namespace robotlink::websocket
