// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/JsonLine.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include "logplayer/export/MessageTable.h"
#include "robotlink/decoding/JsonText.h"

namespace logplayer {

robotlink::Result<std::string> jsonLine(const robotlink::StreamMessage& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.preserve_proto_field_names = true;
  // Unset fields are left out if the type distinguishes them.
  options.always_print_primitive_fields =
      message.value->GetDescriptor()->file()->syntax() == google::protobuf::FileDescriptor::SYNTAX_PROTO3;
  std::string value;
  // This fails, for example, for a timestamp after the year 9999.
  if (!google::protobuf::util::MessageToJsonString(*message.value, &value, options).ok()) {
    return robotlink::failure("export.json", "it cannot be converted to JSON");
  }
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t nanoseconds = message.time.time_since_epoch().count();
  std::string line = "{\"stream\":" + robotlink::jsonText(message.path) +
                     ",\"log_time\":" + secondsText(nanoseconds / kSecond, nanoseconds % kSecond);
  if (!message.process.empty()) line += ",\"process\":" + robotlink::jsonText(message.process);
  if (message.frame > 0) line += ",\"frame\":" + std::to_string(message.frame);
  line += ",\"type\":" + robotlink::jsonText(message.value->GetDescriptor()->full_name()) +
          ",\"message\":" + value + "}\n";
  return line;
}

}  // namespace logplayer
