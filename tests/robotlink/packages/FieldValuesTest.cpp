// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/FieldValues.h"

#include <google/protobuf/duration.pb.h>
#include <google/protobuf/timestamp.pb.h>
#include <gtest/gtest.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "tests/robotlink/packages/ForeignTime.h"

namespace robotlink {
namespace {

using google::protobuf::Message;

/// The value of a field in words: its kind and itself.
std::string shown(const Message& message, const std::string& field, int element = -1) {
  return visitValue(message, *message.GetDescriptor()->FindFieldByName(field), element,
                    [](const auto& value) -> std::string {
                      using Value = std::decay_t<decltype(value)>;
                      if constexpr (std::is_same_v<Value, EnumNumber>) {
                        return "enumerator " + std::to_string(value.number);
                      } else if constexpr (std::is_same_v<Value, std::string>) {
                        return "text " + value;
                      } else if constexpr (std::is_same_v<Value, Message>) {
                        return "message " + value.ShortDebugString();
                      } else if constexpr (std::is_same_v<Value, bool>) {
                        return value ? "yes" : "no";
                      } else {
                        return "number " + std::to_string(value);
                      }
                    });
}

TEST(FieldValues, areVisitedAsWhatTheyAre) {
  foxglove::Log log;
  log.set_level(foxglove::Log::WARNING);
  log.set_message("low");
  log.set_line(7);
  log.mutable_timestamp()->set_seconds(5);
  EXPECT_EQ(shown(log, "level"), "enumerator 3");
  EXPECT_EQ(shown(log, "message"), "text low");
  EXPECT_EQ(shown(log, "line"), "number 7");
  EXPECT_EQ(shown(log, "timestamp"), "message seconds: 5");
  robotcontrol::KeyTable::Key key;
  key.set_in_use(true);
  key.add_solutions("a");
  key.add_solutions("b");
  EXPECT_EQ(shown(key, "in_use"), "yes");
  EXPECT_EQ(shown(key, "solutions", 1), "text b");
  foxglove::JointStates joints;
  joints.add_joints()->set_position(1.5);
  EXPECT_EQ(shown(joints, "joints", 0), "message position: 1.5");
  EXPECT_EQ(shown(joints.joints(0), "position"), "number 1.500000");
}

TEST(FieldValues, timesAreTimestampsAndDurationsButNoForeignTypesOfThatName) {
  EXPECT_TRUE(isTime(*google::protobuf::Timestamp::descriptor()));
  EXPECT_TRUE(isTime(*google::protobuf::Duration::descriptor()));
  EXPECT_FALSE(isTime(*foxglove::Log::descriptor()));
  EXPECT_FALSE(isTime(test::ForeignTime().timeType()));
  google::protobuf::Duration time;
  time.set_seconds(-3);
  time.set_nanos(-5);
  EXPECT_EQ(wholeSeconds(time), -3);
  EXPECT_EQ(nanoseconds(time), -5);
}

}  // namespace
}  // namespace robotlink
