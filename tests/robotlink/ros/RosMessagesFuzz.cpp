// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/message.h>

#include <cstdio>
#include <cstdlib>

#include "logplayer/export/MessageTable.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace ros_messages_fuzz {

using robotlink::ros::test::fuzzInput;
using robotlink::ros::test::kRos1;
using robotlink::ros::test::kRos2;

// What is read must survive Protobuf's own encoding.
namespace {

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

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto message = robotlink::ros::test::messageOfFuzzInput({reinterpret_cast<const char*>(data), size});
  if (message) check(*message);
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {
      fuzzInput(kRos2, "p/msg/M", "uint8 OK=0\nuint8 WARN=1\nuint8 level\nfloat64[] xs\nwstring w\nbool[2] b",
                "00010000 01 000000 02000000 000000000000f83f 000000000000f83f 01000000 61000000 0001"),
      fuzzInput(kRos2, "p/msg/M",
                "P[<=3] a # few\nstring<=4[] s\n===\nMSG: p/P\nuint8 x\nbuiltin_interfaces/Time t",
                "00010000 01000000 01 000000 02000000 03000000 01000000 02000000 6100"),
      fuzzInput(kRos2, "p/msg/M", "uint16 a\nE e\nint64[] n\n===\nMSG: p/E\n",
                "00060000 0102 00 00 00000001 0000000000000007"),
      fuzzInput(
          {"ros2idl", "cdr"}, "p/msg/M",
          "const long N = 2;\nmodule p { enum E { A, @value(7) B }; typedef float row[N];\n"
          "module msg { struct P { row x; }; @nested struct M { sequence<P, 3> a; E e; string<8> s; }; }; };",
          "00010000 01000000 0000003f 0000803f 07000000 02000000 6100"),
      fuzzInput(
          kRos1, "p/M",
          "Header h\nduration[] d\nuint8[] data\nint8[] i\n===\nMSG: std_msgs/Header\n"
          "uint32 seq\ntime stamp\nstring frame_id",
          "01000000 02000000 03000000 01000000 61 01000000 ffffffff ffffffff 02000000 0102 01000000 ff"),
  };
}

const FuzzRegistration kTarget({"ros_messages", &fuzzSeeds, &runInput});

}  // namespace ros_messages_fuzz
