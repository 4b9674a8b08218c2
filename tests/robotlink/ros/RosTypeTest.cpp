// SPDX-License-Identifier: GPL-3.0-or-later
// Messages whose bytes were worked out by hand from the specifications (OMG CDR, DDS-XTypes 1.3, ROS 1).
#include "robotlink/ros/RosType.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/FieldValues.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace robotlink::ros {
namespace {

using test::bytesOf;
using test::decoded;
using test::kRos1;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(RosType, numbersAreAlignedInCdr) {
  constexpr char kDefinition[] =
      "uint8 a\nint16 b\nuint8 c\nfloat64 d\nint8 e\nuint32 f\nbool g\nint64 h\nfloat32 i";
  EXPECT_EQ(decoded(kDefinition,
                    "00010000 01 00 feff 03 000000 000000000000f83f ff 000000 04000000 01 00000000000000"
                    "ffffffffffffffff 0000003f"),
            "a: 1 b: -2 c: 3 d: 1.5 e: -1 f: 4 g: true h: -1 i: 0.5");
}

TEST(RosType, bigEndianIsReadToo) {
  EXPECT_EQ(decoded("uint16 a\nfloat64 b\nint32[] c",
                    "00000000 0102 000000000000 3ff8000000000000"
                    "00000002 00000001 fffffffe"),
            "a: 258 b: 1.5 c: 1 c: -2");
}

TEST(RosType, xcdr2AlignsToFourAndSizesListsOfTexts) {
  EXPECT_EQ(decoded("uint8 a\nfloat64 b", "00070000 01 000000 000000000000f83f"), "a: 1 b: 1.5");
  // The size of the list in bytes, its count, then each text with its length.
  EXPECT_EQ(decoded("string[] s\nint32[] n",
                    "00070000 0f000000 02000000 02000000 6100 0000 02000000 6200 0000"
                    "01000000 07000000"),
            "s: \"a\" s: \"b\" n: 7");
}

TEST(RosType, textsEndWithNulInCdrOnly) {
  EXPECT_EQ(decoded("string a\nstring b\nuint8 c", "00010000 03000000 686900 00 01000000 00 07"),
            "a: \"hi\" c: 7");
  EXPECT_EQ(decoded("string a\nuint8 c", "00010000 00000000 07"), "c: 7") << "some writers leave it out";
  EXPECT_EQ(decoded("string a\nstring b\nuint8 c", "02000000 6869 00000000 07", kRos1), "a: \"hi\" c: 7");
  EXPECT_EQ(decoded("string a", "00010000 03000000 ff2000"), "a: \"? \"")
      << "what is no UTF-8 cannot be kept";
}

TEST(RosType, wideTextsBecomeUtf8) {
  // a, u umlaut, a rabbit of two units, half a pair.
  EXPECT_EQ(
      decoded("wstring a\nuint8 b", "00010000 05000000 61000000 fc000000 3dd80000 07dc0000 3dd80000 07"),
      "a: \"a\\303\\274\\360\\237\\220\\207?\" b: 7");
  EXPECT_EQ(decoded("wstring a\nuint8 b", "00070000 04000000 6100fc00 07"), "a: \"a\\303\\274\" b: 7");
}

TEST(RosType, listsHaveACountUnlessTheyAreFixed) {
  EXPECT_EQ(decoded("int16[2] a\nfloat32[] b\nbool[] c\nint8[<=2] d",
                    "00010000 0100 0200 02000000 0000803f 00000040 02000000 0100 0000 01000000 ff"),
            "a: 1 a: 2 b: 1 b: 2 c: true c: false d: -1");
  EXPECT_EQ(decoded("float64[] a\nuint8 b", "00010000 00000000 05"), "b: 5")
      << "nothing is aligned for no value";
  EXPECT_EQ(decoded("uint8[] a\nuint8[3] b", "00010000 02000000 4142 434445"), "a: \"AB\" b: \"CDE\"");
}

TEST(RosType, structsAreNested) {
  constexpr char kDefinition[] = "P[] a\nP b\n===\nMSG: p/P\nuint8 x\nuint32 y";
  EXPECT_EQ(decoded(kDefinition, "00010000 01000000 01 000000 02000000 03 000000 04000000"),
            "a { x: 1 y: 2 } b { x: 3 y: 4 }");
  EXPECT_EQ(decoded(kDefinition, "01000000 01 02000000 03 04000000", kRos1),
            "a { x: 1 y: 2 } b { x: 3 y: 4 }");
}

TEST(RosType, aStructWithoutFieldsHasAByteInRos2) {
  constexpr char kDefinition[] = "E a\nuint8 b\n===\nMSG: p/E\nuint8 ONLY=1\n";
  EXPECT_EQ(decoded(kDefinition, "00010000 00 07"), "a { } b: 7");
  EXPECT_EQ(decoded(kDefinition, "07", kRos1), "a { } b: 7");
  EXPECT_EQ(decoded("", "00010000"), "") << "some writers leave it out";
}

TEST(RosType, timesAreThoseOfProtobuf) {
  constexpr char kRos2Times[] = "builtin_interfaces/Time t\nbuiltin_interfaces/Duration d";
  EXPECT_EQ(decoded(kRos2Times, "00010000 05000000 00e1f505 ffffffff 0065cd1d"),
            "t { seconds: 5 nanos: 100000000 } d { nanos: -500000000 }");
  EXPECT_EQ(decoded("time t\nduration d", "ffffffff 01000000 ffffffff ffffffff", kRos1),
            "t { seconds: 4294967295 nanos: 1 } d { seconds: -1 nanos: -1 }");
  EXPECT_EQ(decoded("time t", "01000000 ffffffff", kRos1), "t { seconds: 5 nanos: 294967295 }")
      << "nanoseconds beyond a second";
  const auto type = RosType::of("p/M", "ros1msg", "time t", "ros1");
  const auto message = RosType::read(*type, bytesOf("0100000002000000"));
  EXPECT_TRUE(isTime(*(*message)->GetDescriptor()->field(0)->message_type()));
}

TEST(RosType, constantsAreTheNamesOfValues) {
  constexpr char kDefinition[] = "byte WARN=1\nbyte OK=0\nbyte level";
  EXPECT_EQ(decoded(kDefinition, "00010000 01"), "level: WARN");
  EXPECT_EQ(decoded(kDefinition, "00010000 07"), "level: 7");
  EXPECT_EQ(decoded("byte WARN=1\nbyte level", "00010000 01"), "level: 1") << "Protobuf wants a name for 0";
  EXPECT_EQ(decoded("byte level_values=0\nbyte level", "00010000 01"), "level: 1") << "a name that is taken";
}

TEST(RosType, namesThatProtobufRefusesAreChanged) {
  EXPECT_EQ(decoded("uint8 aB\nuint8 a_b\nuint8 ab", "00010000 010203"), "aB: 1 a_b_2: 2 ab_3: 3");
  const auto type = RosType::of("2nd-lab/msg/Image", "ros2msg", "uint8 a", "cdr");
  ASSERT_TRUE(type);
  EXPECT_EQ((*type)->name(), "_2nd_lab.Image");
}

TEST(RosType, aTypeOfThisProgramIsNotReplaced) {
  ASSERT_EQ(foxglove::RawImage::descriptor()->full_name(), "foxglove.RawImage");
  const auto type = RosType::of("foxglove/RawImage", "ros2msg", "uint8 a", "cdr");
  ASSERT_TRUE(type);
  EXPECT_EQ((*type)->name(), "ros.foxglove.RawImage");
}

TEST(RosType, messagesKeepTheirTypeAlive) {
  auto type = *RosType::of("p/M", "ros1msg", "uint8 a", "ros1");
  const auto message = RosType::read(type, bytesOf("07"));
  type.reset();
  EXPECT_EQ((*message)->ShortDebugString(), "a: 7");
}

TEST(RosType, lengthsThatLieAreErrorsWithTheirPlace) {
  EXPECT_EQ(decoded("uint32 a", "00010000 0102"), "at byte 4: the message ends within a number");
  EXPECT_EQ(decoded("uint8 a\nstring b", "00010000 01 000000 ffffffff 61"),
            "at byte 12: a text is longer than the message");
  EXPECT_EQ(decoded("wstring a", "00010000 ffffff7f 61"), "at byte 8: a text is longer than the message");
  EXPECT_EQ(decoded("uint8[] a", "00010000 05000000 61"),
            "at byte 8: there are more values than the message has room for");
  EXPECT_EQ(decoded("float64[4000000000] a", "00010000 00000000"),
            "at byte 4: there are more values than the message has room for");
  EXPECT_EQ(decoded("float64[2] a", "00010000 0000000000000000 00000000000000"),
            "at byte 4: there are more values than the message has room for");
  EXPECT_EQ(decoded("int32[<=1] a", "00010000 02000000 00000000 00000000"),
            "at byte 8: there are more values than the definition allows");
  EXPECT_EQ(decoded("P[] a\n===\nMSG: p/P\nfloat64[1000] x", "00010000 ffffffff 00"),
            "at byte 8: there are more values than the message has room for");
  EXPECT_EQ(decoded("uint8 a", ""), "the message is shorter than the header of CDR, which has 4 bytes");
}

TEST(RosType, structsOfNoBytesAreNotMadeWithoutEnd) {
  EXPECT_THAT(decoded("E[] a\n===\nMSG: p/E\n", "ffff0000", kRos1),
              HasSubstr("more parts than a message of this size"));
  EXPECT_THAT(decoded("F[9000] a\n===\nMSG: p/F\nE[9000] b\n===\nMSG: p/E\n", "", kRos1),
              HasSubstr("more parts than a message of this size"));
}

TEST(RosType, otherKindsOfCdrAreNamed) {
  EXPECT_THAT(decoded("uint8 a", "00030000 01"), StartsWith("CDR of kind 3 is not read"));
  EXPECT_THAT(decoded("uint8 a", "01010000 01"), StartsWith("CDR of kind 257 is not read"));
}

TEST(RosType, otherEncodingsAreNotRead) {
  EXPECT_EQ(decoded("table M {}", "", {"flatbuffer", "cdr"}), "definitions in flatbuffer are not read");
  EXPECT_EQ(decoded("uint8 a", "", {"ros2msg", "flatbuffer"}), "messages in flatbuffer are not read");
}

}  // namespace
}  // namespace robotlink::ros
