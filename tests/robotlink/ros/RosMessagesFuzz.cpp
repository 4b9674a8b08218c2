// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/message.h>

#include <cstdio>
#include <cstdlib>

#include "logplayer/export/MessageTable.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/ros/RosMessages.h"

// The input is the encoding of the schema, that of the messages, the type's name, its definition up to a NUL,
// and a message. What is read must survive Protobuf's own encoding.
using robotlink::ros::RosType;
using robotlink::ros::test::bytesOf;

namespace {

std::string takeUntil(char end, std::string& text) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string taken = text.substr(0, at);
  text.erase(0, std::min(at + 1, text.size()));
  return taken;
}

void check(const google::protobuf::Message& message) {
  logplayer::MessageTable table;
  table.learn(message);
  if (table.row(message).size() != table.columns().size()) std::abort();
  const std::string data = message.SerializeAsString();
  const std::unique_ptr<google::protobuf::Message> again(message.New());
  if (again->ParseFromString(data) && again->SerializeAsString() == data) return;
  std::fputs("a message changes when it is encoded\n", stderr);
  std::abort();
}

std::string seed(const std::string& encodings, const std::string& name, const std::string& definition,
                 const std::string& hex) {
  const auto bytes = bytesOf(hex);
  return encodings + "\n" + name + "\n" + definition + std::string(1, '\0') +
         std::string(bytes.begin(), bytes.end());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string rest(reinterpret_cast<const char*>(data), size);
  const std::string schema = takeUntil('\n', rest), encoding = takeUntil('\n', rest);
  const std::string name = takeUntil('\n', rest), definition = takeUntil('\0', rest);
  const auto type = RosType::of(name, schema, definition, encoding);
  if (!type) return 0;
  const auto message =
      RosType::read(*type, {reinterpret_cast<const std::uint8_t*>(rest.data()), rest.size()});
  if (message) check(**message);
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      seed("ros2msg\ncdr", "p/msg/M",
           "uint8 OK=0\nuint8 WARN=1\nuint8 level\nfloat64[] xs\nwstring w\nbool[2] b",
           "00010000 01 000000 02000000 000000000000f83f 000000000000f83f 01000000 61000000 0001"),
      seed("ros2msg\ncdr", "p/msg/M",
           "P[<=3] a # few\nstring<=4[] s\n===\nMSG: p/P\nuint8 x\nbuiltin_interfaces/Time t",
           "00010000 01000000 01 000000 02000000 03000000 01000000 02000000 6100"),
      seed("ros2msg\ncdr", "p/msg/M", "uint16 a\nE e\nint64[] n\n===\nMSG: p/E\n",
           "00060000 0102 00 00 00000001 0000000000000007"),
      seed(
          "ros2idl\ncdr", "p/msg/M",
          "const long N = 2;\nmodule p { enum E { A, @value(7) B }; typedef float row[N];\n"
          "module msg { struct P { row x; }; @nested struct M { sequence<P, 3> a; E e; string<8> s; }; }; };",
          "00010000 01000000 0000003f 0000803f 07000000 02000000 6100"),
      seed("ros1msg\nros1", "p/M",
           "Header h\nduration[] d\nuint8[] data\nint8[] i\n===\nMSG: std_msgs/Header\n"
           "uint32 seq\ntime stamp\nstring frame_id",
           "01000000 02000000 03000000 01000000 61 01000000 ffffffff ffffffff 02000000 0102 01000000 ff"),
  };
}
