// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/JsonValues.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"

using nlohmann::json;

namespace robotlink {
namespace {

/// The fields of a type and of those inside of it, by their own names.
void addFields(const google::protobuf::Descriptor& type, JsonFields& fields) {
  if (fields.contains(&type)) return;
  for (int i = 0; i < type.field_count(); ++i) {
    fields[&type][type.field(i)->name()] = type.field(i);
    if (type.field(i)->message_type() != nullptr) addFields(*type.field(i)->message_type(), fields);
  }
}

/// What becomes of a JSON object in a message, and of what does not fit.
template <typename Message>
std::string assigned(const std::string& text) {
  JsonFields fields;
  addFields(*Message::descriptor(), fields);
  Message message;
  json others;
  assignJson(message, json::parse(text), fields, others);
  return message.ShortDebugString() + (others.is_null() ? "" : " | " + others.dump());
}

TEST(JsonValues, integersAreTakenWhereTheyFit) {
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"width": 4294967295, "height": "12", "step": 3.0})"),
            "width: 4294967295 height: 12 step: 3");
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"width": 4294967296, "height": -1, "step": 1.5})"),
            R"( | {"height":-1,"step":1.5,"width":4294967296})");
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"width": "", "height": "1x", "step": true})"),
            R"( | {"height":"1x","step":true,"width":""})");
}

TEST(JsonValues, numbersMayBeNamedOrMissing) {
  EXPECT_EQ(assigned<robotcontrol::PlotValue>(R"({"value": -1})"), "value: -1");
  EXPECT_EQ(assigned<robotcontrol::PlotValue>(R"({"value": "NaN"})"), "value: nan");
  EXPECT_EQ(assigned<robotcontrol::PlotValue>(R"({"value": "-Infinity"})"), "value: -inf");
  EXPECT_EQ(assigned<robotcontrol::PlotValue>(R"({"value": null})"), "");
  EXPECT_EQ(assigned<robotcontrol::PlotValue>(R"({"value": "1"})"), R"( | {"value":"1"})");
}

TEST(JsonValues, timesHaveSecondsAndNanosecondsUnderAnyOfTheirNames) {
  for (const char* text :
       {R"({"timestamp": {"sec": 5, "nsec": 6}})", R"({"timestamp": {"sec": 5, "nanosec": 6}})",
        R"({"timestamp": {"seconds": 5, "nanos": 6}})"}) {
    EXPECT_EQ(assigned<foxglove::Log>(text), "timestamp { seconds: 5 nanos: 6 }");
  }
  for (const char* text :
       {R"({"timestamp":{"nsec":1000000000,"sec":5}})", R"({"timestamp":{"nsec":-1,"sec":5}})",
        R"({"timestamp":{"sec":5}})", R"({"timestamp":5})"}) {
    EXPECT_EQ(assigned<foxglove::Log>(text), std::string(" | ") + text);
  }
}

TEST(JsonValues, enumeratorsGoByNameOrNumber) {
  EXPECT_EQ(assigned<foxglove::Log>(R"({"level": "WARNING"})"), "level: WARNING");
  EXPECT_EQ(assigned<foxglove::Log>(R"({"level": 3})"), "level: WARNING");
  EXPECT_EQ(assigned<foxglove::Log>(R"({"level": "LOUD"})"), R"( | {"level":"LOUD"})");
}

TEST(JsonValues, textsTakeAnyJsonAndBytesBase64Only) {
  EXPECT_EQ(assigned<foxglove::Log>(R"({"message": "a", "name": [1, {"b": null}]})"),
            R"(message: "a" name: "[1,{\"b\":null}]")");
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"data": "TWFu"})"), R"(data: "Man")");
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"data": "T"})"), R"( | {"data":"T"})");
  EXPECT_EQ(assigned<foxglove::RawImage>(R"({"data": 7})"), R"( | {"data":7})");
}

TEST(JsonValues, whatDoesNotFitIsKeptUnderItsPath) {
  EXPECT_EQ(
      assigned<foxglove::JointStates>(
          R"({"joints": [{"name": "a", "position": 1}, {"name": "b", "place": 2}], "more": {"x": 1}})"),
      R"(joints { name: "a" position: 1 } joints { name: "b" } | {"joints[1].place":2,"more":{"x":1}})");
}

TEST(JsonValues, anArrayIsTakenWholeOrNotAtAll) {
  EXPECT_EQ(assigned<foxglove::JointStates>(R"({"joints": [{"name": "a"}, 5]})"),
            R"( | {"joints":[{"name":"a"},5]})");
  EXPECT_EQ(assigned<foxglove::JointStates>(R"({"joints": {"name": "a"}})"), R"( | {"joints":{"name":"a"}})");
  EXPECT_EQ(assigned<foxglove::JointStates>(R"({"joints": null})"), "");
}

}  // namespace
}  // namespace robotlink
