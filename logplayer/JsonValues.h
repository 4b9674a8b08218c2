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

namespace logplayer {

/// The fields of message types by the JSON properties that they hold.
using JsonFields = std::map<const google::protobuf::Descriptor*,
                            std::map<std::string, const google::protobuf::FieldDescriptor*>>;

/// Puts a JSON object's values into the fields of a message. What has no field, or does not fit it, goes into
/// `others` by its path
/// ("pose.note"). No deeper than the JSON is.
void assignJson(google::protobuf::Message& to, const nlohmann::json& object, const JsonFields& fields,
                nlohmann::json& others);

}  // namespace logplayer
