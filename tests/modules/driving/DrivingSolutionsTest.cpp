// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of driving and of obstacle avoidance, by their packages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "DrivingParameters.pb.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "tests/modules/driving/RollingPackages.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;
using testing::IsEmpty;

DriveVelocity velocityOf(const robotcontrol::DriveRequest* request) {
  return request == nullptr ? DriveVelocity{-9, -9}
                            : DriveVelocity{request->velocity().x(), request->velocity().rotation()};
}

robotcontrol::DriveRequest desired(const OneSolution& solution, double forward, double rotation) {
  robotcontrol::DriveRequest request;
  robotlink::assign(*request.mutable_timestamp(), solution.clock().now());
  request.mutable_velocity()->set_x(forward);
  request.mutable_velocity()->set_rotation(rotation);
  return request;
}

TEST(Wander, drivesByWhatIsSeenAndStandsWhileNothingIs) {
  const FlatWorld world(roomMap(8, 6));
  RollingRobot robot(world, {.start = {4, 3, 0}, .laser = false});
  OneSolution wander("driving", "wander");
  wander.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(wander.sent(robotlink::kBehaviorDrive)));
  for (int i = 0; i < 10; ++i) {
    robot.drive({});
    wander.pass();
    sense(wander, robot, false);
    wander.execute();
  }
  EXPECT_NE(DriveVelocity{}, velocityOf(wander.sent(robotlink::kBehaviorDrive)));
  EXPECT_THAT(wander.silentKeys(), IsEmpty());
  wander.pass(3);
  wander.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(wander.sent(robotlink::kBehaviorDrive)))
      << "its sensors have fallen silent";
}

TEST(Driving, theStateIsSentAsAPackage) {
  OneSolution wander("driving", "wander"), follow("driving", "follow-path"), halt("driving", "halt");
  for (OneSolution* solution : {&wander, &follow, &halt}) solution->execute();
  EXPECT_EQ(wander.sent(robotlink::kBehaviorState)->state(), "no readings");
  EXPECT_EQ(follow.sent(robotlink::kBehaviorState)->state(), "idle");
  EXPECT_EQ(follow.sent(robotlink::kBehaviorState)->reason(), "nothing to do");
  EXPECT_EQ(halt.sent(robotlink::kBehaviorState)->solution(), "halt");
}

TEST(ObeyOnWheels, doesWhatAPersonAsksFor) {
  OneSolution obey("driving", "obey");
  obey.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(obey.sent(robotlink::kBehaviorDrive)));
  robotcontrol::RemoteMotion remote;
  remote.mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
  remote.mutable_motion()->mutable_walk()->set_x(0.3);
  remote.mutable_motion()->mutable_walk()->set_rotation(-0.2);
  obey.set(robotlink::kRemoteMotion, remote);
  obey.execute();
  EXPECT_EQ((DriveVelocity{0.3, -0.2}), velocityOf(obey.sent(robotlink::kBehaviorDrive)));
  remote.mutable_motion()->set_kind(robotcontrol::MotionRequest::STAND);
  obey.set(robotlink::kRemoteMotion, remote);
  obey.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(obey.sent(robotlink::kBehaviorDrive)));
  EXPECT_THAT(obey.silentKeys(), IsEmpty());
}

TEST(ObeyOnWheels, standsWhenNobodyIsHeardAnyMore) {
  OneSolution obey("driving", "obey");
  robotcontrol::RemoteMotion remote;
  remote.mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
  remote.mutable_motion()->mutable_walk()->set_x(0.3);
  for (int i = 0; i < 40; ++i) {
    if (i % 10 == 0) obey.set(robotlink::kRemoteMotion, remote);
    obey.execute();
    EXPECT_EQ((DriveVelocity{0.3, 0}), velocityOf(obey.sent(robotlink::kBehaviorDrive))) << i;
    obey.pass();
  }
  obey.pass(2);
  obey.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(obey.sent(robotlink::kBehaviorDrive)));
}

TEST(Halt, stands) {
  OneSolution halt("driving", "halt");
  halt.execute();
  EXPECT_EQ(DriveVelocity{}, velocityOf(halt.sent(robotlink::kBehaviorDrive)));
}

/// Follows a path along the room's length.
class FollowPathTest : public testing::Test {
 protected:
  FollowPathTest()
      : world_(roomMap(10, 6)),
        robot_(world_, {.start = {2, 3, 0}, .skid = 0}),
        follow_("driving", "follow-path") {}

  void setPath(bool blocked = false, bool canceled = false) {
    robotcontrol::DrivePath path;
    robotlink::assign(*path.mutable_goal()->mutable_pose_in_field(), Pose2{5, 3, 1.5});
    path.mutable_goal()->set_name("Desk");
    path.mutable_goal()->set_cancelled(canceled);
    path.set_blocked(blocked);
    if (blocked) path.set_reason("there is a wall");
    for (const Vector2& point : {Vector2(2, 3), Vector2(5, 3)})
      if (!blocked) robotlink::assign(*path.add_points_in_field(), point);
    follow_.set(robotlink::kDrivePath, path);
  }
  void run(double seconds, double deviation = 0.05) {
    for (const double end = robot_.time() + seconds; robot_.time() < end - 1e-6;) {
      robotcontrol::RobotPose pose;
      robotlink::assign(*pose.mutable_timestamp(), robot_.now());
      robotlink::assign(*pose.mutable_robot_in_field(), robot_.pose());
      pose.set_position_deviation(deviation);
      follow_.set(robotlink::kRobotPose, pose);
      sense(follow_, robot_, true);
      follow_.execute();
      robot_.drive(desired());
      follow_.pass();
    }
  }
  DriveVelocity desired() const { return velocityOf(follow_.sent(robotlink::kBehaviorDrive)); }

  FlatWorld world_;
  RollingRobot robot_;
  OneSolution follow_;
};

TEST_F(FollowPathTest, standsWhileThereIsNothingToDo) {
  run(0.5);
  EXPECT_EQ(DriveVelocity{}, desired());
  setPath(false, true);
  run(0.5);
  EXPECT_EQ(DriveVelocity{}, desired());
}

TEST_F(FollowPathTest, drivesToTheGoalAndTurnsAsItWants) {
  setPath();
  run(30);
  EXPECT_LT((robot_.pose().translation() - Vector2(5, 3)).norm(), 0.2);
  EXPECT_NEAR(1.5, robot_.pose().heading, 0.15);
  EXPECT_TRUE(follow_.said("drives to “Desk”"));
  EXPECT_TRUE(follow_.said("is at “Desk”"));
}

TEST_F(FollowPathTest, whereThereIsNoWayItStandsAndSaysWhy) {
  setPath(true);
  run(1);
  EXPECT_EQ(DriveVelocity{}, desired());
  EXPECT_TRUE(follow_.said("no way: there is a wall"));
}

TEST_F(FollowPathTest, wandersWhileItDoesNotKnowWhereItIs) {
  setPath();
  run(2, 4);
  EXPECT_NE(DriveVelocity{}, desired());
  EXPECT_TRUE(follow_.said("wanders until it is"));
  run(30);
  EXPECT_LT((robot_.pose().translation() - Vector2(5, 3)).norm(), 0.2);
  EXPECT_THAT(follow_.silentKeys(), IsEmpty());
}

TEST_F(FollowPathTest, mayWaitInsteadOfWandering) {
  follow_.parametersAs<robotcontrol::FollowPathParameters>().set_wait_when_lost(true);
  setPath();
  run(2, 4);
  EXPECT_EQ(DriveVelocity{}, desired());
}

class AvoidanceSolutionTest : public testing::TestWithParam<const char*> {
 protected:
  AvoidanceSolutionTest()
      : world_(roomMap(8, 6)),
        robot_(world_, {.start = {2, 3, 0}, .skid = 0}),
        avoid_("obstacle-avoidance", GetParam()) {}

  void run(double seconds, double forward, double rotation) {
    for (const double end = robot_.time() + seconds; robot_.time() < end - 1e-6;) {
      avoid_.set(robotlink::kBehaviorDrive, desired(avoid_, forward, rotation));
      robotcontrol::DriveState state = driveState(robot_);
      change(state);
      sense(avoid_, robot_, true);
      avoid_.set(robotlink::kDriveState, state);
      avoid_.execute();
      robot_.drive(requested());
      avoid_.pass();
    }
  }
  DriveVelocity requested() const { return velocityOf(avoid_.sent(robotlink::kDriveRequest)); }

  FlatWorld world_;
  RollingRobot robot_;
  OneSolution avoid_;
  std::function<void(robotcontrol::DriveState&)> change = [](auto&) {};
};

TEST_P(AvoidanceSolutionTest, drivesAsWishedButNotIntoAWall) {
  run(3, 0.4, 0);
  EXPECT_GT(requested().forward, 0.3);
  run(40, 0.4, 0);
  EXPECT_GT(robot_.nearest(), 0.04);
  EXPECT_THAT(avoid_.silentKeys(), IsEmpty());
}

TEST_P(AvoidanceSolutionTest, blindItStandsAndSaysSoOnce) {
  for (int i = 0; i < 20; ++i) {
    avoid_.set(robotlink::kBehaviorDrive, desired(avoid_, 0.4, 0));
    avoid_.set(robotlink::kDriveState, driveState(robot_));
    avoid_.execute();
    avoid_.pass();
  }
  EXPECT_EQ(DriveVelocity{}, requested());
  EXPECT_TRUE(avoid_.said("stands: "));
  EXPECT_LE(avoid_.texts().begin()->second, 1);
}

TEST_P(AvoidanceSolutionTest, aWishOfLongAgoIsNone) {
  run(2, 0.4, 0);
  for (int i = 0; i < 40; ++i) {
    robot_.drive(requested());
    avoid_.pass();
    sense(avoid_, robot_, true);
    avoid_.execute();
  }
  EXPECT_EQ(DriveVelocity{}, requested());
}

TEST_P(AvoidanceSolutionTest, anEmergencyStopStops) {
  run(2, 0.4, 0);
  change = [](auto& state) { state.set_emergency_stop(true); };
  run(2, 0.4, 0);
  EXPECT_EQ(DriveVelocity{}, requested());
}

TEST_P(AvoidanceSolutionTest, fromWhatABumperTouchesItGetsAway) {
  // Something that neither sonars nor laser see.
  change = [](auto& state) {
    for (int i = 0; i < 5; ++i) state.add_front_bumpers(i == 2);
  };
  run(0.3, 0.4, 0);
  change = [](auto& state) {
    for (int i = 0; i < 5; ++i) state.add_front_bumpers(false);
  };
  const double before = robot_.pose().x;
  run(2, 0.4, 0);
  EXPECT_LT(robot_.pose().x, before + 0.02);
}

INSTANTIATE_TEST_SUITE_P(Seeing, AvoidanceSolutionTest, testing::Values("vector-field", "dynamic-window"),
                         [](const auto& name) {
                           return std::string(name.param) == "vector-field" ? "vectorField" : "dynamicWindow";
                         });

TEST(NoAvoidance, passesWishesOnWithinWhatTheMotorsCan) {
  OneSolution none("obstacle-avoidance", "none");
  none.set(robotlink::kBehaviorDrive, desired(none, 9, 0));
  double last = 0;
  for (int i = 0; i < 60; ++i) {
    none.set(robotlink::kBehaviorDrive, desired(none, 9, 0));
    none.execute();
    none.pass();
    const double now = velocityOf(none.sent(robotlink::kDriveRequest)).forward;
    EXPECT_LE(now - last, 0.3 * 0.2 + 1e-9);
    last = now;
  }
  EXPECT_EQ(0.75, last);
  EXPECT_THAT(none.silentKeys(), IsEmpty());
}

}  // namespace
}  // namespace modules
