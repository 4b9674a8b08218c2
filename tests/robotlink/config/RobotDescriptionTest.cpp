// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotDescription.h"

#include <gmock/gmock.h>

namespace robotlink {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string kNamed = "name: walker\ntitle: A walker\n";
const std::string kPlatform = "platform: {offers: [joints/state], takes: [joints/request]}\n";
const std::string kOneJoint = "joints:\n- {name: neck, limits_deg: [-90, 45], max_speed: 2}\n";

/// A description of a robot that moves a joint, with `more` in it.
std::string robotWith(const std::string& more) {
  return kNamed + kPlatform + kOneJoint + more;
}

/// A description of a robot with these joints.
std::string robotOf(const std::string& joints) {
  return kNamed + kPlatform + "joints:\n" + joints;
}

RobotDescription describedRobot(const std::string& text) {
  const auto robot = parseRobotDescription(text, "walker.yaml");
  EXPECT_TRUE(robot) << describe(robot.error());
  return robot.value_or(RobotDescription{});
}

std::string errorsOfRobot(const std::string& text) {
  const auto robot = parseRobotDescription(text, "walker.yaml");
  return robot ? "none" : describe(robot.error());
}

TEST(RobotDescription, anglesAreReadInDegreesAndWhatIsLeftOutHasItsDefault) {
  const RobotDescription robot = describedRobot(robotWith(""));
  EXPECT_EQ(robot.name, "walker");
  EXPECT_EQ(robot.layout, "compact");
  ASSERT_EQ(robot.joints.size(), 1U);
  EXPECT_DOUBLE_EQ(robot.joints[0].minimum, -kPi / 2);
  EXPECT_DOUBLE_EQ(robot.joints[0].maximum, kPi / 4);
  EXPECT_EQ(robot.joints[0].maximumSpeed, 2);
  EXPECT_EQ(robot.joints[0].stance, 0);
  EXPECT_EQ(robot.joints[0].mirror, "neck") << "a joint in the middle mirrors itself";
  EXPECT_THAT(robot.offers, ElementsAre("joints/state"));
  EXPECT_THAT(robot.simulatedOnly, IsEmpty());
  EXPECT_FALSE(robot.drive || robot.sonars || robot.laser || robot.camera || robot.battery);
}

TEST(RobotDescription, jointsHaveTheirOrderAndAreFoundByName) {
  const RobotDescription robot = describedRobot(
      robotOf("- {name: left, limits_deg: [-30, 60], max_speed: 1, stance_deg: 30, mirror: -right}\n"
              "- {name: right, limits_deg: [-60, 30], max_speed: 1, stance_deg: -30, mirror: -left}\n"));
  EXPECT_EQ(robot.jointIndex("right"), 1);
  EXPECT_EQ(robot.jointIndex("tail"), -1);
  EXPECT_EQ(robot.joints[0].mirror, "right");
  EXPECT_TRUE(robot.joints[0].mirrorIsNegated);
  EXPECT_DOUBLE_EQ(robot.joints[0].stance, radians(30.0));
}

TEST(RobotDescription, aJointThatCannotBeIsReportedWithItsLine) {
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [10, 10], max_speed: 1, stance_deg: 10}\n")),
              HasSubstr("walker.yaml:5:3: the lower limit must be below the upper one"));
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [10, 20], max_speed: 1}\n")),
              HasSubstr("the stance is outside the limits of joint a"));
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [0, 20, 30], max_speed: 1}\n")),
              HasSubstr("'limits_deg' must have 2 numbers"));
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [0, 20], max_speed: -1}\n")),
              HasSubstr("'max_speed' must be between 0 and 100"));
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [0, .nan], max_speed: 1}\n")),
              HasSubstr("a finite number"));
}

TEST(RobotDescription, allErrorsAreReportedInTheirOrder) {
  const std::string errors =
      errorsOfRobot(robotOf("- {name: a, limits_deg: [0, 20], max_speed: 1, mirror: b}\n"
                            "- {name: a, limits_deg: [30, 20], max_speed: 1, stance_deg: 25, speed: 1}\n"));
  EXPECT_THAT(errors, AllOf(HasSubstr("joint a is mirrored by b, which is no joint"),
                            HasSubstr("joint a is listed twice"), HasSubstr("lower limit"),
                            HasSubstr("unknown key 'speed'")));
  EXPECT_LT(errors.find("listed twice"), errors.find("unknown key"));
}

TEST(RobotDescription, aNegatedMirrorWithoutAJointIsRefused) {
  EXPECT_THAT(errorsOfRobot(robotOf("- {name: a, limits_deg: [0, 20], max_speed: 1, mirror: '-'}\n")),
              HasSubstr("which is no joint"));
}

TEST(RobotDescription, aRobotMovesOrSees) {
  EXPECT_THAT(errorsOfRobot(kNamed + kPlatform), HasSubstr("a robot needs joints, a drive or a camera"));
  EXPECT_EQ(errorsOfRobot(kNamed + kPlatform +
                          "camera: {position: [0, 0, 1], tilt_deg: 30, horizontal_angle_deg: 60}\n"),
            "none");
}

TEST(RobotDescription, aPlatformSaysWhatItSendsAndTakes) {
  EXPECT_THAT(errorsOfRobot(kNamed + kOneJoint), HasSubstr("the key 'platform' is missing"));
  EXPECT_THAT(errorsOfRobot(kNamed + kOneJoint + "platform: {offers: [a]}\n"),
              HasSubstr("the key 'takes' is missing"));
  const RobotDescription robot =
      describedRobot(kNamed + kOneJoint + "platform: {offers: [a, b], simulated_only: [b], takes: []}\n");
  EXPECT_THAT(robot.simulatedOnly, ElementsAre("b"));
}

const std::string kRollingDrive =
    "drive: {length: 0.5, width: 0.4, radius: 0.35, wheel_radius: 0.1, track: 0.6, max_speed: 0.7, "
    "max_rotation_deg: 180, acceleration: 1, rotation_acceleration_deg: 90}\n";

TEST(RobotDescription, aDriveTurnsByRadians) {
  const RobotDescription robot = describedRobot(kNamed + kPlatform + kRollingDrive);
  ASSERT_TRUE(robot.drive);
  EXPECT_DOUBLE_EQ(robot.drive->maximumRotation, kPi);
  EXPECT_DOUBLE_EQ(robot.drive->rotationAcceleration, kPi / 2);
  EXPECT_EQ(robot.drive->track, 0.6);
  EXPECT_EQ(robot.drive->wheelRadius, 0.1);
}

TEST(RobotDescription, sonarsAreWhereTheyAreInTheRobot) {
  const RobotDescription robot =
      describedRobot(robotWith("sonars: {opening_deg: 30, max: 5, sensors: [{pose: [0.1, 0.2, 90]}, "
                               "{pose: [-0.1, 0, -180]}]}\n"));
  ASSERT_EQ(robot.sonars.value().sensors.size(), 2U);
  EXPECT_EQ(robot.sonars->sensors[0].inRobot.y, 0.2);
  EXPECT_DOUBLE_EQ(robot.sonars->sensors[0].inRobot.heading, kPi / 2);
  EXPECT_DOUBLE_EQ(robot.sonars->openingAngle, kPi / 6);
  EXPECT_THAT(errorsOfRobot(robotWith("sonars: {opening_deg: 30, max: 5, sensors: [{pose: [0.1, 0.2]}]}\n")),
              HasSubstr("'pose' must have 3 numbers"));
}

TEST(RobotDescription, aLaserScansCounterClockwise) {
  const auto laser = [](const std::string& start, const std::string& end, const std::string& readings) {
    return robotWith("laser: {pose: [0, 0, 0], start_deg: " + start + ", end_deg: " + end +
                     ", readings: " + readings + ", max: 8}\n");
  };
  EXPECT_DOUBLE_EQ(describedRobot(laser("-90", "90", "181")).laser.value().startAngle, -kPi / 2);
  EXPECT_THAT(errorsOfRobot(laser("90", "-90", "181")), HasSubstr("end_deg must be above start_deg"));
  EXPECT_THAT(errorsOfRobot(laser("0", "0", "181")), HasSubstr("end_deg must be above start_deg"));
  EXPECT_THAT(errorsOfRobot(laser("-90", "90", "1")), HasSubstr("'readings' must be between 2 and 10000"));
  EXPECT_THAT(errorsOfRobot(laser("-90", "90", "2.5")), HasSubstr("a whole number, not '2.5'"));
}

TEST(RobotDescription, aCameraThatIsTiltedLooksDown) {
  const RobotDescription robot =
      describedRobot(robotWith("camera: {position: [0.1, 0, 1], tilt_deg: 90, horizontal_angle_deg: 60}\n"));
  const Vector3 seen = robot.camera.value().inRobot * Vector3(0.4, 0, 0);
  EXPECT_TRUE(seen.isApprox(Vector3(0.1, 0, 0.6))) << seen.transpose();
  EXPECT_THAT(errorsOfRobot(robotWith("camera: {position: [0, 1], tilt_deg: 0, horizontal_angle_deg: 60}\n")),
              HasSubstr("position must be [x, y, z]"));
  EXPECT_THAT(
      errorsOfRobot(robotWith("camera: {position: [0, 0, 1], tilt_deg: 0, horizontal_angle_deg: 180}\n")),
      HasSubstr("'horizontal_angle_deg' must be between 1 and 179"));
}

TEST(RobotDescription, voltagesOfABatteryGoUp) {
  const auto battery = [](const std::string& voltages) {
    return errorsOfRobot(robotWith("battery: {" + voltages + "}\n"));
  };
  EXPECT_EQ(battery("empty: 10, low: 11, full: 12"), "none");
  EXPECT_EQ(battery("empty: 10, low: 10, full: 12"), "none") << "it may be low only when it is empty";
  for (const char* wrong :
       {"empty: 11, low: 10, full: 12", "empty: 10, low: 12, full: 12", "empty: 10, low: 11, full: 9"})
    EXPECT_THAT(battery(wrong), HasSubstr("empty, low and full must be voltages in that order")) << wrong;
}

TEST(RobotDescription, theKeysOfItsUseBelongToTheFile) {
  EXPECT_EQ(errorsOfRobot(robotWith("field: soccer\nteams: [red]\n")), "none");
  EXPECT_THAT(errorsOfRobot(robotWith("colour: red\n")), HasSubstr("unknown key 'colour'"));
}

TEST(RobotDescription, aFileThatIsMissingOrNoYamlIsNamed) {
  const auto missing = readRobotDescription("/nowhere/robot.yaml");
  ASSERT_FALSE(missing);
  EXPECT_THAT(describe(missing.error()), HasSubstr("/nowhere/robot.yaml"));
  EXPECT_THAT(errorsOfRobot("name: [unclosed"), HasSubstr("walker.yaml"));
}

}  // namespace
}  // namespace robotlink
