// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonType.h"

#include <gmock/gmock.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotlink/decoding/JsonText.h"
#include "robotlink/expressions/FieldPath.h"
#include "tests/logplayer/ForeignLog.h"

namespace robotlink {
namespace {

using robotlink::numberAt;
using ::testing::HasSubstr;

std::span<const std::uint8_t> bytesOf(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

robotlink::PackagePtr read(const std::shared_ptr<const JsonType>& type, const std::string& text) {
  return JsonType::read(type, bytesOf(text));
}

/// A message as Protobuf prints it in one line.
std::string shown(const robotlink::PackagePtr& message) {
  return message ? message->ShortDebugString() : "none";
}

std::string shown(const std::string& properties, const std::string& message) {
  const auto type = JsonType::ofSchema("T", R"({"type": "object", "properties": )" + properties + "}");
  return type ? shown(read(type, message)) : "no type";
}

}  // namespace

TEST(JsonType, valuesAreOfTheTypesThatTheSchemaSays) {
  const auto type = JsonType::ofSchema("their.Pose", tests::kPoseSchema);
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->name(), "their.Pose");
  const auto message = read(
      type,
      R"({"stamp": {"sec": 5, "nsec": 250000000}, "frame": "map", "position": {"x": 1.5, "y": -2}, "covariance": [1, null]})");
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(numberAt(*message, "position.x"), 1.5);
  EXPECT_EQ(numberAt(*message, "stamp"), 5.25);
  EXPECT_EQ(numberAt(*message, "covariance[0]"), 1);
  EXPECT_TRUE(std::isnan(*numberAt(*message, "covariance[1]")));
  EXPECT_THAT(shown(message), HasSubstr(R"(frame: "map")"));
}

TEST(JsonType, whatDoesNotFitTheSchemaIsKeptAsJson) {
  const auto type = JsonType::ofSchema("their.Pose", tests::kPoseSchema);
  const auto message = read(type, R"({"position": {"x": 2, "y": "far"}, "note": [1]})");
  ASSERT_NE(message, nullptr);
  EXPECT_EQ(numberAt(*message, "position.x"), 2);
  EXPECT_THAT(shown(message), HasSubstr(R"(other_fields: "{\"note\":[1],\"position.y\":\"far\"}")"));
}

TEST(JsonType, aSchemaOfAnOwnTypeGivesThatType) {
  const auto type = JsonType::ofSchema("foxglove.Log", tests::kLogSchema);
  const auto message = read(type, R"({"timestamp": {"sec": 7, "nsec": 1}, "level": 3, "message": "low"})");
  const auto* log = dynamic_cast<const foxglove::Log*>(message.get());
  ASSERT_NE(log, nullptr);
  EXPECT_EQ(log->level(), foxglove::Log::WARNING);
  EXPECT_EQ(log->message(), "low");
  EXPECT_EQ(log->timestamp().seconds(), 7);
  const auto image = JsonType::ofSchema(
      "foxglove.CompressedImage",
      R"({"properties": {"data": {"type": "string", "contentEncoding": "base64"}, "format": {"type": "string"}}})");
  const auto picture = read(image, R"({"data": "AAEC/w==", "format": "png"})");
  const auto* compressed = dynamic_cast<const foxglove::CompressedImage*>(picture.get());
  ASSERT_NE(compressed, nullptr);
  EXPECT_EQ(compressed->data(), std::string("\0\1\2\xff", 4));
}

TEST(JsonType, aTypeThatIsOnlyCalledLikeAnOwnOneIsAnother) {
  const auto type = JsonType::ofSchema("foxglove.Log", R"({"properties": {"lines": {"type": "integer"}}})");
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(type->name(), "json.foxglove.Log");
  EXPECT_EQ(shown(read(type, R"({"lines": 3})")), "lines: 3");
}

TEST(JsonType, arraysOfArraysReferencesAndAlternativesAreRead) {
  EXPECT_EQ(shown(R"({"m": {"type": "array", "items": {"type": "array", "items": {"type": "integer"}}}})",
                  R"({"m": [[1, 2], [3]]})"),
            "m { values: 1 values: 2 } m { values: 3 }");
  EXPECT_EQ(
      shown(R"({"n": {"type": ["number", "null"]}, "b": {"type": "boolean"}})", R"({"n": null, "b": true})"),
      "b: true");
  EXPECT_EQ(shown(R"({"v": {"anyOf": [{"type": "null"}, {"type": "integer"}]}})", R"({"v": 4})"), "v: 4");
  EXPECT_EQ(shown(R"({"v": {"anyOf": [{"type": "string"}, {"type": "integer"}]}})", R"({"v": [1, "x"]})"),
            R"(v: "[1,\"x\"]")");
  EXPECT_EQ(
      shown(
          R"({"level": {"oneOf": [{"const": 2}, {"title": "WARNING", "const": 3}]}, "way": {"enum": ["a", "b"]}})",
          R"({"level": 3, "way": "a"})"),
      R"(level: 3 way: "a")");
  const auto type = JsonType::ofSchema(
      "tree", R"({"$ref": "#/$defs/node", "$defs": {"node": {"type": "object", "properties":
    {"value": {"type": "number"}, "children": {"type": "array", "items": {"$ref": "#/$defs/node"}}}}}})");
  ASSERT_NE(type, nullptr);
  const auto tree = read(type, R"({"value": 1, "children": [{"value": 2, "children": [{"value": 3}]}]})");
  EXPECT_EQ(numberAt(*tree, "children[0].children[0].value"), 3);
}

TEST(JsonType, namesThatAreNoneInProtobufAreChanged) {
  EXPECT_EQ(
      shown(
          R"({"1st": {"type": "integer"}, "a-b": {"type": "integer"}, "a.b": {"type": "integer"}, "": {"type": "integer"}})",
          R"({"1st": 1, "a-b": 2, "a.b": 3, "": 4})"),
      "_: 4 _1st: 1 a_b: 2 a_b_2: 3");
  const auto type =
      JsonType::ofSchema("9 lives/ü..x/", R"({"properties": {"other_fields": {"type": "integer"}}})");
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(shown(read(type, R"({"other_fields": 1, "more": 2})")),
            R"(other_fields: 1 other_fields_2: "{\"more\":2}")");
}

TEST(JsonType, integersAreTakenOnlyWhereTheyFit) {
  const std::string schema = R"({"i": {"type": "integer"}})";
  EXPECT_EQ(shown(schema, R"({"i": -9223372036854775808})"), "i: -9223372036854775808");
  EXPECT_EQ(shown(schema, R"({"i": 3.0})"), "i: 3");
  EXPECT_EQ(shown(schema, R"({"i": "12"})"), "i: 12");
  EXPECT_EQ(shown(schema, R"({"i": 18446744073709551615})"),
            R"(other_fields: "{\"i\":18446744073709551615}")");
  EXPECT_EQ(shown(schema, R"({"i": 3.5})"), R"(other_fields: "{\"i\":3.5}")");
  EXPECT_EQ(shown(schema, R"({"i": 1e300})"), R"(other_fields: "{\"i\":1e+300}")");
}

TEST(JsonType, withoutASchemaTheFirstMessageSays) {
  const auto type =
      JsonType::ofMessage("json", bytesOf(R"({"speed": 1, "pose": {"x": 2.5}, "names": ["a"], "on": true})"));
  ASSERT_NE(type, nullptr);
  EXPECT_EQ(
      shown(read(type, R"({"speed": 1.5, "pose": {"x": 3, "y": 4}, "names": ["b", "c"], "on": false})")),
      R"(names: "b" names: "c" on: false pose { x: 3 } speed: 1.5 other_fields: "{\"pose.y\":4}")");
  EXPECT_EQ(JsonType::ofMessage("json", bytesOf("[1, 2]")), nullptr);
}

TEST(JsonType, whatMakesNoSenseIsRefusedAndNothingGoesTooDeep) {
  for (const char* schema : {"", "{", "[]", "3", "{}", R"({"type": "object"})", R"({"properties": 3})",
                             R"({"$ref": "#"})", R"({"$ref": "#/no/where"})"}) {
    EXPECT_EQ(JsonType::ofSchema("T", schema), nullptr) << schema;
  }
  const std::string deep(100'000, '[');
  EXPECT_EQ(shown(R"({"a": {}})", R"({"a": )" + deep), "none");
  EXPECT_FALSE(parseJsonObject(R"({"a": )" + deep + std::string(100'000, ']') + "}").has_value());
  // Arrays of themselves.
  EXPECT_NE(JsonType::ofSchema("T", R"({"properties": {"a": {"$ref": "#/$defs/a"}},
    "$defs": {"a": {"type": "array", "items": {"$ref": "#/$defs/a"}}}})"),
            nullptr);
  EXPECT_EQ(shown(R"({"a": {"type": "integer"}})", "[]"), "none");
  EXPECT_EQ(shown(R"({"a": {"type": "integer"}})", "{}"), "");
}

TEST(JsonType, base64IsDecoded) {
  EXPECT_EQ(decodeBase64(""), "");
  EXPECT_EQ(decodeBase64("TQ=="), "M");
  EXPECT_EQ(decodeBase64("TWFu"), "Man");
  EXPECT_EQ(decodeBase64("TWE"), "Ma");
  EXPECT_EQ(decodeBase64("T"), std::nullopt);
  EXPECT_EQ(decodeBase64("TW*u"), std::nullopt);
}

}  // namespace robotlink
