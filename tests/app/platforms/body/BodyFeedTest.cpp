// SPDX-License-Identifier: GPL-3.0-or-later
// Robots whose bodies are at the far end of a line, which is cut and found again, and whose programs run
// here.
#include "app/platforms/body/BodyFeed.h"

#include <gmock/gmock.h>

#include "app/core/remote/ProgramNotes.h"
#include "app/core/remote/RobotAnnouncer.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/foxglove/security/Tokens.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionServer.h"
#include "tests/TestFolder.h"
#include "tests/app/platforms/body/BodyBench.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::websocket::test::Relay;
using test::BodyDesk;
using test::OfferedBodies;
using test::urlOf;
using testing::HasSubstr;

/// How far the ERS-210 is from where it was seen first.
class Way {
 public:
  explicit Way(BodyDesk& desk) : desk_(desk) {}
  double length() {
    const auto* world = desk_.newest<robotcontrol::OracleWorld>("red1/oracle/world");
    if (world == nullptr) return 0;
    const auto& position = world->robot_in_field();
    if (!begin_) begin_ = std::pair(position.x(), position.y());
    return std::hypot(position.x() - begin_->first, position.y() - begin_->second);
  }

 private:
  BodyDesk& desk_;
  std::optional<std::pair<double, double>> begin_;
};

TEST(BodyFeed, anErs210WalksByAProgramHereAndStandsWhileTheLineIsCut) {
  OfferedBodies hall("scenes/field2002.sdf");
  Relay relay(hall.port(), {});
  BodyDesk desk({.url = urlOf(relay.port())}, hall.port());
  desk.show("oracle/world");
  Way way(desk);
  ASSERT_TRUE(desk.soon([&] { return way.length() > 0.05; }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  EXPECT_TRUE(desk.said("It stops when no command arrives in time for 0.5 s"));

  relay.set(Relay::State::kSilent);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyStands(); }));
  EXPECT_TRUE(desk.soon([&] { return desk.said("is out of reach"); }));
  EXPECT_GE(desk.feed().platform().counts().cuts, 1U);

  relay.set(Relay::State::kOpen);
  EXPECT_TRUE(desk.soon([&] { return desk.said("can be reached again"); }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  Way again(desk);
  EXPECT_TRUE(desk.soon([&] { return again.length() > 0.05; }));
}

TEST(BodyFeed, stopActsAtTheBodyAndIsReleasedThere) {
  OfferedBodies hall("scenes/field2002.sdf");
  BodyDesk desk({.url = urlOf(hall.port())}, hall.port());
  ASSERT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  desk.feed().stopSwitch()->engage("red1", true);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyIsStopped() && desk.bodyStands(); }));
  EXPECT_TRUE(desk.feed().platform().stopEngaged());
  desk.feed().stopSwitch()->engage("red1", false);
  EXPECT_TRUE(desk.soon([&] { return !desk.bodyIsStopped() && desk.bodyMoves(); }));
  EXPECT_TRUE(desk.soon([&] { return !desk.feed().platform().stopEngaged(); }));
}

TEST(BodyFeed, stopThatIsPressedDuringACutActsAfterIt) {
  OfferedBodies hall("scenes/field2002.sdf");
  Relay relay(hall.port(), {});
  BodyDesk desk({.url = urlOf(relay.port())}, hall.port());
  ASSERT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
  relay.set(Relay::State::kCut);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyStands() && desk.said("is out of reach"); }));
  desk.feed().stopSwitch()->engage("red1", true);
  relay.set(Relay::State::kOpen);
  EXPECT_TRUE(desk.soon([&] { return desk.bodyIsStopped(); }));
}

TEST(BodyFeed, aPioneerDrivesByAProgramHere) {
  OfferedBodies hall("scenes/pioneer.sdf");
  BodyDesk desk({.url = urlOf(hall.port()), .program = {.solutions = {{"driving", "obey"}}}}, hall.port());
  const std::string robot = desk.feed().describe().robots.begin()->first;
  desk.show("drive/state");
  const auto state = [&] { return desk.newest<robotcontrol::DriveState>(robot + "/drive/state"); };
  ASSERT_TRUE(desk.soon([&] { return state() != nullptr; }));
  robotcontrol::Request motors;
  motors.mutable_control_drive()->set_motors(true);
  desk.ask(motors);
  const double begin = state()->odometry().x();
  auto asked = std::chrono::steady_clock::now();
  EXPECT_TRUE(desk.soon([&] {
    // As somebody who holds a key.
    if (std::chrono::steady_clock::now() > asked) {
      asked += 100ms;
      robotcontrol::Request drive;
      auto& motion = *drive.mutable_motion()->mutable_motion();
      motion.set_kind(robotcontrol::MotionRequest::WALK);
      motion.mutable_walk()->set_x(0.3);
      desk.ask(drive);
    }
    return state()->odometry().x() > begin + 0.2;
  }));
}

TEST(BodyFeed, imagesComeAsJpegIfThatIsChosen) {
  OfferedBodies hall("scenes/field2002.sdf");
  BodyDesk desk({.url = urlOf(hall.port()), .limits = {.images = LinkLimits::Images::kJpeg}}, hall.port());
  desk.show("camera/image");
  EXPECT_TRUE(
      desk.soon([&] { return desk.newest<google::protobuf::Message>("red1/camera/image") != nullptr; }));
  EXPECT_TRUE(desk.soon([&] { return desk.bodyMoves(); }));
}

TEST(BodyFeed, whatTheConnectionMayCarryIsRememberedAndChanged) {
  const TestFolder folder;
  OfferedBodies hall("scenes/pioneer.sdf");
  LinkLimitsMemory memory(folder / "links.json");
  memory.choose(urlOf(hall.port()), {.bytesPerSecond = 2e6});
  ASSERT_TRUE(memory.save());
  robotlink::Session session;
  logplayer::Recorder recorder({});
  LinkLimitsMemory again(folder / "links.json");
  const auto feed =
      BodyFeed::create({.url = urlOf(hall.port()), .patience = 30s}, session, recorder, nullptr, &again);
  ASSERT_TRUE(feed) << robotlink::describe(feed.error());
  (*feed)->begin();
  EXPECT_THAT((*feed)->link().stateText(), HasSubstr(", at most 2.0 MB/s"));
  again.choose(urlOf(hall.port()), {.bytesPerSecond = 3e6, .images = LinkLimits::Images::kPng});
  (*feed)->step();
  EXPECT_THAT((*feed)->link().stateText(), HasSubstr(", at most 3.0 MB/s, images as PNG"));
}

TEST(BodyFeed, aSecondProgramIsToldWhoseBodyItIs) {
  OfferedBodies hall("scenes/field2002.sdf");
  BodyDesk first({.url = urlOf(hall.port())}, hall.port());
  ASSERT_TRUE(first.soon([&] { return first.bodyMoves(); }));
  BodyDesk second({.url = urlOf(hall.port())}, hall.port());
  EXPECT_TRUE(second.soon([&] {
    first.soon([] { return true; });
    return second.said("obeys the program of") && second.said("another program commands it");
  }));
  EXPECT_GT(first.feed().platform().counts().obeyed, 0U);
  EXPECT_EQ(second.feed().platform().counts().obeyed, 0U);
}

TEST(BodyFeed, aBodyWithStopIsNotSaidToMove) {
  OfferedBodies hall("scenes/field2002.sdf");
  BodyDesk desk({.url = urlOf(hall.port())}, hall.port());
  ASSERT_TRUE(desk.soon([&] { return desk.said("The body moves as this program commands."); }));
  desk.forgetTexts();
  desk.stopAtBody(true);
  EXPECT_TRUE(desk.soon([&] { return desk.said("The body: it is stopped: STOP is engaged there."); }));
  EXPECT_FALSE(desk.said("The body moves"));
  desk.stopAtBody(false);
  EXPECT_TRUE(desk.soon([&] { return desk.said("The body moves as this program commands."); }));
}

/// Why a program for a body is not started; empty if it is.
std::string whyNot(BodyOptions options, robotlink::Duration patience = 30s) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  options.patience = patience;
  const auto feed = BodyFeed::create(std::move(options), session, recorder);
  return feed ? std::string() : feed.error().front().text;
}

TEST(BodyFeed, aBodyAtTheFarEndOfAVeryNarrowLineIsFound) {
  OfferedBodies hall("scenes/field2002.sdf");
  // What is offered there takes several seconds.
  Relay relay(hall.port(), {.delay = 100ms, .bytesPerSecond = 12'500});
  EXPECT_EQ(whyNot({.url = urlOf(relay.port()), .robot = "red1"}), "");
}

TEST(BodyFeed, whatIsMissingIsNamedWhereNothingMoreComes) {
  robotlink::Session session;
  session.setRobots({"red1"});
  robotlink::websocket::SessionServer server(session);
  robotlink::websocket::Listener::Options options;
  options.address.port = 0;
  const auto listener = robotlink::websocket::Listener::open(server.server(), options).value();
  EXPECT_THAT(whyNot({.url = urlOf(listener->address().port)}, 1s),
              HasSubstr("does not say whether red1 is a body"));
}

TEST(BodyFeed, nothingIsSubscribedToThatTheProgramDoesNotNeed) {
  robotlink::Session session;
  session.setRobots({"red1"});
  robotlink::websocket::SessionServer server(session);
  robotlink::websocket::Listener::Options options;
  options.address.port = 0;
  const auto listener = robotlink::websocket::Listener::open(server.server(), options).value();
  const robotlink::Instant now(1s);
  session.push({"transforms", now, std::make_shared<foxglove::FrameTransforms>()});
  session.push({"red1/log", now, std::make_shared<foxglove::Log>()});
  session.push({"red1/program", now, std::make_shared<robotcontrol::ProgramSetup>()});
  BodyLink::Options linking;
  linking.connection.url = *robotlink::websocket::parseServerUrl(urlOf(listener->address().port));
  BodyLink link(linking);
  EXPECT_TRUE(eventually([&] {
    session.tick();
    server.tick();
    link.tick();
    return link.kindOf("red1") == BodyLink::Kind::kWithProgram;
  }));
  EXPECT_TRUE(server.isWanted("red1/program"));
  EXPECT_FALSE(server.isWanted("transforms"));
  EXPECT_FALSE(server.isWanted("red1/log"));
}

TEST(BodyFeed, aBodyIsAnnouncedAsOneBeforeItsFirstFrame) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  const auto feed = SimulationFeed::create(
      test::bodies("scenes/field2002.sdf", std::make_shared<BodyInbox>()), session, recorder);
  ASSERT_TRUE(feed);
  session.setRobots({"red1"});
  publishPrograms(session, (*feed)->describe());
  session.tick();
  EXPECT_THAT(robotsToAnnounce(session),
              testing::ElementsAre(robotlink::dds::AnnouncedRobot{"red1", "ers210", "", true}));
}

TEST(BodyFeed, whereARobotIsMissingTheOthersAreNamed) {
  OfferedBodies hall("scenes/pioneer.sdf");
  EXPECT_THAT(whyNot({.url = urlOf(hall.port()), .robot = "blue7"}),
              testing::MatchesRegex("there is no robot blue7 at ws://.*, only p3at1; choose one of them"));
}

TEST(BodyFeed, whoMayOnlyWatchIsRefusedAtTheStart) {
  const TestFolder folder;
  const auto file = folder / "tokens";
  const auto tokens = robotlink::websocket::loadOrMakeTokens(file).value().tokens;
  OfferedBodies hall("scenes/pioneer.sdf", {.tokenFile = file});
  EXPECT_THAT(whyNot({.url = urlOf(hall.port()), .token = tokens.watch}),
              HasSubstr("with this token you may only watch p3at1"));
  EXPECT_EQ(whyNot({.url = urlOf(hall.port()), .token = tokens.control}), "");
}

TEST(BodyFeed, whereNothingIsTheAddressIsNamed) {
  robotlink::Session session;
  logplayer::Recorder recorder({});
  const auto feed = BodyFeed::create({.url = "ws://127.0.0.1:1", .patience = 300ms}, session, recorder);
  ASSERT_FALSE(feed);
  EXPECT_THAT(feed.error().front().text, HasSubstr("no body was found at ws://127.0.0.1:1"));
}

}  // namespace
}  // namespace app
