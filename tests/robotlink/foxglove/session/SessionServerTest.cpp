// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/SessionServer.h"

#include <gmock/gmock.h>

#include <deque>
#include <nlohmann/json.hpp>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/ServedClient.h"

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using robotcontrol::Request;
using robotcontrol::RequestResult;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A session with one robot; requests to it are kept, and accepted unless `refusal_` says why not.
class SessionServerTest : public testing::Test {
 protected:
  SessionServerTest() {
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const Request& request) {
      requests_.push_back(request);
      RequestResult result;
      result.set_id(request.id());
      result.set_accepted(refusal_.empty());
      result.set_reason(refusal_);
      session_.pushResult(result);
    });
    server_ = std::make_unique<SessionServer>(session_);
    client_ = *server_->server()->connect({0, "127.0.0.1:1", "x"}, [] {});
  }
  template <typename Message>
  void publish(const std::string& path, Instant time, const Message& message = {}) {
    session_.push({path, time, std::make_shared<Message>(message)});
  }
  void publishTables() {
    robotcontrol::KeyTable keys;
    const auto addKey = [&](const std::string& name, const std::string& stream) {
      keys.add_keys()->set_name(name);
      keys.mutable_keys()->rbegin()->set_stream(stream);
    };
    addKey("ball-percept/disc", "drawings/image/ball-percept/disc");
    addKey("package/camera/image", "camera/image");
    robotcontrol::ProcessTable processes;
    auto& process = *processes.add_processes();
    process.set_name("cognition");
    process.add_receivers()->set_package("camera/image");
    process.mutable_receivers(0)->set_type("foxglove.RawImage");
    robotcontrol::SolutionTable solutions;
    solutions.add_tasks()->set_name("ball-percept");
    solutions.mutable_tasks(0)->set_active("scan-lines");
    publish("red1/tables/processes", Instant(1ms), processes);
    publish("red1/tables/keys", Instant(1ms), keys);
    publish("red1/tables/solutions", Instant(1ms), solutions);
    tick();
  }
  /// Requests are answered by one tick, and the answers handled by the next.
  void tick() {
    for (int i = 0; i < 2; ++i) {
      session_.tick();
      server_->tick();
    }
    session_.tick();
  }
  void say(const ClientMessage& message) {
    const Frame frame = encode(message);
    server_->server()->received(client_, frame.kind, frame.bytes);
    tick();
  }
  /// The messages of a type since the last call; payloads refer to the frames, which are kept.
  template <typename Message>
  std::vector<Message> heard() {
    std::vector<Message> found;
    while (const auto next = server_->server()->next(*client_, Instant())) {
      std::string& bytes =
          kept_.emplace_back(reinterpret_cast<const char*>(next->head.data()), next->headSize);
      bytes += *next->payload;
      const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
      if (const auto* one = std::get_if<Message>(&message)) found.push_back(*one);
    }
    return found;
  }
  /// What was advertised since the last hearing, by topic.
  std::map<std::string, Channel> advertised() {
    std::map<std::string, Channel> channels;
    for (const Advertise& message : heard<Advertise>())
      for (const Channel& channel : message.channels) channels[channel.topic] = channel;
    return channels;
  }

  Session session_;
  std::unique_ptr<SessionServer> server_;
  ClientPtr client_;
  std::vector<Request> requests_;
  std::string refusal_;
  std::deque<std::string> kept_;
};

TEST_F(SessionServerTest, aStreamIsAChannelWithItsSchema) {
  foxglove::RawImage image;
  image.set_width(7);
  publish("red1/camera/image", Instant(5ms), image);
  tick();
  const auto channels = advertised();
  ASSERT_TRUE(channels.contains("red1/camera/image"));
  const Channel& channel = channels.at("red1/camera/image");
  EXPECT_EQ(channel.encoding, "protobuf");
  EXPECT_EQ(channel.schemaName, "foxglove.RawImage");
  EXPECT_FALSE(channel.schema.empty());
  say(Subscribe{{{1, channel.id}}});
  EXPECT_THAT(heard<MessageData>(), IsEmpty());
  image.set_width(8);
  publish("red1/camera/image", Instant(6ms), image);
  tick();
  const auto messages = heard<MessageData>();
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].time, Instant(6ms));
  foxglove::RawImage received;
  ASSERT_TRUE(received.ParseFromString(std::string(messages[0].payload)));
  EXPECT_EQ(received.width(), 8U);
}

TEST_F(SessionServerTest, whoComesLaterGetsTheNewestTableAtOnce) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/tables/keys").id}}});
  ASSERT_EQ(heard<MessageData>().size(), 1U);
}

TEST_F(SessionServerTest, aKeyIsOnWhileItsChannelHasASubscriber) {
  publishTables();
  const auto channels = advertised();
  ASSERT_TRUE(channels.contains("red1/drawings/image/ball-percept/disc"));
  EXPECT_EQ(channels.at("red1/drawings/image/ball-percept/disc").schemaName, "foxglove.ImageAnnotations");
  ASSERT_TRUE(channels.contains("red1/camera/image"));
  EXPECT_EQ(channels.at("red1/camera/image").schemaName, "foxglove.RawImage");
  say(Subscribe{{{1, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].robot(), "red1");
  EXPECT_EQ(requests_[0].set_key().name(), "ball-percept/disc");
  EXPECT_EQ(requests_[0].set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
  server_->server()->disconnected(client_);
  tick();
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[1].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
}

TEST_F(SessionServerTest, aRequestIsAServiceThatAnswersWithItsResult) {
  std::map<std::string, std::uint32_t> ids;
  for (const AdvertiseServices& message : heard<AdvertiseServices>())
    for (const Service& service : message.services) ids[service.name] = service.id;
  ASSERT_TRUE(ids.contains("red1/stop"));
  ASSERT_TRUE(ids.contains("control_simulation"));
  say(ServiceCallRequest{ids["red1/stop"], 3, "json", R"({"engaged": true})"});
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_TRUE(requests_[0].stop().engaged());
  auto answers = heard<ServiceCallResponse>();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(nlohmann::json::parse(answers[0].payload)["accepted"], true);
  say(ServiceCallRequest{ids["red1/stop"], 4, "json", "{"});
  const auto failures = heard<ServiceCallFailure>();
  ASSERT_EQ(failures.size(), 1U);
  EXPECT_THAT(failures[0].message, HasSubstr("robotcontrol.Stop"));
  EXPECT_EQ(requests_.size(), 1U);
}

TEST_F(SessionServerTest, keysAndSolutionsAreParametersThatCanBeSet) {
  publishTables();
  heard<Advertise>();
  say(GetParameters{{}, "all"});
  std::map<std::string, std::string> values;
  for (const ParameterValues& message : heard<ParameterValues>())
    for (const Parameter& parameter : message.parameters)
      if (const auto* text = std::get_if<std::string>(&parameter.value->data)) values[parameter.name] = *text;
  EXPECT_EQ(values["red1/keys/ball-percept/disc"], "off");
  EXPECT_EQ(values["red1/solutions/ball-percept"], "scan-lines");
  say(SetParameters{
      {{"red1/solutions/ball-percept", Value{"blobs"}}, {"red1/keys/ball-percept/disc", Value{"every 3"}}},
      "set"});
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].select_solution().solution(), "blobs");
  EXPECT_EQ(requests_[1].set_key().mode().n(), 3U);
  const auto answers = heard<ParameterValues>();
  ASSERT_FALSE(answers.empty());
  EXPECT_EQ(answers.back().id, "set");
}

TEST_F(SessionServerTest, aParameterThatCannotBeSetIsRefusedBeforeAnythingIsDone) {
  publishTables();
  heard<Advertise>();
  say(SetParameters{{{"red1/keys/ball-percept/disc", Value{"always"}}, {"red1/keys/none", Value{"off"}}},
                    "set"});
  EXPECT_THAT(requests_, IsEmpty());
  const auto complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0].message, HasSubstr("red1/keys/none"));
}

TEST_F(SessionServerTest, processesAndPackagesAreTheConnectionGraph) {
  publishTables();
  heard<Advertise>();
  say(SubscribeConnectionGraph{});
  const auto updates = heard<ConnectionGraphUpdate>();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_THAT(updates[0].subscribedTopics.at("red1/camera/image"), ElementsAre("red1/cognition"));
}

TEST_F(SessionServerTest, aRobotThatIsGoneTakesItsChannelsAndServicesWithIt) {
  publishTables();
  heard<Advertise>();
  session_.setRobots({});
  tick();
  std::size_t channels = 0, services = 0;
  while (const auto next = server_->server()->next(*client_, Instant())) {
    const ServerMessage message = decodeServerMessage(next->kind, *next->payload).value();
    if (const auto* gone = std::get_if<Unadvertise>(&message)) channels += gone->channelIds.size();
    if (const auto* gone = std::get_if<UnadvertiseServices>(&message)) services += gone->serviceIds.size();
  }
  EXPECT_EQ(channels, 6U);
  EXPECT_GT(services, 5U);
}

}  // namespace
}  // namespace robotlink::websocket
