// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/PostedWork.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

PostedWork::Work nothing() {
  return [](SessionServer&) {};
}

TEST(PostedWork, whatWouldWaitBeyondTheBoundIsRefused) {
  PostedWork posted({3, 2, 1000});
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(posted.add(nothing()));
  EXPECT_FALSE(posted.add(nothing()));
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(posted.addUrgent(nothing())) << "has room of its own";
  EXPECT_FALSE(posted.addUrgent(nothing()));
  EXPECT_EQ(posted.take().size(), 5U);
  EXPECT_TRUE(posted.add(nothing())) << "there is room again";
}

TEST(PostedWork, whatIsKeptInMemoryIsBounded) {
  PostedWork posted({10, 2, 1000});
  EXPECT_TRUE(posted.add(nothing(), 600));
  EXPECT_FALSE(posted.add(nothing(), 401));
  EXPECT_FALSE(posted.add(nothing(), std::size_t(-1)));
  EXPECT_TRUE(posted.add(nothing(), 400));
  posted.take();
  EXPECT_TRUE(posted.add(nothing(), 1000));
}

TEST(PostedWork, aStateTakesThePlaceOfAnOlderOneOnlyWhereRoomIsScarce) {
  PostedWork posted({3, 2, 1000});
  posted.addState("clients", nothing());
  posted.addState("clients", nothing());
  EXPECT_EQ(posted.take().size(), 2U) << "all steps are seen as long as there is room";
  for (int i = 0; i < 100; ++i) posted.addState("clients", nothing());
  posted.addState("subscribers", nothing());
  EXPECT_LE(posted.take().size(), 4U);
}

TEST(PostedWork, theNewestMessageOfAClientsTopicIsKept) {
  PostedWork posted;
  for (int i = 0; i < 5; ++i) posted.addNewest(1, "drive", nothing());
  posted.addNewest(2, "drive", nothing());
  EXPECT_EQ(posted.take().size(), 2U);
}

}  // namespace
}  // namespace robotlink::websocket
