// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace google::protobuf {
class Descriptor;
class FieldDescriptor;
class Message;
}  // namespace google::protobuf

namespace robotlink {

/// For each message type its fields, keyed by the names of the JSON properties that they hold.
using JsonFields = std::map<const google::protobuf::Descriptor*,
                            std::map<std::string, const google::protobuf::FieldDescriptor*>>;

/// Assigns the values of a JSON object to the fields of a message. Values without a matching field are stored
/// in `others` under their path ("pose.note"). Recursion is as deep as the JSON.
void assignJson(google::protobuf::Message& to, const nlohmann::json& object, const JsonFields& fields,
                nlohmann::json& others);

}  // namespace robotlink
