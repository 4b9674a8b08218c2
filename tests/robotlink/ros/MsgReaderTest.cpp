// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/MsgReader.h"

#include <gmock/gmock.h>

#include "robotlink/ros/Resolution.h"

namespace robotlink::ros {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::SizeIs;

Definitions read(const std::string& text, Version version = Version::kRos2) {
  const auto definitions = readMsg("p/msg/M", text, version);
  EXPECT_TRUE(definitions) << definitions.error().describe();
  return definitions.value_or(Definitions{});
}

Field fieldOf(const std::string& line, Version version = Version::kRos2) {
  const auto fields = read(line, version).structs["p/M"].fields;
  EXPECT_THAT(fields, SizeIs(1));
  return fields.empty() ? Field{} : fields.front();
}

std::string errorOf(const std::string& text) {
  const auto definitions = readMsg("p/msg/M", text, Version::kRos2);
  return definitions ? "none" : definitions.error().describe();
}

TEST(MsgReader, namesOfAllVersionsAreTheSameStruct) {
  EXPECT_EQ(structKey("sensor_msgs/Image"), "sensor_msgs/Image");
  EXPECT_EQ(structKey("sensor_msgs/msg/Image"), "sensor_msgs/Image");
  EXPECT_EQ(structKey("sensor_msgs::msg::Image"), "sensor_msgs/Image");
  EXPECT_EQ(structKey("std_srvs/srv/SetBool_Request"), "std_srvs/SetBool_Request");
}

TEST(MsgReader, fieldsHaveTypesAndShapes) {
  EXPECT_EQ(fieldOf("float64 x"), (Field{"x", Kind::kFloat64, "", Shape::kSingle, 0, {}}));
  EXPECT_EQ(fieldOf("uint8[] data"), (Field{"data", Kind::kUint8, "", Shape::kSequence, 0, {}}));
  EXPECT_EQ(fieldOf("float64[9] k"), (Field{"k", Kind::kFloat64, "", Shape::kArray, 9, {}}));
  EXPECT_EQ(fieldOf("int32[<=3] few"), (Field{"few", Kind::kInt32, "", Shape::kSequence, 3, {}}));
  EXPECT_EQ(fieldOf("string<=10[<=5] names"), (Field{"names", Kind::kString, "", Shape::kSequence, 5, {}}));
  EXPECT_EQ(fieldOf("wstring<=10 name").kind, Kind::kWstring);
  EXPECT_EQ(fieldOf("builtin_interfaces/Time stamp").kind, Kind::kTime);
  EXPECT_EQ(fieldOf("builtin_interfaces/msg/Duration left").kind, Kind::kDuration);
  EXPECT_EQ(fieldOf("duration left", Version::kRos1).kind, Kind::kDuration);
}

TEST(MsgReader, aByteIsSignedInRos1Only) {
  EXPECT_EQ(fieldOf("byte b", Version::kRos1).kind, Kind::kInt8);
  EXPECT_EQ(fieldOf("byte b").kind, Kind::kUint8);
  EXPECT_EQ(fieldOf("char c", Version::kRos1).kind, Kind::kUint8);
}

TEST(MsgReader, defaultsAndCommentsAreLeftOut) {
  EXPECT_EQ(fieldOf("# text\n\n  int32 x -7 # comment\r\n").name, "x");
  EXPECT_EQ(fieldOf("string name \"a = #b\"").name, "name");
  EXPECT_EQ(fieldOf("int32[] xs [1, 2, 3]").shape, Shape::kSequence);
  EXPECT_EQ(fieldOf("int32 x#comment").name, "x");
}

TEST(MsgReader, constantsAreNoFields) {
  EXPECT_EQ(fieldOf("int32 A=1\nstring B = a # b\nfloat32 C=1.5\nint32 x").name, "x");
  // The texts of ROS 1 go on to the end of the line.
  EXPECT_EQ(fieldOf("string NAME=int32 # float64 y\nint32 x", Version::kRos1).name, "x");
}

TEST(MsgReader, constantsBeforeAFieldNameItsValues) {
  EXPECT_THAT(fieldOf("uint8 OK=0\nuint8 WARN = 1 # not good\n\n# how it is\nuint8 level").enumerators,
              ElementsAre(Pair("OK", 0), Pair("WARN", 1)));
  EXPECT_THAT(fieldOf("uint8 OK=0\nint32 level").enumerators, IsEmpty()) << "another type";
  EXPECT_THAT(fieldOf("uint8 OK=0\nuint8[] levels").enumerators, IsEmpty());
  const auto two = read("uint8 OK=0\nuint8 level\nuint8 other").structs["p/M"].fields;
  EXPECT_THAT(two.at(1).enumerators, IsEmpty()) << "they are those of the field behind them";
}

TEST(MsgReader, structsFollowBehindLinesOfEqualSigns) {
  const std::string line(80, '=');
  const auto definitions = read(
      "std_msgs/Header header\nPoint[2] corners\n" + line + "\nMSG: p/Point\nfloat64 x\nfloat64 y\n" + line +
      "\nMSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n" + line +
      "\nMSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n" + line + "\nMSG: p/Unused\nNowhere x\n");
  EXPECT_EQ(definitions.root, "p/M");
  ASSERT_THAT(definitions.structs, SizeIs(3)) << "only what the message contains";
  EXPECT_EQ(definitions.structs.at("p/M").fields.at(0).structName, "std_msgs/Header");
  EXPECT_EQ(definitions.structs.at("p/M").fields.at(1).structName, "p/Point");
}

TEST(MsgReader, aHeaderNeedsNoPackage) {
  const auto definitions = read(
      "Header header\n===\nMSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n", Version::kRos1);
  EXPECT_THAT(definitions.structs.at("std_msgs/Header").fields, SizeIs(3));
}

TEST(MsgReader, aShortNameOfAnotherPackageIsFoundIfThereIsOnlyOne) {
  EXPECT_EQ(read("Point a\n===\nMSG: q/Point\nfloat64 x\n").structs["p/M"].fields.at(0).structName,
            "q/Point");
  EXPECT_EQ(errorOf("Point a\n===\nMSG: q/Point\nfloat64 x\n===\nMSG: r/Point\nfloat64 y\n"),
            "p/M.a is a Point, which is not defined here");
}

TEST(MsgReader, errorsNameTheLine) {
  EXPECT_EQ(errorOf("int32 x\nint32"), "p/msg/M:2: a name is expected after the type \"int32\"");
  EXPECT_EQ(errorOf("int-32 x"), "p/msg/M:1: a type is expected, not \"int-32\"");
  EXPECT_THAT(errorOf("int32[x] a"), HasSubstr("a number is expected in \"[x]\""));
  EXPECT_THAT(errorOf("int32[3 a"), HasSubstr("not \"[3\""));
  EXPECT_THAT(errorOf("string<=x a"), HasSubstr("the maximum length of a text is expected"));
  EXPECT_THAT(errorOf("int32 x\n===\nint32 y"), HasSubstr("p/msg/M:3: \"MSG:\""));
  EXPECT_THAT(errorOf("q/N a"), HasSubstr("p/M.a is a q/N, which is not defined here"));
}

TEST(MsgReader, aMessageThatContainsItselfIsRefused) {
  EXPECT_THAT(errorOf("M inner"), HasSubstr("contains itself"));
  EXPECT_THAT(errorOf("N inner\n===\nMSG: p/N\nM[] outer"), HasSubstr("contains itself"));
}

/// A message whose structs are nested so deeply, with a second way to half of them.
std::string nested(int levels) {
  std::string text = "S1 a\nS" + std::to_string(levels / 2) + " b\n";
  for (int i = 1; i < levels; ++i) {
    text += "===\nMSG: p/S" + std::to_string(i) + "\n";
    text += i + 1 < levels ? "S" + std::to_string(i + 1) + " inner\n" : "int32 x\n";
  }
  return text;
}

TEST(MsgReader, depthAndSizeAreLimited) {
  EXPECT_EQ(errorOf(nested(kMaxDepth)), "none");
  EXPECT_THAT(errorOf(nested(kMaxDepth + 1)), HasSubstr("nested too deeply"));
  std::string many;
  for (std::size_t i = 0; i <= kMaxFields; ++i) many += "int32 x" + std::to_string(i) + "\n";
  EXPECT_THAT(errorOf(many), HasSubstr("too many fields"));
}

}  // namespace
}  // namespace robotlink::ros
