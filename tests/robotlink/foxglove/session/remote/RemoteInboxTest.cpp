// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/remote/RemoteInbox.h"

#include <gtest/gtest.h>

namespace robotlink::websocket {
namespace {

TEST(RemoteInbox, textsOfTheServerAreBoundedAndTheOldestGo) {
  RemoteInbox inbox({3, 1U << 20U}, {});
  std::string done;
  inbox.push([&] { done += "connected;"; });
  for (int i = 0; i < 5; ++i) inbox.pushSparable([&done, i] { done += std::to_string(i) + ";"; }, 10);
  EXPECT_EQ(inbox.dropped(), 2U);
  for (const auto& arrival : inbox.take()) arrival.work();
  EXPECT_EQ(done, "connected;2;3;4;") << "what is to be done is kept";
  EXPECT_TRUE(inbox.take().empty());
}

TEST(RemoteInbox, longTextsAreBoundedByTheirBytes) {
  RemoteInbox inbox({1000, 10'000}, {});
  for (int i = 0; i < 100; ++i) inbox.pushSparable([] {}, 4000);
  EXPECT_EQ(inbox.take().size(), 2U);
  EXPECT_EQ(inbox.dropped(), 98U);
}

TEST(RemoteInbox, changesThatNobodyTakesAreRefusedAtABound) {
  RemoteInbox inbox({100, 10'000, 3}, {});
  int done = 0;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(inbox.pushChange([&done] { ++done; }));
  EXPECT_FALSE(inbox.pushChange([&done] { ++done; }));
  inbox.push([&done] { done += 10; });
  for (const auto& arrival : inbox.take()) arrival.work();
  EXPECT_EQ(done, 13) << "what was taken is done, and a lost connection is always noted";
  EXPECT_TRUE(inbox.pushChange([] {})) << "after they were taken there is room again";
}

}  // namespace
}  // namespace robotlink::websocket
