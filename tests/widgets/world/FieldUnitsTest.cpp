// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/FieldUnits.h"

#include <gtest/gtest.h>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"

namespace widgets {
namespace {

template <typename T>
std::string unit(const std::string& field) {
  return unitOf(T::descriptor()->full_name(), field).toStdString();
}

TEST(FieldUnits, numbersHaveTheUnitOfTheirField) {
  EXPECT_EQ(unit<robotcontrol::DriveState>("battery"), "V");
  EXPECT_EQ(unit<robotcontrol::DriveState>("temperature"),
            "\xC2\xB0"
            "C");
  EXPECT_EQ(unit<robotcontrol::BallPercept>("radius_in_image"), "px");
  EXPECT_EQ(unit<robotcontrol::BallPercept>("confidence"), "");
}

TEST(FieldUnits, numbersInsideOfMessagesHaveThatOfTheFieldAround) {
  EXPECT_EQ(unit<robotcontrol::BallPercept>("center_in_image.x"), "px");
  EXPECT_EQ(unit<robotcontrol::BallPercept>("position_in_robot.x"), "m");
  EXPECT_EQ(unit<robotcontrol::BallModel>("velocity_in_robot.y"), "m/s");
  EXPECT_EQ(unit<robotcontrol::BodySensors>("acceleration.z"), "m/s\xC2\xB2");
}

TEST(FieldUnits, theirOwnUnitComesFirst) {
  EXPECT_EQ(unit<robotcontrol::MotionStatus>("odometry.x"), "m");
  EXPECT_EQ(unit<robotcontrol::MotionStatus>("odometry.heading"), "rad");
  EXPECT_EQ(unit<robotcontrol::CameraPose>("camera_in_robot.position.z"), "m");
  EXPECT_EQ(unit<robotcontrol::CameraPose>("camera_in_robot.orientation.w"), "");
  EXPECT_EQ(unit<robotcontrol::BallModel>("timestamp.nanos"), "s");
}

TEST(FieldUnits, elementsAreNamedByNumberOrByName) {
  EXPECT_EQ(unit<foxglove::JointStates>("joints[head.pan].position"), "rad");
  EXPECT_EQ(unit<foxglove::JointStates>("joints[3].effort"), "N m");
  EXPECT_EQ(unit<robotcontrol::JointRequest>("positions[2]"), "rad");
}

TEST(FieldUnits, whatIsNotKnownHasNone) {
  EXPECT_EQ(unit<robotcontrol::DriveState>("no_such_field"), "");
  EXPECT_EQ(unit<foxglove::JointStates>("joints[head.pan"), "");
  EXPECT_EQ(unitOf("other.Message", "x").toStdString(), "");
  EXPECT_EQ(unit<robotcontrol::DriveState>(""), "");
}

}  // namespace
}  // namespace widgets
