// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/body/BodyEvents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "modules/perception/BodyTiltFilter.h"

namespace modules {
namespace {

using robotlink::Vector3;

constexpr std::array<bool, 4> kNone{}, kAll{true, true, true, true};

/// Standing, or walking in a trot of two steps a second, with knees that bear a load, and legs that lag.
BodyFrame frameAt(int i, bool walking, double torque, double lag) {
  BodyFrame frame;
  frame.walking = walking;
  const double phase = walking ? 2 * robotlink::kPi * i * 0.008 / 0.5 : 0;
  for (const Leg leg : kLegs) {
    const double shifted = phase + (leg == Leg::kFrontLeft || leg == Leg::kHindRight ? 0 : robotlink::kPi);
    const double swing = -0.6 + 0.3 * std::sin(shifted);
    frame.requested[index(leg)] = {swing, 0.1, 1.6};
    frame.measured[index(leg)] = {swing - lag * std::cos(shifted), 0.1, 1.6};
    frame.kneeTorques[index(leg)] = torque;
    if (walking) frame.contacts[index(leg)] = std::cos(shifted) < 0;
  }
  return frame;
}

int collisions(const BodyEvents& events) {
  return static_cast<int>(std::ranges::count(events.collided, true));
}

TEST(ContactEvents, aRobotWithoutContactsWasPickedUp) {
  ContactEvents events({});
  BodyFrame frame;
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(events.update(frame).pickedUp);
  frame.contacts = kNone;
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(events.update(frame).pickedUp);
  for (int i = 0; i < 20; ++i) events.update(frame);
  EXPECT_TRUE(events.update(frame).pickedUp);
  // A single contact, such as of a hand, does not put it down.
  frame.contacts = {true, false, false, false};
  EXPECT_TRUE(events.update(frame).pickedUp);
  frame.contacts = kAll;
  for (int i = 0; i < 20; ++i) events.update(frame);
  EXPECT_FALSE(events.update(frame).pickedUp);
}

TEST(ContactEvents, itHasNotBeenPickedUpWhileItWalksOrKicks) {
  ContactEvents events({});
  for (int i = 0; i < 500; ++i) {
    const BodyEvents& now = events.update(frameAt(i, true, 0.02, 0.05));
    EXPECT_FALSE(now.pickedUp);
    EXPECT_EQ(collisions(now), 0);
  }
  BodyFrame kick;
  kick.shaken = true;
  kick.contacts = kNone;
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(events.update(kick).pickedUp);
}

TEST(ContactEvents, aLegThatDoesNotStepHasCollided) {
  ContactEvents events({});
  for (int i = 0; i < 300; ++i) {
    BodyFrame frame = frameAt(i, true, 0.02, 0.05);
    frame.contacts[2] = true;
    events.update(frame);
  }
  BodyFrame frame = frameAt(300, true, 0.02, 0.05);
  frame.contacts[2] = true;
  EXPECT_EQ(events.update(frame).collided, (std::array{false, false, true, false}));
  frame.walking = false;
  EXPECT_EQ(collisions(events.update(frame)), 0);
}

TEST(BodyEvents, gravityShowsOnWhichSideTheRobotLies) {
  for (const auto& [direction, side] : {std::pair{Vector3(0, 9.81, 0), FallDetector::Side::kRight},
                                        std::pair{Vector3(0, -9.81, 0), FallDetector::Side::kLeft},
                                        std::pair{Vector3(-9.81, 0, 0), FallDetector::Side::kFront},
                                        std::pair{Vector3(0, 0, -9.81), FallDetector::Side::kBack}}) {
    ContactEvents contacts({});
    JointErrorEvents errors({});
    BodyFrame frame;
    frame.acceleration = direction;
    frame.contacts = kNone;
    for (int i = 0; i < 200; ++i) {
      contacts.update(frame);
      errors.update(frame);
    }
    EXPECT_TRUE(contacts.update(frame).fallen);
    EXPECT_EQ(contacts.update(frame).side, side);
    EXPECT_FALSE(contacts.update(frame).pickedUp);
    EXPECT_EQ(errors.update(frame).side, side);
    EXPECT_FALSE(errors.update(frame).pickedUp);
  }
}

TEST(JointErrorEvents, aBodyThatNoKneeBearsWasPickedUp) {
  JointErrorEvents events({});
  for (int i = 0; i < 300; ++i) EXPECT_FALSE(events.update(frameAt(i, true, -0.1, 0.05)).pickedUp) << i;
  EXPECT_NEAR(events.load(), 0.1, 0.01);
  for (int i = 0; i < 300; ++i) events.update(frameAt(i, true, 0.03, 0.05));
  EXPECT_TRUE(events.update(frameAt(0, true, 0.03, 0.05)).pickedUp);
  for (int i = 0; i < 300; ++i) events.update(frameAt(i, true, -0.1, 0.05));
  EXPECT_FALSE(events.update(frameAt(0, true, -0.1, 0.05)).pickedUp);
}

TEST(JointErrorEvents, whoMeasuresNoTorquesIsNotPickedUp) {
  JointErrorEvents events({});
  for (int i = 0; i < 300; ++i) EXPECT_FALSE(events.update(frameAt(i, true, 0, 0.05)).pickedUp) << i;
}

TEST(JointErrorEvents, aLegThatLagsMoreThanUsualHasCollided) {
  JointErrorEvents events({});
  for (int i = 0; i < 800; ++i) EXPECT_EQ(collisions(events.update(frameAt(i, true, 0.1, 0.05))), 0) << i;
  bool collided = false;
  for (int i = 800; i < 850; ++i) {
    BodyFrame frame = frameAt(i, true, 0.1, 0.05);
    frame.measured[1].swing -= 0.5;
    collided = collided || events.update(frame).collided[1];
    EXPECT_FALSE(events.update(frameAt(i, true, 0.1, 0.05)).collided[0]);
  }
  EXPECT_TRUE(collided);
}

TEST(BodyTiltFilter, followsTheLegsAtOnceAndGravityInTheLongRun) {
  BodyTiltFilter filter;
  const BodyTiltFilter::Options options;
  const Vector3 level(0, 0, 9.81);
  filter.update({0.11, 0.1, 0}, level, 0.04, options);
  // A step of the legs is there at once.
  EXPECT_NEAR(filter.update({0.12, 0.15, 0.02}, level, 0.04, options).pitch, 0.15, 0.02);
  EXPECT_NEAR(filter.update({0.12, 0.15, 0.02}, level, 0.04, options).height, 0.12, 1e-12);
  BodyTilt tilt;
  for (int i = 0; i < 1200; ++i) tilt = filter.update({0.12, 0.15, 0.02}, level, 0.04, options);
  EXPECT_NEAR(tilt.pitch, 0, 0.005);
  EXPECT_NEAR(tilt.roll, 0, 0.005);
}

TEST(BodyTiltFilter, ignoresJolts) {
  BodyTiltFilter filter;
  BodyTilt tilt;
  for (int i = 0; i < 100; ++i)
    tilt = filter.update({0.11, 0.05, 0}, i % 2 == 0 ? Vector3(20, 0, 10) : Vector3(0, 0, 1), 0.04, {});
  EXPECT_NEAR(tilt.pitch, 0.05, 1e-9);
}

TEST(BodyTiltFilter, knowsTheSignsOfTheTilt) {
  const BodyTilt nose = BodyTiltFilter::tiltOf({-1, 0, 9.7}), left = BodyTiltFilter::tiltOf({0, 1, 9.7});
  EXPECT_GT(nose.pitch, 0.09);
  EXPECT_NEAR(nose.roll, 0, 1e-12);
  EXPECT_GT(left.roll, 0.09);
  // The same as of a body that is turned by these angles.
  const BodyTilt tilted{0.1, 0.2, -0.1};
  const Vector3 up = tilted.bodyInRobot().linear().transpose() * Vector3(0, 0, 9.81);
  EXPECT_NEAR(BodyTiltFilter::tiltOf(up).pitch, 0.2, 1e-9);
  EXPECT_NEAR(BodyTiltFilter::tiltOf(up).roll, -0.1, 1e-9);
}

}  // namespace
}  // namespace modules
