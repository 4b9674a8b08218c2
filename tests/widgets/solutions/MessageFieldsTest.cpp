// SPDX-License-Identifier: GPL-3.0-or-later
// Values of parameters that a person types, into messages of any type.
#include "widgets/solutions/MessageFields.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"

namespace widgets {
namespace {

using google::protobuf::Message;

/// The path "joints[1].position".
FieldPath pathTo(const Message& root, const std::string& text) {
  FieldPath path;
  const google::protobuf::Descriptor* type = root.GetDescriptor();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('.', begin), text.size());
    std::string name = text.substr(begin, end - begin);
    FieldStep step;
    if (const auto bracket = name.find('['); bracket != std::string::npos) {
      step.element = std::stoi(name.substr(bracket + 1));
      name.resize(bracket);
    }
    step.field = type->FindFieldByName(name);
    EXPECT_NE(step.field, nullptr) << text;
    type = step.field->message_type();
    path.push_back(step);
    begin = end + 1;
  }
  return path;
}

bool set(Message& message, const std::string& path, const QVariant& value) {
  return setValueAt(message, pathTo(message, path), value);
}
QVariant get(const Message& message, const std::string& path) {
  return valueAt(message, pathTo(message, path));
}
QString typed(const char* text) {
  return QString::fromUtf8(text);
}

/// A value is refused, and nothing has changed.
void expectRefused(Message& message, const std::string& path, const QVariant& value) {
  const std::string before = message.SerializeAsString();
  EXPECT_FALSE(set(message, path, value)) << path << " = " << value.toString().toStdString();
  EXPECT_EQ(message.SerializeAsString(), before) << path;
}

foxglove::JointStates twoJoints() {
  foxglove::JointStates joints;
  joints.add_joints()->set_name("head");
  joints.add_joints()->set_name("leg");
  return joints;
}

TEST(MessageFields, valuesOfEveryKindAreReadBackAsTheyWereTyped) {
  robotcontrol::HeadMode head;
  EXPECT_TRUE(set(head, "pan", typed("-0.25")));
  EXPECT_EQ(get(head, "pan").toDouble(), -0.25);
  EXPECT_TRUE(set(head, "kind", typed("ANGLES")));
  EXPECT_EQ(get(head, "kind").toString(), typed("ANGLES"));
  robotcontrol::KeyMode mode;
  EXPECT_TRUE(set(mode, "n", typed("4294967295")));
  EXPECT_EQ(mode.n(), 4294967295U);
  robotcontrol::BallPercept ball;
  EXPECT_TRUE(set(ball, "seen", true));
  EXPECT_TRUE(get(ball, "seen").toBool());
  EXPECT_TRUE(set(ball, "seen", typed("false")));
  EXPECT_FALSE(ball.seen());
  robotcontrol::FrameInfo info;
  EXPECT_TRUE(set(info, "process", typed("motion \xC3\xA4")));
  EXPECT_EQ(info.process(), "motion \xC3\xA4");
}

TEST(MessageFields, theLargestWholeNumbersCanBeTyped) {
  robotcontrol::FrameInfo info;
  EXPECT_TRUE(set(info, "number", typed("18446744073709551615")));
  EXPECT_EQ(info.number(), 18446744073709551615U);
  EXPECT_EQ(get(info, "number").toString(), typed("18446744073709551615"));
  expectRefused(info, "number", typed("18446744073709551616"));
  expectRefused(info, "number", typed("-1"));
}

TEST(MessageFields, elementsOfListsAreReachedAndOthersAreNot) {
  foxglove::JointStates joints = twoJoints();
  EXPECT_TRUE(set(joints, "joints[1].position", typed("1.5")));
  EXPECT_EQ(joints.joints(1).position(), 1.5);
  EXPECT_FALSE(joints.joints(0).has_position());
  EXPECT_EQ(get(joints, "joints[0].name").toString(), typed("head"));
  EXPECT_EQ(pathText(pathTo(joints, "joints[1].position")), typed("joints[1].position"));
  EXPECT_EQ(get(joints, "joints[7].name").toString(), QString()) << "past the end they read as defaults";
  expectRefused(joints, "joints[2].position", typed("1.5"));
}

TEST(MessageFields, whatDoesNotFitIsRefusedAndChangesNothing) {
  robotcontrol::HeadMode head;
  for (const char* text : {"", "left", "1.5 rad", "nan", "inf"}) expectRefused(head, "pan", typed(text));
  expectRefused(head, "kind", typed("DANCE"));
  robotcontrol::KeyMode mode;
  for (const char* text : {"-1", "4294967296", "1.5", "many"}) expectRefused(mode, "n", typed(text));
  robotcontrol::BallPercept ball;
  expectRefused(ball, "seen", typed("perhaps"));
  robotcontrol::ColorTable table;
  expectRefused(table, "cells", typed("bytes"));
  expectRefused(table, "class_names", typed("a list as a whole"));
}

TEST(MessageFields, aRefusalLeavesNoEmptyMessagesOnItsWay) {
  robotcontrol::BallPercept ball;
  expectRefused(ball, "position_in_robot.x", typed("far"));
  EXPECT_FALSE(ball.has_position_in_robot());
  EXPECT_TRUE(set(ball, "position_in_robot.x", typed("2")));
  EXPECT_TRUE(ball.has_position_in_robot());
  EXPECT_EQ(ball.position_in_robot().x(), 2);
}

TEST(MessageFields, whatCanBeTypedIsSaid) {
  const robotcontrol::HeadMode head;
  EXPECT_TRUE(choicesAt(pathTo(head, "kind")).contains(typed("TRACK_BALL")));
  EXPECT_TRUE(choicesAt(pathTo(head, "pan")).isEmpty());
  EXPECT_EQ(typeName(pathTo(head, "kind")), typed("choice"));
  EXPECT_EQ(typeName(pathTo(head, "pan")), typed("number"));
  EXPECT_EQ(typeName(pathTo(robotcontrol::KeyMode(), "n")), typed("whole number, not negative"));
  EXPECT_TRUE(isMessage(pathTo(head, "timestamp")));
  EXPECT_FALSE(isMessage(pathTo(head, "pan")));
}

}  // namespace
}  // namespace widgets
