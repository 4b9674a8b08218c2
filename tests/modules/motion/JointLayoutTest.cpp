// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/JointLayout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace modules {
namespace {

/// The joints of an ERS-210, in an order that is not that of the layout's functions, with an ear before them.
std::vector<robotlink::RobotDescription::Joint> ers210Joints() {
  std::vector<robotlink::RobotDescription::Joint> joints;
  for (const char* name :
       {"earL", "mouth", "headRoll", "headPan", "neckTilt", "legHR1", "legHR2", "legHR3", "legHL1", "legHL2",
        "legHL3", "legFR1", "legFR2", "legFR3", "legFL1", "legFL2", "legFL3"}) {
    robotlink::RobotDescription::Joint joint;
    joint.name = name;
    joint.minimum = -1;
    joint.maximum = 2;
    joint.maximumSpeed = 4;
    joint.stance = 0.1 * static_cast<double>(joints.size());
    joints.push_back(joint);
  }
  return joints;
}

TEST(JointLayout, findsJointsByTheirNamesWhateverTheirOrder) {
  const JointLayout layout = JointLayout::of(ers210Joints()).value();
  EXPECT_EQ(layout.names()[layout.legJoint(Leg::kFrontLeft, 2)], "legFL3");
  EXPECT_EQ(layout.names()[layout.legJoint(Leg::kHindRight, 0)], "legHR1");
  EXPECT_EQ(layout.names()[layout.headJoints()[1]], "headPan");
  EXPECT_NEAR(layout.stance()[4], 0.4, 1e-12);
}

TEST(JointLayout, whatIsSetIsRead) {
  const JointLayout layout = JointLayout::of(ers210Joints()).value();
  std::vector<double> positions(layout.names().size(), 9.0);
  const HeadAngles head{0.1, 0.2, 0.3, -0.4};
  const std::array angles{head.tilt, head.pan, head.roll, head.mouth};
  for (std::size_t i = 0; i < angles.size(); ++i) positions[layout.headJoints()[i]] = angles[i];
  for (const Leg leg : kLegs) layout.setLeg(positions, leg, {static_cast<double>(index(leg)), 0.5, -0.5});
  EXPECT_EQ(layout.head(positions), head);
  for (const Leg leg : kLegs) {
    EXPECT_EQ(layout.leg(positions, leg).swing, static_cast<double>(index(leg)));
    EXPECT_EQ(layout.leg(positions, leg).knee, -0.5);
  }
  EXPECT_EQ(std::ranges::count(positions, 9.0), 1) << "only the ear is as it was";
}

TEST(JointLayout, aMissingJointIsNamed) {
  auto joints = ers210Joints();
  std::erase_if(joints, [](const auto& joint) { return joint.name == "neckTilt"; });
  const auto layout = JointLayout::of(joints);
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().text, "the robot's description lacks the joint 'neckTilt'");
}

TEST(JointLayout, anAngleIsApproachedWithinTheLimitsOfAngleAndSpeed) {
  const JointLayout layout = JointLayout::of(ers210Joints()).value();
  EXPECT_NEAR(layout.approached(1, 0, 1, 0.1), 0.4, 1e-12) << "4 rad/s";
  EXPECT_NEAR(layout.approached(1, 0, -1, 0.1), -0.4, 1e-12);
  EXPECT_NEAR(layout.approached(1, 0.9, 1, 0.1), 1, 1e-12) << "no farther than the target";
  EXPECT_NEAR(layout.approached(1, 1.9, 5, 0.1), 2, 1e-12) << "the upper limit";
  EXPECT_EQ(layout.approached(1, 0.5, std::nan(""), 0.1), 0.5) << "no target: it stays";
}

}  // namespace
}  // namespace modules
