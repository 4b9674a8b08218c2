// SPDX-License-Identifier: GPL-3.0-or-later
// A robot with a gripper and a GPS receiver, as its client sees them.
#include <gtest/gtest.h>

#include "robotlink/arcos/GripperState.h"
#include "tests/robotlink/arcos/IdealRobot.h"

namespace {

using namespace robotlink;
using namespace robotlink::arcos;

ServerSettings withGripper() {
  ServerSettings settings;
  settings.gripper = true;
  return settings;
}

GripperState gripperOf(IdealRobot& robot) {
  return gripperState(robot.information().back().gripState.value());
}

TEST(ServerDevices, theGripperDoesWhatItsClientCommandsAndReportsIt) {
  IdealRobot robot(withGripper());
  robot.connect();
  robot.sensing.gripper.liftDown = true;
  robot.send(CommandId::kGripper, 2);
  robot.run(0.25);
  EXPECT_EQ(robot.session.gripperCommand().paddles, -1);
  EXPECT_TRUE(gripperOf(robot).moving);
  EXPECT_TRUE(gripperOf(robot).liftDown);
  robot.sensing.gripper = {.liftDown = true, .leftPaddle = true, .rightPaddle = true, .innerBeam = true};
  robot.send(CommandId::kGripperRequest, 1);
  robot.run(0.6);
  EXPECT_TRUE(robot.session.gripperCommand().grasps);
  EXPECT_TRUE(gripperOf(robot).closed);
  const auto packet = decode<GripperPacket>(robot.of(GripperPacket::kId).at(0));
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->hasGripper, 2);
  EXPECT_EQ(packet->state & 0x3C, 0x08) << "the inner beam is broken, both paddles are pressed";
  robot.send(CommandId::kGripper, 4);
  robot.run(0.1);
  EXPECT_EQ(robot.session.gripperCommand().lift, 1);
  robot.session.clientGone(robot.now);
  robot.run(0.1);
  EXPECT_EQ(robot.session.gripperCommand().lift, 0) << "without a client it stops";
}

TEST(ServerDevices, theGpsReceiverIsReadAtItsSerialLine) {
  IdealRobot robot;
  robot.connect();
  robot.sensing.gps = GlobalPosition{53.1, 8.85, 12};
  robot.send(CommandId::kGetAux, 40);
  robot.run(1.5);
  const auto packets = robot.of(AuxSerialPacket::kIds[0]);
  ASSERT_EQ(packets.size(), 1U);
  const auto packet = decode<AuxSerialPacket>(packets[0]);
  ASSERT_TRUE(packet);
  const std::string text(packet->bytes.begin(), packet->bytes.end());
  EXPECT_EQ(text.size(), 40U);
  EXPECT_EQ(text.substr(0, 7), "$GPGGA,");
  EXPECT_NE(text.find("5306.0000,N"), std::string::npos) << text;
}

TEST(ServerDevices, withoutAReceiverNothingComes) {
  IdealRobot robot;
  robot.connect();
  robot.send(CommandId::kGetAux, 1);
  robot.run(3);
  EXPECT_TRUE(robot.of(AuxSerialPacket::kIds[0]).empty());
}

}  // namespace
