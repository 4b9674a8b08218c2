// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/RobotBeliefs.h"

#include <gtest/gtest.h>

#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/session/Session.h"
#include "tests/widgets/streams/StoredMessages.h"
#include "widgets/drawings/DrawingPose.h"
#include "widgets/world/SceneState.h"

namespace widgets::test {
namespace {

/// The robots red1 and blue1, of which the first is selected.
class RobotBeliefsTest : public testing::Test {
 protected:
  RobotBeliefsTest() { session.setRobots({"red1", "blue1"}); }
  template <typename T>
  void push(const std::string& path, const T& message) {
    session.push({path, atSeconds(1), std::make_shared<const T>(message)});
    session.tick();
  }
  void pushTruth(double x, double y) {
    foxglove::FrameTransforms transforms;
    auto& transform = *transforms.add_transforms();
    transform.set_parent_frame_id("field");
    transform.set_child_frame_id("red1");
    transform.mutable_translation()->set_x(x);
    transform.mutable_translation()->set_y(y);
    push("transforms", transforms);
  }
  void pushEstimate(double x, double heading, const char* stream = "red1/models/pose") {
    robotcontrol::RobotPose pose;
    pose.mutable_robot_in_field()->set_x(x);
    pose.mutable_robot_in_field()->set_heading(heading);
    pose.set_position_deviation(0.25);
    push(stream, pose);
  }
  void pushBall(double x, bool isKnown = true) {
    robotcontrol::BallModel ball;
    ball.set_known(isKnown);
    ball.mutable_position_in_robot()->set_x(x);
    ball.set_standard_deviation(0.5);
    push("red1/models/ball", ball);
  }
  std::vector<RobotBelief> beliefs(double shown = 10) {
    SceneState scene;
    scene.update(session.store(), atSeconds(shown));
    return robotBeliefs(session, scene, nullptr, atSeconds(shown));
  }

  robotlink::Session session;
};

TEST_F(RobotBeliefsTest, aRobotThatSaysNothingIsNowhere) {
  const auto all = beliefs();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].robot, "red1");
  EXPECT_TRUE(all[0].selected);
  EXPECT_FALSE(all[1].selected);
  EXPECT_FALSE(all[0].pose() || all[0].ball || all[0].drawingPose());
}

TEST_F(RobotBeliefsTest, theTruthComesBeforeTheEstimate) {
  pushEstimate(3, 0.5);
  EXPECT_EQ(beliefs()[0].pose(), (robotlink::Pose2{3, 0, 0.5}));
  EXPECT_EQ(beliefs()[0].positionDeviation, 0.25);
  pushTruth(1, 2);
  EXPECT_EQ(beliefs()[0].pose(), (robotlink::Pose2{1, 2, 0}));
  EXPECT_EQ(beliefs()[0].estimate, (robotlink::Pose2{3, 0, 0.5})) << "it stays what the robot believes";
  EXPECT_FALSE(beliefs()[1].pose()) << "the other robot is another one";
}

TEST_F(RobotBeliefsTest, theBallIsSeenFromWhereTheRobotBelievesToBe) {
  pushBall(2);
  EXPECT_FALSE(beliefs()[0].ball) << "from nowhere";
  pushTruth(1, 0);
  EXPECT_TRUE(beliefs()[0].ball->isApprox(robotlink::Vector2(3, 0)));
  pushEstimate(5, robotlink::kPi / 2);
  EXPECT_TRUE(beliefs()[0].ball->isApprox(robotlink::Vector2(5, 2)));
  EXPECT_EQ(beliefs()[0].ballDeviation, 0.5);
  pushBall(2, false);
  EXPECT_FALSE(beliefs()[0].ball);
}

TEST_F(RobotBeliefsTest, messagesAfterTheShownInstantDoNotCount) {
  pushEstimate(3, 0);
  EXPECT_FALSE(beliefs(0.5)[0].estimate);
}

TEST_F(RobotBeliefsTest, drawingsAreWhereTheUserPlacesThem) {
  pushTruth(1, 0);
  pushEstimate(3, 0);
  pushEstimate(7, 0, "red1/models/other");
  auto all = beliefs();
  const auto placed = [&](const char* choice) {
    all = beliefs();
    placeDrawings(all, session.store(), choice, atSeconds(10));
    return all[0].drawingPose();
  };
  EXPECT_EQ(placed(kUsualPose)->x, 1);
  EXPECT_EQ(placed(kTruePose)->x, 1);
  EXPECT_EQ(placed("models/pose")->x, 3);
  EXPECT_EQ(placed("models/other")->x, 7);
  EXPECT_FALSE(placed("models/none")) << "rather nowhere than elsewhere";
  EXPECT_EQ(all[0].pose()->x, 1) << "the robot itself stays";
  placeDrawings(all, session.store(), kTruePose, atSeconds(10));
  EXPECT_FALSE(all[1].drawingPose()) << "its true pose is not known";
}

TEST(TeamColor, theTeamWithTheLongestNameGivesItsColor) {
  robotlink::FieldDescription field;
  field.palette = {{"red", {200, 0, 0}}, {"redder", {250, 0, 0}}, {"blue", {0, 0, 200}}};
  EXPECT_EQ(teamColor("red1", {}, &field), QColor(200, 0, 0));
  EXPECT_EQ(teamColor("redder1", {}, &field), QColor(250, 0, 0));
  EXPECT_EQ(teamColor("blue4", {}, &field), QColor(0, 0, 200));
}

TEST(TeamColor, theTeamThatTheSceneNamesCountsNotTheName) {
  robotlink::FieldDescription field;
  field.palette = {{"red", {200, 0, 0}}, {"blue", {0, 0, 200}}};
  EXPECT_EQ(teamColor("blueberry", "red", &field), QColor(200, 0, 0));
  EXPECT_EQ(teamColor("red1", "", &field), teamColor("p3at1", "", &field)) << "it plays in no team";
}

TEST(TeamColor, robotsWithoutATeamHaveColorsByTheirNumber) {
  const robotlink::FieldDescription field;
  const QColor gray(128, 128, 128);
  EXPECT_NE(teamColor("p3at1", {}, &field), teamColor("p3at2", {}, &field));
  EXPECT_EQ(teamColor("p3at1", {}, nullptr), teamColor("burger1", {}, nullptr));
  EXPECT_EQ(teamColor("p3at1", {}, nullptr), teamColor("p3at9", {}, nullptr)) << "there are eight";
  for (const char* robot : {"", "rover", "rover0", "rover99999999999999999999"})
    EXPECT_EQ(teamColor(robot, {}, nullptr), gray) << robot;
  EXPECT_NE(teamColor("7", {}, nullptr), gray) << "a number is a name, too";
}

}  // namespace
}  // namespace widgets::test
