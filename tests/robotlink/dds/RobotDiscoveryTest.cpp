// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/dds/RobotDiscovery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robotlink/dds/LocalAddresses.h"
#include "tests/Eventually.h"
#include "tests/robotlink/dds/TestNodes.h"

namespace robotlink::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(RobotDiscoveryTest, robotsAreListedWhileTheyAreAnnounced) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  const auto discovery = dds::RobotDiscovery::open({here});
  ASSERT_TRUE(discovery);
  EXPECT_THAT((*discovery)->robots(), IsEmpty());
  auto second = dds::RobotAnnouncement::open(
      {there},
      {.names = {"red1", "red2"}, .address = "", .port = 8765, .isEncrypted = true, .fingerprint = "ab:cd"});
  auto first = dds::RobotAnnouncement::open({there}, {.names = {"p3at1"}, .address = "", .port = 8766});
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 2; }));
  const auto robots = (*discovery)->robots();
  EXPECT_EQ("ws://127.0.0.1:8766", robots[0].url());
  EXPECT_THAT(robots[0].names, ElementsAre("p3at1"));
  EXPECT_EQ("wss://127.0.0.1:8765", robots[1].url());
  EXPECT_THAT(robots[1].names, ElementsAre("red1", "red2"));
  EXPECT_EQ("ab:cd", robots[1].fingerprint);
  first->reset();
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 1; }));
  EXPECT_TRUE((*discovery)->robots().front().isEncrypted);
  // Who comes later hears it, too.
  const auto late = dds::RobotDiscovery::open({here});
  EXPECT_TRUE(eventually([&] { return (*late)->robots().size() == 1; }));
}

TEST(RobotDiscoveryTest, nothingIsAnnouncedOnTheLoopbackInterface) {
  EXPECT_THAT(dds::announcementNodes("127.0.0.1"), IsEmpty());
  EXPECT_THAT(dds::localAddresses(), Contains("127.0.0.1"));
  EXPECT_EQ("127.0.0.1", dds::addressOf("127.0.0.1"));
}

}  // namespace
}  // namespace robotlink::test
