// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/message.h>

#include <cstdio>
#include <cstdlib>

#include "logplayer/export/MessageTable.h"
#include "robotlink/decoding/JsonType.h"
#include "tests/fuzz/FuzzTarget.h"

namespace json_messages_fuzz {

// The input is a schema's name, a JSON schema and messages, a line each. What is read must survive Protobuf's
// own encoding.
using logplayer::MessageTable;
using robotlink::JsonType;

namespace {

std::string takeLine(std::string& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string line = text.substr(0, end);
  text.erase(0, std::min(end + 1, text.size()));
  return line;
}

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

void check(const std::shared_ptr<const JsonType>& type, const std::string& line) {
  const auto message = JsonType::read(type, bytesOf(line));
  if (!message) return;
  MessageTable table;
  table.learn(*message);
  if (table.row(*message).size() != table.columns().size()) std::abort();
  const std::string data = message->SerializeAsString();
  const std::unique_ptr<google::protobuf::Message> again(message->New());
  if (again->ParseFromString(data) && again->SerializeAsString() == data) return;
  std::fputs("a message changes when it is encoded\n", stderr);
  std::abort();
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  std::string rest(reinterpret_cast<const char*>(data), size);
  const std::string name = takeLine(rest);
  const std::string schema = takeLine(rest);
  const auto bySchema = JsonType::ofSchema(name, schema);
  const auto byMessage = JsonType::ofMessage(name, bytesOf(schema));
  while (!rest.empty()) {
    const std::string line = takeLine(rest);
    if (bySchema) check(bySchema, line);
    if (byMessage) check(byMessage, line);
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      R"(their.Pose
{"type":"object","properties":{"stamp":{"type":"object","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"x":{"type":"number"},"m":{"type":"array","items":{"type":"array","items":{"type":"integer"}}}}}
{"stamp":{"sec":5,"nsec":250000000},"x":1.5,"m":[[1,2],[3]]}
{"x":"far","note":[1],"stamp":{"sec":"7","nsec":1e3}})",
      R"(tree/Node
{"$ref":"#/$defs/node","$defs":{"node":{"type":"object","properties":{"value":{"type":["number","null"]},"data":{"type":"string","contentEncoding":"base64"},"children":{"type":"array","items":{"$ref":"#/$defs/node"}}}}}}
{"value":1,"data":"AAEC/w==","children":[{"value":2,"children":[{"value":null}]}]})",
      R"(foxglove.Log
{"type":"object","properties":{"level":{"oneOf":[{"const":2},{"const":3}]},"timestamp":{"type":"object","title":"time","properties":{"sec":{"type":"integer"},"nsec":{"type":"integer"}}},"message":{"type":"string"},"line":{"type":"integer"}}}
{"level":3,"timestamp":{"sec":7,"nsec":1},"message":"low","line":4294967295})",
      R"(1 lives..x
{"properties":{"1st":{"type":"integer"},"a-b":{"type":"boolean"},"a.b":{"anyOf":[{"type":"null"},{"type":"object","properties":{"q":{"type":"string"}}}]},"":{"type":"array","items":{"type":"array","items":{"type":"array","items":{"type":"number"}}}}}}
{"1st":-9223372036854775808,"a-b":true,"a.b":{"q":"\u00fc"},"":[[[1,null,"NaN"]],[]]})",
  };
}

const FuzzRegistration kTarget({"json_messages", &fuzzSeeds, &runInput});

}  // namespace json_messages_fuzz
