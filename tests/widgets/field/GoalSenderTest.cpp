// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GoalSender.h"

#include <gtest/gtest.h>

#include <numbers>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

class GoalSenderTest : public testing::Test {
 protected:
  GoalSenderTest() {
    session.setRequestSink([this](const robotcontrol::Request& request) { requests.push_back(request); });
    sender.begin({{1, 2, 0.5}, true, "dock"});
  }
  void answer(bool accepted, const char* reason = "") {
    robotcontrol::RequestResult result;
    result.set_id(requests.back().id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session.pushResult(result);
    session.tick();
  }
  void tick(int times) {
    for (int i = 0; i < times; ++i) sender.tick();
  }

  std::vector<robotcontrol::Request> requests;
  robotlink::Session session;
  GoalSender sender;
};

TEST_F(GoalSenderTest, draggingChoosesTheHeadingAndComingBackDropsIt) {
  sender.moveTo({1, 4}, 0.5);
  EXPECT_FALSE(sender.aim()->anyHeading);
  EXPECT_NEAR(sender.aim()->pose.heading, std::numbers::pi / 2, 1e-12);
  sender.moveTo({1, 2.1}, 0.5);
  EXPECT_TRUE(sender.aim()->anyHeading);
  EXPECT_DOUBLE_EQ(sender.aim()->pose.heading, 0.5);
}

TEST_F(GoalSenderTest, releasingRequestsTheGoal) {
  sender.end(session, "p3at");
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].robot(), "p3at");
  EXPECT_EQ(requests[0].set_goal().name(), "dock");
  EXPECT_TRUE(requests[0].set_goal().any_heading());
  EXPECT_FALSE(sender.aim().has_value());
  EXPECT_TRUE(sender.sent().has_value());
  tick(90);
  EXPECT_TRUE(sender.sent().has_value());
  tick(1);
  EXPECT_FALSE(sender.sent().has_value()) << "after three seconds it is no longer shown";
}

TEST_F(GoalSenderTest, aRefusalIsShownForFourSecondsInsteadOfTheGoal) {
  sender.end(session, "p3at");
  answer(false, "no way");
  EXPECT_EQ(sender.refusal().toStdString(), "no way");
  tick(1);
  EXPECT_FALSE(sender.sent().has_value());
  tick(119);
  EXPECT_FALSE(sender.refusal().isEmpty());
  tick(1);
  EXPECT_TRUE(sender.refusal().isEmpty());
}

TEST_F(GoalSenderTest, anAbandonedGestureSendsNothing) {
  sender.abandon();
  sender.moveTo({5, 5}, 0.1);
  sender.end(session, "p3at");
  EXPECT_TRUE(requests.empty());
  sender.cancelGoal(session, "p3at");
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_TRUE(requests[0].set_goal().cancelled());
}

}  // namespace
}  // namespace widgets
