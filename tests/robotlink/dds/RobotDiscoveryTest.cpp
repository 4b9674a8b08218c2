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
      {there}, {.robots = {{"red1", "ers210", "compact"}, {.name = "red2", .kind = "ers210", .isBody = true}},
                .address = "",
                .port = 8765,
                .isEncrypted = true,
                .fingerprint = "ab:cd"});
  auto first = dds::RobotAnnouncement::open({there}, {.robots = {{"p3at1"}}, .address = "", .port = 8766});
  ASSERT_TRUE(first && second);
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 2; }));
  const auto robots = (*discovery)->robots();
  EXPECT_EQ("ws://127.0.0.1:8766", robots[0].url());
  EXPECT_EQ("p3at1", robots[0].names());
  EXPECT_EQ("wss://127.0.0.1:8765", robots[1].url());
  EXPECT_THAT(robots[1].robots, ElementsAre(dds::AnnouncedRobot{"red1", "ers210", "compact", false},
                                            dds::AnnouncedRobot{"red2", "ers210", "", true}));
  EXPECT_EQ("ab:cd", robots[1].fingerprint);
  first->reset();
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 1; }));
  EXPECT_TRUE((*discovery)->robots().front().isEncrypted);
  // One that joins later hears it, too.
  const auto late = dds::RobotDiscovery::open({here});
  EXPECT_TRUE(eventually([&] { return (*late)->robots().size() == 1; }));
}

TEST(RobotDiscoveryTest, whatIsAnnouncedMayChange) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  const auto discovery = dds::RobotDiscovery::open({here});
  const auto announcement =
      dds::RobotAnnouncement::open({there}, {.robots = {{"red1"}}, .address = "", .port = 1});
  ASSERT_TRUE(discovery && announcement);
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 1; }));
  (*announcement)->update({{"red1", "ers210", "own"}, {"red2", "ers210", "own"}});
  EXPECT_TRUE(eventually([&] {
    const auto robots = (*discovery)->robots();
    return robots.size() == 1 && robots.front().names() == "red1, red2";
  }));
}

TEST(RobotDiscoveryTest, namesThatOthersAnnounceCanBePrinted) {
  const auto here = openTestNode();
  const auto there = openTestNode();
  ASSERT_TRUE(here && there);
  const auto discovery = dds::RobotDiscovery::open({here});
  const auto announced = dds::RobotAnnouncement::open(
      {there},
      {.robots = {{"red\x1b[2J"}, {"\xff", "a\x01"}, {std::string(1000, 'x')}}, .address = "", .port = 8765});
  ASSERT_TRUE(discovery && announced);
  ASSERT_TRUE(eventually([&] { return (*discovery)->robots().size() == 1; }));
  EXPECT_THAT((*discovery)->robots().front().robots,
              ElementsAre(dds::AnnouncedRobot{"red?[2J"}, dds::AnnouncedRobot{"?", "a?"},
                          dds::AnnouncedRobot{std::string(100, 'x')}));
}

TEST(RobotDiscoveryTest, nothingIsAnnouncedOnTheLoopbackInterface) {
  EXPECT_THAT(dds::announcementNodes("127.0.0.1"), IsEmpty());
  EXPECT_THAT(dds::localAddresses(), Contains("127.0.0.1"));
  EXPECT_EQ("127.0.0.1", dds::addressOf("127.0.0.1"));
}

}  // namespace
}  // namespace robotlink::test
