// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/ModelDrag.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

class ModelDragTest : public testing::Test {
 protected:
  ModelDragTest() {
    session.setRequestSink([this](const robotcontrol::Request& request) { requests.push_back(request); });
    drag.begin("ball", {1, 2, 0.5}, {1.1, 2});
  }
  void answer(std::size_t index, bool accepted, const char* reason = "") {
    robotcontrol::RequestResult result;
    result.set_id(requests.at(index).id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session.pushResult(result);
    session.tick();
  }

  std::vector<robotcontrol::Request> requests;
  robotlink::Session session;
  ModelDrag drag;
};

TEST_F(ModelDragTest, theModelKeepsItsPlaceUnderTheCursor) {
  drag.moveTo({3.1, 5});
  EXPECT_DOUBLE_EQ(drag.wanted().x, 3);
  EXPECT_DOUBLE_EQ(drag.wanted().y, 5);
  drag.turn(0.25);
  EXPECT_DOUBLE_EQ(drag.wanted().heading, 0.75);
}

TEST_F(ModelDragTest, onlyTheNewestPoseOfATickIsRequested) {
  drag.tick(session);
  EXPECT_TRUE(requests.empty()) << "it was not moved yet";
  drag.moveTo({2, 2});
  drag.moveTo({3, 2});
  drag.tick(session);
  drag.tick(session);
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].place_model().model(), "ball");
  drag.moveTo({4, 2});
  drag.end(session);
  EXPECT_EQ(requests.size(), 2U);
  EXPECT_FALSE(drag.active());
  drag.moveTo({9, 9});
  drag.tick(session);
  EXPECT_EQ(requests.size(), 2U) << "the button is released";
}

TEST_F(ModelDragTest, aRefusalOfAnOlderPoseDoesNotCount) {
  drag.moveTo({2, 2});
  drag.tick(session);
  drag.moveTo({3, 2});
  drag.tick(session);
  answer(0, false, "in a wall");
  EXPECT_TRUE(drag.refusal().isEmpty());
  answer(1, false, "in a robot");
  EXPECT_EQ(drag.refusal().toStdString(), "in a robot");
  drag.end(session);
  for (int tick = 0; tick < 59; ++tick) drag.tick(session);
  EXPECT_FALSE(drag.refusal().isEmpty());
  for (int tick = 0; tick < 4; ++tick) drag.tick(session);
  EXPECT_TRUE(drag.refusal().isEmpty()) << "two seconds later it goes";
}

}  // namespace
}  // namespace widgets
