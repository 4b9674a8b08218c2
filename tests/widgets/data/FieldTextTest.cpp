// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldText.h"

#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "foxglove/Ranging.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace widgets::test {
namespace {

using google::protobuf::Message;

FieldPlace placeIn(const Message& message, const char* field, int element = -1) {
  return {&message, message.GetDescriptor()->FindFieldByName(field), element};
}

TEST(FieldText, numbersAreShortToBeReadAndCompleteToBeCopied) {
  foxglove::JointState joint;
  joint.set_position(1.0 / 3);
  EXPECT_EQ(valueText(placeIn(joint, "position")), QStringLiteral("0.333333"));
  EXPECT_EQ(valueText(placeIn(joint, "position"), Precision::kFull).toDouble(), 1.0 / 3);
  EXPECT_EQ(numberOf(placeIn(joint, "position")), 1.0 / 3);
}

TEST(FieldText, enumerationsAndBoolsAreWordsAndNumbers) {
  robotcontrol::KeyMode mode;
  mode.set_kind(robotcontrol::KeyMode::EVERY_MS);
  EXPECT_EQ(valueText(placeIn(mode, "kind")), QStringLiteral("EVERY_MS"));
  EXPECT_EQ(numberOf(placeIn(mode, "kind")), robotcontrol::KeyMode::EVERY_MS);
  mode.set_kind(static_cast<robotcontrol::KeyMode::Kind>(99));
  EXPECT_EQ(valueText(placeIn(mode, "kind")), QStringLiteral("99"));
  robotcontrol::Stop stop;
  stop.set_engaged(true);
  EXPECT_EQ(valueText(placeIn(stop, "engaged")), QStringLiteral("true"));
  EXPECT_EQ(numberOf(placeIn(stop, "engaged")), 1);
}

TEST(FieldText, timestampsAreSecondsSinceAStartOrDates) {
  foxglove::JointStates states;
  states.mutable_timestamp()->set_seconds(12);
  states.mutable_timestamp()->set_nanos(345'678'901);
  EXPECT_EQ(valueText(placeIn(states, "timestamp")), QStringLiteral("12.346"));
  EXPECT_EQ(valueText(placeIn(states, "timestamp"), Precision::kFull), QStringLiteral("12.345678901"));
  EXPECT_NEAR(numberOf(placeIn(states, "timestamp")).value(), 12.345678901, 1e-12);
  states.mutable_timestamp()->set_seconds(1'000'000'000);
  EXPECT_EQ(valueText(placeIn(states, "timestamp")), QStringLiteral("2001-09-09 01:46:40.345"));
  // A time is a value, not a message with fields.
  EXPECT_EQ(placeIn(states, "timestamp").message(), nullptr);
}

TEST(FieldText, textsAreOneLineToBeReadAndNoNumbers) {
  foxglove::JointState joint;
  joint.set_name("head\n.pan");
  EXPECT_EQ(valueText(placeIn(joint, "name")), QStringLiteral("head .pan"));
  EXPECT_EQ(valueText(placeIn(joint, "name"), Precision::kFull), QStringLiteral("head\n.pan"));
  EXPECT_FALSE(numberOf(placeIn(joint, "name")).has_value());
  joint.set_name(std::string(5000, 'x'));
  EXPECT_LE(valueText(placeIn(joint, "name")).size(), 1000);
}

TEST(FieldText, elementsOfListsArePlacesOfTheirOwn) {
  foxglove::JointStates states;
  for (const double position : {0.5, 1.5}) states.add_joints()->set_position(position);
  const FieldPlace list = placeIn(states, "joints");
  EXPECT_EQ(list.size(), 2);
  EXPECT_TRUE(valueText(list).isEmpty());
  EXPECT_EQ(list.message(), nullptr);
  const Message* second = placeIn(states, "joints", 1).message();
  ASSERT_NE(second, nullptr);
  EXPECT_EQ(valueText(placeIn(*second, "position")), QStringLiteral("1.5"));
  EXPECT_FALSE(placeIn(states, "joints", 2).isSet());
  EXPECT_FALSE(FieldPlace{}.isSet());
}

TEST(FieldText, statisticsOfAListLeaveOutWhatIsInfinite) {
  foxglove::LaserScan scan;
  for (const double range : {1.0, 2.0, std::numeric_limits<double>::infinity(), 6.0}) scan.add_ranges(range);
  EXPECT_EQ(statisticsText(placeIn(scan, "ranges"), 0, 4), QStringLiteral("4 elements, 1 to 6, mean 3"));
  EXPECT_EQ(statisticsText(placeIn(scan, "ranges"), 3, 100), QStringLiteral("1 element, 6 to 6, mean 6"));
  EXPECT_EQ(statisticsText(placeIn(scan, "ranges"), 2, 1), QStringLiteral("1 element"));
  EXPECT_EQ(statisticsText(placeIn(scan, "ranges"), 9, 5), QStringLiteral("0 elements"));
}

TEST(FieldText, summariesNameTheFirstPlainFields) {
  foxglove::JointState joint;
  joint.set_name("mouth");
  joint.set_position(0.25);
  const QString summary = summaryText(joint);
  EXPECT_TRUE(summary.contains(QStringLiteral("name mouth"))) << summary.toStdString();
  EXPECT_TRUE(summary.contains(QStringLiteral("position 0.25"))) << summary.toStdString();
}

TEST(FieldText, typesAreNamedForPeople) {
  const auto& states = *foxglove::JointStates::descriptor();
  EXPECT_EQ(typeText(*states.FindFieldByName("joints")), QStringLiteral("list of foxglove.JointState"));
  EXPECT_TRUE(holdsMessages(*states.FindFieldByName("joints")));
  EXPECT_FALSE(holdsMessages(*states.FindFieldByName("timestamp")));
  EXPECT_TRUE(holdsNumbers(*states.FindFieldByName("timestamp")));
  const auto& joint = *foxglove::JointState::descriptor();
  EXPECT_EQ(typeText(*joint.FindFieldByName("position")), QStringLiteral("double"));
  EXPECT_FALSE(holdsNumbers(*joint.FindFieldByName("name")));
}

}  // namespace
}  // namespace widgets::test
