// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/ros/Description.h"

#include <gmock/gmock.h>

namespace robotlink::ros {
namespace {

using google::protobuf::FieldDescriptorProto;
using testing::ElementsAre;

Field field(const std::string& name, Kind kind, Shape shape = Shape::kSingle) {
  Field result;
  result.name = name;
  result.kind = kind;
  result.shape = shape;
  return result;
}

google::protobuf::DescriptorProto messageOf(const std::vector<Field>& fields,
                                            Enumerations enumerations = Enumerations::kNone) {
  return describe("my_msgs/Thing", {fields}, "ros", enumerations).message_type(0);
}

TEST(Description, namesOfStructsBecomeThoseOfTypes) {
  EXPECT_EQ(typeName("sensor_msgs/Image", "ros"), "ros.sensor_msgs.Image");
  EXPECT_EQ(typeName("Image", ""), "Image");
  EXPECT_EQ(typeName("a-b/2D", "ros"), "ros.a_b._2D");
  EXPECT_EQ(typeName("a//b", ""), "a._.b");
}

TEST(Description, numbersOfFieldsLeaveOutWhatIsReserved) {
  EXPECT_EQ(fieldNumber(0), 1);
  EXPECT_EQ(fieldNumber(18'998), 18'999);
  EXPECT_EQ(fieldNumber(18'999), 20'000);
}

TEST(Description, aFileIsNamedAsItsStruct) {
  Field header = field("header", Kind::kStruct);
  header.structName = "std_msgs/Header";
  Field other = header;
  other.name = "other";
  const auto file = describe("my_msgs/Thing", {{header, other}}, "ros", Enumerations::kNone);
  EXPECT_EQ(file.name(), "my_msgs/Thing");
  EXPECT_EQ(file.package(), "ros.my_msgs");
  EXPECT_EQ(file.syntax(), "proto3");
  EXPECT_EQ(file.message_type(0).name(), "Thing");
  // What two fields have is imported once.
  EXPECT_THAT(file.dependency(), ElementsAre("google/protobuf/timestamp.proto",
                                             "google/protobuf/duration.proto", "std_msgs/Header"));
  EXPECT_EQ(file.message_type(0).field(1).type_name(), ".ros.std_msgs.Header");
}

TEST(Description, aStructWithoutFolderIsInThePackageItself) {
  EXPECT_EQ(describe("Thing", {}, "ros", Enumerations::kNone).package(), "ros");
  EXPECT_EQ(describe("Thing", {}, "", Enumerations::kNone).package(), "");
}

TEST(Description, everyKindHasItsType) {
  struct Case {
    Kind kind;
    Shape shape;
    FieldDescriptorProto::Type type;
    const char* typeName;
    bool isRepeated;
  };
  constexpr char kTime[] = ".google.protobuf.Timestamp", kDuration[] = ".google.protobuf.Duration";
  const Case cases[] = {
      {Kind::kBool, Shape::kSingle, FieldDescriptorProto::TYPE_BOOL, "", false},
      {Kind::kInt8, Shape::kSingle, FieldDescriptorProto::TYPE_INT32, "", false},
      {Kind::kInt16, Shape::kArray, FieldDescriptorProto::TYPE_INT32, "", true},
      {Kind::kInt32, Shape::kSequence, FieldDescriptorProto::TYPE_INT32, "", true},
      {Kind::kInt64, Shape::kSingle, FieldDescriptorProto::TYPE_INT64, "", false},
      {Kind::kUint8, Shape::kSingle, FieldDescriptorProto::TYPE_UINT32, "", false},
      {Kind::kUint8, Shape::kArray, FieldDescriptorProto::TYPE_BYTES, "", false},
      {Kind::kUint8, Shape::kSequence, FieldDescriptorProto::TYPE_BYTES, "", false},
      {Kind::kUint16, Shape::kSingle, FieldDescriptorProto::TYPE_UINT32, "", false},
      {Kind::kUint32, Shape::kSequence, FieldDescriptorProto::TYPE_UINT32, "", true},
      {Kind::kUint64, Shape::kSingle, FieldDescriptorProto::TYPE_UINT64, "", false},
      {Kind::kFloat32, Shape::kArray, FieldDescriptorProto::TYPE_FLOAT, "", true},
      {Kind::kFloat64, Shape::kSingle, FieldDescriptorProto::TYPE_DOUBLE, "", false},
      {Kind::kString, Shape::kSequence, FieldDescriptorProto::TYPE_STRING, "", true},
      {Kind::kWstring, Shape::kSingle, FieldDescriptorProto::TYPE_STRING, "", false},
      {Kind::kTime, Shape::kSingle, FieldDescriptorProto::TYPE_MESSAGE, kTime, false},
      {Kind::kDuration, Shape::kSequence, FieldDescriptorProto::TYPE_MESSAGE, kDuration, true},
  };
  for (const Case& one : cases) {
    SCOPED_TRACE(static_cast<int>(one.kind));
    const auto described = messageOf({field("value", one.kind, one.shape)}).field(0);
    EXPECT_EQ(described.type(), one.type);
    EXPECT_EQ(described.type_name(), one.typeName);
    EXPECT_EQ(described.label() == FieldDescriptorProto::LABEL_REPEATED, one.isRepeated);
  }
}

TEST(Description, namesThatProtobufWouldTakeForTheSameGetNumbers) {
  const auto message = messageOf({field("maxSpeed", Kind::kBool), field("max_speed", Kind::kBool),
                                  field("MAX_SPEED", Kind::kBool), field("2nd", Kind::kBool)});
  EXPECT_EQ(message.field(0).name(), "maxSpeed");
  EXPECT_EQ(message.field(1).name(), "max_speed_2");
  EXPECT_EQ(message.field(2).name(), "MAX_SPEED_3");
  EXPECT_EQ(message.field(3).name(), "_2nd");
}

TEST(Description, namedValuesBecomeAnEnumerationWithZeroFirst) {
  Field level = field("level", Kind::kUint8);
  level.enumerators = {{"WARN", 1}, {"OK", 0}, {"ERROR", 2}};
  const auto named = messageOf({level}, Enumerations::kNamed);
  EXPECT_EQ(named.field(0).type(), FieldDescriptorProto::TYPE_ENUM);
  EXPECT_EQ(named.field(0).type_name(), "level_values");
  ASSERT_EQ(named.enum_type_size(), 1);
  std::vector<std::string> names;
  for (const auto& value : named.enum_type(0).value()) names.push_back(value.name());
  EXPECT_THAT(names, ElementsAre("OK", "WARN", "ERROR"));
  // As a number where names are not wanted, or where none is 0.
  EXPECT_EQ(messageOf({level}).field(0).type(), FieldDescriptorProto::TYPE_UINT32);
  level.enumerators = {{"WARN", 1}};
  EXPECT_EQ(messageOf({level}, Enumerations::kNamed).enum_type_size(), 0);
}

}  // namespace
}  // namespace robotlink::ros
