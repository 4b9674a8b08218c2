// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/export/MessageTable.h"

#include <gmock/gmock.h>
#include <google/protobuf/text_format.h>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"

namespace logplayer {
namespace {

using testing::ElementsAre;

template <typename T>
T parsed(const std::string& text) {
  T message;
  EXPECT_TRUE(google::protobuf::TextFormat::ParseFromString(text, &message));
  return message;
}

TEST(MessageTable, nestedFieldsAreFlattenedAndRepeatedOnesIndexed) {
  const auto first = parsed<foxglove::JointStates>("joints { name: 'a' position: 0.1 }");
  const auto second = parsed<foxglove::JointStates>(
      "timestamp { seconds: 12 nanos: 5 } joints { name: 'a' } joints { name: 'b' velocity: -2 }");
  MessageTable table;
  table.learn(first);
  table.learn(second);
  EXPECT_THAT(table.columns(), ElementsAre("timestamp", "joints[0].name", "joints[0].position",
                                           "joints[1].name", "joints[1].velocity"));
  EXPECT_THAT(table.row(first), ElementsAre("", "a", "0.1", "", ""));
  EXPECT_THAT(table.row(second), ElementsAre("12.000000005", "a", "", "b", "-2"));
  EXPECT_EQ(table.leftOut(), 0U);
}

TEST(MessageTable, numbersOfFieldsWithoutPresenceAreThereAlsoIfTheyAreZero) {
  const robotcontrol::BallModel ball;
  MessageTable table;
  table.learn(ball);
  EXPECT_THAT(table.columns(), ElementsAre("known", "seconds_since_seen", "standard_deviation"));
  EXPECT_THAT(table.row(ball), ElementsAre("false", "0", "0"));
}

TEST(MessageTable, enumerationsAreNamesAndBytesBase64) {
  MessageTable table;
  const auto log = parsed<foxglove::Log>("level: ERROR message: 'x'");
  table.learn(log);
  EXPECT_THAT(table.row(log), ElementsAre("ERROR", "x", "", "", "0"));
  for (const auto& [bytes, text] :
       {std::pair("", ""), {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}}) {
    foxglove::CompressedImage image;
    image.set_data(bytes);
    MessageTable images;
    images.learn(image);
    ASSERT_THAT(images.columns(), ElementsAre("data", "format", "frame_id"));
    EXPECT_EQ(images.row(image).front(), text);
  }
}

TEST(MessageTable, aTableHasNoMoreColumnsThanASpreadsheetTakes) {
  foxglove::JointStates states;
  for (int i = 0; i < 10'000; ++i) states.add_joints()->set_position(i);
  MessageTable table;
  table.learn(states);
  EXPECT_EQ(table.columns().size(), MessageTable::kMaxColumns);
  EXPECT_EQ(table.leftOut(), 20'000U - MessageTable::kMaxColumns);  // each joint has a name, too
  EXPECT_EQ(table.row(states).size(), MessageTable::kMaxColumns);
}

TEST(MessageTable, cellsWithCommasQuotesAndLineEndsAreQuoted) {
  EXPECT_EQ(csvLine({"plain", "a,b", "say \"x\"", "two\nlines", ""}),
            "plain,\"a,b\",\"say \"\"x\"\"\",\"two\nlines\",\r\n");
  EXPECT_EQ(csvLine({}), "\r\n");
}

TEST(MessageTable, secondsHaveTheirSign) {
  EXPECT_EQ(secondsText(12, 340'000'000), "12.340000000");
  EXPECT_EQ(secondsText(0, 1), "0.000000001");
  EXPECT_EQ(secondsText(-1, 500'000'000), "-0.500000000");  // a time stamp
  EXPECT_EQ(secondsText(0, -500'000'000), "-0.500000000");  // a duration
  EXPECT_EQ(secondsText(-2, 0), "-2.000000000");
  EXPECT_EQ(secondsText(-2, -500'000'000), "-2.500000000");
}

}  // namespace
}  // namespace logplayer
