// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedPlatform.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Image.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/app/served/ServedTest.h"

namespace app {
namespace {

using robotlink::websocket::Listener;
using robotlink::websocket::MessageData;
using robotlink::websocket::Server;
using robotlink::websocket::ServiceCallRequest;
using robotlink::websocket::ServiceCallResponse;
using robotlink::websocket::Subscribe;
using testing::HasSubstr;

class ServedPlatformTest : public test::ServedTest {
 protected:
  ServedPlatformTest() : ServedTest(SimulationFeed::opening(defaultSimulation())) {
    while (!channels_.contains("red1/camera/image") || !services_.contains("red1/stop")) hear();
  }
};

class PausedPlatformTest : public test::ServedTest {
 protected:
  PausedPlatformTest() : ServedTest(SimulationFeed::opening(defaultSimulation()), {.isPaused = true}) {
    while (!channels_.contains("simulation") || !services_.contains("control_simulation")) hear();
  }
};

TEST_F(PausedPlatformTest, itWaitsBeforeTheFirstStepUntilAClientStartsIt) {
  client_->send(Subscribe{{{1, channels_["simulation"]}}});
  robotcontrol::SimulationStatus status;
  ASSERT_TRUE(status.ParseFromString(std::string(expect<MessageData>().payload)));
  EXPECT_FALSE(status.running());
  EXPECT_EQ(status.steps(), 0U);
  client_->send(ServiceCallRequest{services_["control_simulation"], 5, "json", R"({"action": "START"})"});
  expect<MessageData>([&](const MessageData& message) {
    return status.ParseFromString(std::string(message.payload)) && status.running() && status.steps() > 0;
  });
}

TEST_F(ServedPlatformTest, imagesComeWhileSomebodySubscribesToThem) {
  client_->send(Subscribe{{{1, channels_["red1/camera/image"]}}});
  const auto first = expect<MessageData>();
  foxglove::RawImage image;
  ASSERT_TRUE(image.ParseFromString(std::string(first.payload)));
  EXPECT_EQ(image.width(), 176U);
  const auto time = first.time;
  EXPECT_GT(expect<MessageData>().time, time);
}

TEST_F(ServedPlatformTest, stopActsAtThePlatform) {
  client_->send(ServiceCallRequest{services_["red1/stop"], 5, "json", R"({"engaged": true})"});
  const auto answer = expect<ServiceCallResponse>();
  EXPECT_EQ(nlohmann::json::parse(answer.payload)["accepted"], true);
  client_->send(Subscribe{{{1, channels_["simulation"]}}});
  robotcontrol::SimulationStatus status;
  ASSERT_TRUE(status.ParseFromString(std::string(expect<MessageData>().payload)));
  EXPECT_THAT(status.stopped_robots(), testing::ElementsAre("red1"));
  EXPECT_TRUE(status.running());
}

TEST_F(ServedPlatformTest, theProgramOfARobotIsStartedAgain) {
  const auto answerOf = [this](const std::string& service) {
    client_->send(ServiceCallRequest{services_[service], 7, "json", R"({"start_again": true})"});
    return nlohmann::json::parse(expect<ServiceCallResponse>().payload);
  };
  while (!services_.contains("red1/host_program")) hear();
  for (const char* service : {"red1/host_program", "host_program"}) {
    const auto answer = answerOf(service);
    EXPECT_EQ(answer["accepted"], true) << service << ": " << answer["reason"];
  }
}

TEST_F(ServedPlatformTest, aRobotThatIsAddedIsOfferedUntilItIsRemoved) {
  while (!services_.contains("edit_scene")) hear();
  const auto edit = [this](const std::string& change) {
    client_->send(ServiceCallRequest{services_["edit_scene"], 8, "json", change});
  };
  edit(R"({"add": {"model": "burger", "pose_in_field": {"x": 1, "y": 0.6}}})");
  while (!services_.contains("burger1/stop") || !channels_.contains("burger1/log")) hear();
  edit(R"({"remove": {"model": "burger1"}})");
  const std::uint64_t log = channels_["burger1/log"];
  expect<robotlink::websocket::Unadvertise>(
      [log](const auto& gone) { return std::ranges::find(gone.channelIds, log) != gone.channelIds.end(); });
  edit(R"({"add": {"model": "/etc/passwd", "pose_in_field": {"x": 1}}})");
  const auto refused = expect<ServiceCallResponse>([](const auto& answer) {
    return !nlohmann::json::parse(answer.payload)["accepted"].template get<bool>();
  });
  EXPECT_THAT(std::string(refused.payload), HasSubstr("file"));
}

TEST_F(ServedPlatformTest, whatCannotBeDoneHereIsRefusedWithTheReason) {
  client_->send(ServiceCallRequest{services_["control_replay"], 6, "json", R"({"action": "PLAY"})"});
  const auto answer = nlohmann::json::parse(expect<ServiceCallResponse>().payload);
  EXPECT_EQ(answer["accepted"], false);
  EXPECT_THAT(answer["reason"], HasSubstr("no log is open"));
}

TEST_F(ServedPlatformTest, whatNobodyFulfillsHereIsNotOffered) {
  EXPECT_TRUE(services_.contains("control_simulation"));
  EXPECT_FALSE(services_.contains("control_recording"));
}

TEST(ServedPlatform, whatCannotBeOpenedEndsWithTheReason) {
  logplayer::Recorder recorder({});
  std::ostringstream out;
  RunOptions run = defaultSimulation();
  run.scene = "no-such-scene.sdf";
  const auto errors = serve(
      SimulationFeed::opening(run), {}, recorder, [] { return false; }, out);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front().describe(), HasSubstr("no-such-scene.sdf"));
}

TEST(ServedPlatform, whoeverWaitsForOneThatCannotBeServedIsToldWhy) {
  RunOptions run = defaultSimulation();
  run.scene = "no-such-scene.sdf";
  EXPECT_THAT([&] { test::ServedHall({}, SimulationFeed::opening(run)); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("no-such-scene.sdf")));
}

TEST(ServedPlatform, aPortThatIsTakenIsNamed) {
  logplayer::Recorder recorder({});
  std::ostringstream out;
  const auto server = Server::make({}, {});
  const auto listener = Listener::open(server, {.address = {"127.0.0.1", 0}});
  ASSERT_TRUE(listener);
  const auto errors = serve(
      SimulationFeed::opening(defaultSimulation()), {.address = (*listener)->address()}, recorder,
      [] { return false; }, out);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front().text, HasSubstr(std::to_string((*listener)->address().port)));
}

}  // namespace
}  // namespace app
