// SPDX-License-Identifier: GPL-3.0-or-later
// Robots that announce themselves are found, by a source that a test makes up and over DDS.
#include "app/core/remote/RobotSearch.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <atomic>
#include <stdexcept>

#include "app/core/remote/RobotAnnouncer.h"
#include "app/core/remote/SessionOffer.h"
#include "robotcontrol/Logging.pb.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"
#include "tests/app/MadeUpRobots.h"
#include "tests/robotlink/dds/TestNodes.h"

namespace app {
namespace {

using robotlink::dds::AnnouncedRobot;
using robotlink::dds::AnnouncedRobots;
using robotlink::test::openTestNode;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

AnnouncedRobots hall(const std::string& name, std::uint16_t port = 8765) {
  return {.robots = {{name, "ers210", "compact"}}, .address = "10.0.0.7", .port = port};
}

std::string namesIn(const RobotSearch::State& state) {
  std::string names;
  for (const auto& found : state.found) names += found.robots.names() + ";";
  return names;
}

TEST(RobotSearch, robotsComeAndGoWhileSomebodyWantsToSeeThem) {
  test::MadeUpRobots made;
  const auto clock = std::make_shared<robotlink::ManualClock>();
  RobotSearch search(made.source(), clock);
  EXPECT_FALSE(search.state().isListening);
  made.set({hall("red2", 2), hall("red1", 1)});
  search.setWanted(true);
  ASSERT_TRUE(eventually([&] { return namesIn(search.state()) == "red1;red2;"; }));
  clock->advance(std::chrono::seconds(7));
  EXPECT_EQ(search.state().found.front().age, std::chrono::seconds(7));
  made.set({hall("red2", 2), hall("blue1", 3)});
  ASSERT_TRUE(eventually([&] { return namesIn(search.state()) == "blue1;red2;"; }));
  // A robot that stays keeps its age.
  EXPECT_EQ(search.state().found.back().age, std::chrono::seconds(7));
  EXPECT_EQ(search.state().found.front().age, std::chrono::seconds(0));
  search.setWanted(false);
  EXPECT_EQ(namesIn(search.state()), "");
  EXPECT_TRUE(eventually([&] { return made.listeners() == 0; }));
}

TEST(RobotSearch, whyNothingCanBeHeardIsSaid) {
  test::MadeUpRobots made;
  made.setProblem("no network");
  RobotSearch search(made.source());
  search.setWanted(true);
  EXPECT_TRUE(eventually([&] { return search.state().problem == "no network"; }));
  RobotSearch alone(RobotSearch::onNetworks(
      [](const std::string&) { return std::vector<std::shared_ptr<robotlink::dds::Node>>(); }));
  alone.setWanted(true);
  EXPECT_TRUE(eventually([&] { return !alone.state().problem.empty(); }));
  EXPECT_THAT(alone.state().problem, HasSubstr("Enter the URL"));
}

TEST(RobotSearch, aSourceThatThrowsIsSaidAndTriedAgain) {
  test::MadeUpRobots made;
  made.set({hall("red1")});
  std::atomic<int> tries{0};
  RobotSearch search([&tries, open = made.source()]() -> std::unique_ptr<RobotSearch::Source> {
    if (++tries < 3) throw std::runtime_error("no sockets are left");
    return open();
  });
  search.setWanted(true);
  EXPECT_TRUE(eventually([&] { return search.state().problem.find("no sockets") != std::string::npos; }));
  EXPECT_TRUE(eventually([&] { return namesIn(search.state()) == "red1;"; }));
  EXPECT_EQ(search.state().problem, "");
}

/// Nodes of a domain of this test's own, on the loopback interface, for any network.
std::vector<std::shared_ptr<robotlink::dds::Node>> testNodes(const std::string&) {
  return {openTestNode()};
}

/// A session with one robot, of which it is said what it is.
class AnnouncedSession {
 public:
  AnnouncedSession() {
    session.setRobots({"red1"});
    describe("own.yaml");
  }
  void describe(const std::string& layout, bool isBody = false) {
    auto setup = std::make_shared<robotcontrol::ProgramSetup>();
    setup->mutable_description()->set_name("ers210.yaml");
    if (!layout.empty()) setup->mutable_layout()->set_name(layout);
    setup->set_is_body(isBody);
    session.push({"red1/program", robotlink::Instant(++time_), std::move(setup)});
    session.tick();
  }
  robotlink::Session session;

 private:
  robotlink::Duration time_{0};
};

TEST(RobotSearch, robotsAreFoundOverDds) {
  AnnouncedSession robot;
  EXPECT_THAT(robotsToAnnounce(robot.session), ElementsAre(AnnouncedRobot{"red1", "ers210", "own", false}));
  RobotSearch search(RobotSearch::onNetworks(testNodes));
  search.setWanted(true);
  auto announcer = std::make_unique<RobotAnnouncer>(robotlink::websocket::ListenAddress{"10.0.0.7", 8765},
                                                    ListenAccess{}, testNodes);
  announcer->update(robotsToAnnounce(robot.session));
  ASSERT_TRUE(eventually([&] { return search.state().found.size() == 1; }));
  EXPECT_EQ(search.state().found.front().robots.robots.front().layout, "own");
  robot.describe("compact.yaml");
  announcer->update(robotsToAnnounce(robot.session));
  EXPECT_TRUE(eventually([&] {
    const auto state = search.state();
    return state.found.size() == 1 && state.found.front().robots.robots.front().layout == "compact";
  }));
  announcer.reset();
  EXPECT_TRUE(eventually([&] { return search.state().found.empty(); }));
}

TEST(RobotSearch, aBodyIsAnnouncedAsOne) {
  AnnouncedSession robot;
  robot.describe("", true);
  EXPECT_THAT(robotsToAnnounce(robot.session), ElementsAre(AnnouncedRobot{"red1", "ers210", "", true}));
}

TEST(RobotSearch, anOfferedSessionIsAnnouncedAsLongAsItIsOffered) {
  const TestFolder state;
  ::setenv("XDG_STATE_HOME", state.path().c_str(), 1);
  AnnouncedSession robot;
  SessionOffer offer(robot.session);
  offer.announceOn(testNodes);
  RobotSearch search(RobotSearch::onNetworks(testNodes));
  search.setWanted(true);
  ASSERT_TRUE(offer.begin("0.0.0.0:0"));
  ASSERT_TRUE(eventually([&] { return search.state().found.size() == 1; }));
  const AnnouncedRobots robots = search.state().found.front().robots;
  EXPECT_EQ(robots.names(), "red1");
  EXPECT_TRUE(robots.isEncrypted);
  EXPECT_THAT(robots.fingerprint, HasSubstr("SHA256:"));
  EXPECT_TRUE(offer.isOfferedAt(robots.address, robots.port));
  offer.end();
  EXPECT_TRUE(eventually([&] { return search.state().found.empty(); }));
  EXPECT_FALSE(offer.isOfferedAt(robots.address, robots.port));
  ::unsetenv("XDG_STATE_HOME");
}

TEST(RobotSearch, whatIsOfferedOnThisMachineOnlyIsNotAnnounced) {
  AnnouncedSession robot;
  SessionOffer offer(robot.session);
  bool isAsked = false;
  offer.announceOn([&](const std::string&) {
    isAsked = true;
    return std::vector<std::shared_ptr<robotlink::dds::Node>>();
  });
  ASSERT_TRUE(offer.begin("127.0.0.1:0"));
  offer.tick();
  offer.end();
  EXPECT_FALSE(isAsked);
}

}  // namespace
}  // namespace app
