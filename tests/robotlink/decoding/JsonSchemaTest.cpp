// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonSchema.h"

#include <gmock/gmock.h>

using nlohmann::json;
using testing::ElementsAre;
using testing::Pair;
using testing::SizeIs;

namespace robotlink {
namespace {

using google::protobuf::DescriptorProto;
using google::protobuf::FieldDescriptorProto;

/// "T: a double, b repeated string, c .p.T_c", without the field for what does not fit.
std::string described(const DescriptorProto& message) {
  std::string text;
  for (const FieldDescriptorProto& field : message.field()) {
    if (field.name().starts_with("other_fields")) continue;
    text += text.empty() ? " " : ", ";
    text += field.name() + (field.label() == FieldDescriptorProto::LABEL_REPEATED ? " repeated " : " ");
    text += field.type() == FieldDescriptorProto::TYPE_MESSAGE
                ? field.type_name()
                : FieldDescriptorProto::Type_Name(field.type()).substr(5);
  }
  return message.name() + ":" + text;
}

/// The types that are made of a schema, the first one for the whole.
std::vector<std::string> typesOf(const json& root, const std::string& name = "p.T") {
  std::vector<std::string> types;
  const auto file = JsonSchema(root).describe(name, "");
  for (const DescriptorProto& message : file.message_type()) types.push_back(described(message));
  return types;
}

std::vector<std::string> typesOfAll(const std::string& properties) {
  return typesOf(json{{"type", "object"}, {"properties", json::parse(properties)}});
}

TEST(JsonSchema, plainTypesBecomeFields) {
  EXPECT_THAT(typesOfAll(R"({"a": {"type": "number"}, "b": {"type": "integer"}, "c": {"type": "boolean"},
                  "d": {"type": "string"}, "e": {"type": "string", "contentEncoding": "base64"}, "f": true})"),
              ElementsAre("T: a DOUBLE, b INT64, c BOOL, d STRING, e BYTES, f STRING"));
}

TEST(JsonSchema, theTypeIsAlsoFoundWhereItIsNotNamed) {
  EXPECT_THAT(typesOfAll(R"({"a": {"enum": [1, 2]}, "b": {"const": "x"}, "c": {"enum": [1, "x"]},
                          "d": {"type": ["integer", "number"]}, "e": {"type": ["null", "boolean"]},
                          "f": {"items": {"type": "number"}}, "g": {"properties": {"h": {"type": "integer"}}}})"),
              ElementsAre("T: a INT64, b STRING, c STRING, d DOUBLE, e BOOL, f repeated DOUBLE, g .p.T_g",
                          "T_g: h INT64"));
}

TEST(JsonSchema, objectsBecomeTypesAndTimesThoseOfProtobuf) {
  EXPECT_THAT(
      typesOfAll(R"({"at": {"properties": {"sec": {"type": "integer"}, "nsec": {"type": "integer"}}},
                  "for": {"title": "duration", "properties": {"sec": {"type": "integer"}, "nanosec": {"type": "integer"}}},
                  "none": {"properties": {"sec": {"type": "integer"}, "nsec": {"type": "string"}}},
                  "empty": {"type": "object"}})"),
      ElementsAre(
          "T: at .google.protobuf.Timestamp, empty STRING, for .google.protobuf.Duration, none .p.T_none",
          "T_none: nsec STRING, sec INT64"));
}

TEST(JsonSchema, arraysOfArraysBecomeRows) {
  EXPECT_THAT(
      typesOfAll(R"({"m": {"type": "array", "items": {"type": "array", "items": {"type": "number"}}},
                          "any": {"type": "array"}})"),
      ElementsAre("T: any repeated STRING, m repeated .p.T_m_row", "T_m_row: values repeated DOUBLE"));
}

TEST(JsonSchema, aSchemaThatContainsItselfEnds) {
  EXPECT_THAT(
      typesOf(json::parse(R"({"$ref": "#/node", "node": {"properties": {"next": {"$ref": "#/node"}}}})")),
      ElementsAre("T: next .p.T"));
  EXPECT_THAT(typesOfAll(R"({"a": {"$ref": "#/no/where"}, "b": {"$ref": "http://other"}})"),
              ElementsAre("T: a STRING, b STRING"));
}

TEST(JsonSchema, namesBecomeThoseOfProtobufAndStayDistinct) {
  const json root = json::parse(
      R"({"properties": {"a-b": {"type": "integer"}, "a.b": {"type": "integer"}, "2nd": {"properties": {"x": {"type": "integer"}}}}})");
  JsonSchema schema(root);
  const auto file = schema.describe("their-own.1/Thing", "json");
  EXPECT_EQ(file.package(), "json.their_own._1");
  EXPECT_EQ(schema.typeName(), "json.their_own._1.Thing");
  EXPECT_EQ(schema.otherFields(), "other_fields");
  const std::string type = "json.their_own._1.Thing";
  EXPECT_THAT(schema.fields(),
              ElementsAre(Pair(Pair(type, "2nd"), "_2nd"), Pair(Pair(type, "a-b"), "a_b"),
                          Pair(Pair(type, "a.b"), "a_b_2"), Pair(Pair(type + "__2nd", "x"), "x")));
}

TEST(JsonSchema, aNameWithoutAWordGetsOne) {
  const json root = json::object();
  JsonSchema schema(root);
  EXPECT_EQ(schema.describe("", "json").package(), "json");
  EXPECT_EQ(schema.typeName(), "json.Message");
}

TEST(JsonSchema, aHugeSchemaIsCutShort) {
  json properties = json::object();
  for (int i = 0; i < 5000; ++i) properties["p" + std::to_string(i)] = {{"type", "integer"}};
  const json root{{"properties", properties}};
  const auto file = JsonSchema(root).describe("T", "");
  EXPECT_THAT(file.message_type(0).field(), SizeIs(4001)) << "with that for what does not fit";
}

TEST(JsonSchema, manyNamesThatProtobufCannotTellApartAreNumberedAtOnce) {
  json properties = json::object();
  for (int i = 0; i < 4000; ++i) {
    std::string name;
    for (int bit = 0; bit < 12; ++bit) name += (i >> bit & 1) != 0 ? '-' : '.';
    properties[name] = {{"type", "integer"}};
  }
  const json root{{"properties", properties}};
  const auto file = JsonSchema(root).describe("T", "");
  ASSERT_THAT(file.message_type(0).field(), SizeIs(4001));
  EXPECT_EQ(file.message_type(0).field(0).name(), "____________");
  EXPECT_EQ(file.message_type(0).field(1).name(), "_____________2");
  EXPECT_EQ(file.message_type(0).field(3999).name(), "_____________4000");
}

TEST(JsonSchema, ofAValueHasItsMembers) {
  EXPECT_EQ(JsonSchema::ofValue(json::parse(R"({"a": 1, "b": [true], "c": null, "d": [], "e": {"f": "x"}})")),
            json::parse(R"({"type": "object", "properties": {
              "a": {"type": "number"}, "b": {"type": "array", "items": {"type": "boolean"}},
              "c": {"type": "string"}, "d": {"type": "array"},
              "e": {"type": "object", "properties": {"f": {"type": "string"}}}}})"));
}

}  // namespace
}  // namespace robotlink
