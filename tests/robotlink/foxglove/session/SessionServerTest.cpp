// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/SessionServer.h"

#include <gmock/gmock.h>

#include <deque>
#include <nlohmann/json.hpp>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Linking.pb.h"
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
    ServerOptions options;
    options.clock = clock_;
    server_ = std::make_unique<SessionServer>(session_, options);
    client_ = *server_->server()->connect({0, "127.0.0.1:1", "x"}, [] {});
  }
  /// When it ends it makes requests, which are kept here.
  ~SessionServerTest() override { server_.reset(); }
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

  /// Names of services to their ids.
  std::map<std::string, std::uint32_t> services() {
    std::map<std::string, std::uint32_t> ids;
    for (const AdvertiseServices& message : heard<AdvertiseServices>())
      for (const Service& service : message.services) ids[service.name] = service.id;
    return ids;
  }
  /// What a service answers a client: the reason of a refusal, or nothing.
  std::string call(const ClientPtr& client, std::uint32_t service, const std::string& argument) {
    const Frame frame = encode(ClientMessage(ServiceCallRequest{service, 9, "json", argument}));
    server_->server()->received(client, frame.kind, frame.bytes);
    tick();
    std::string reason = "no answer";
    while (const auto next = server_->server()->next(*client, Instant())) {
      // Payloads refer to it.
      const std::string bytes =
          std::string(reinterpret_cast<const char*>(next->head.data()), next->headSize) + *next->payload;
      const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
      if (const auto* answer = std::get_if<ServiceCallResponse>(&message))
        reason = nlohmann::json::parse(answer->payload)["reason"];
      if (const auto* failure = std::get_if<ServiceCallFailure>(&message)) reason = failure->message;
    }
    return reason;
  }
  std::vector<std::string> asked() {
    std::vector<std::string> words;
    for (const Request& request : std::exchange(requests_, {}))
      words.push_back(Request::descriptor()->FindFieldByNumber(request.what_case())->name() +
                      (request.has_motion() ? " " + std::to_string(request.motion().motion().kind()) : ""));
    return words;
  }
  const robotcontrol::SteeringStatus* steering() {
    return session_.store().latestAs<robotcontrol::SteeringStatus>("red1/steering", Instant::max());
  }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  Session session_;
  std::unique_ptr<SessionServer> server_;
  ClientPtr client_;
  std::vector<Request> requests_;
  std::string refusal_;
  std::deque<std::string> kept_;
};

TEST_F(SessionServerTest, whoComesInAPauseSeesWhatWasPublishedBefore) {
  publish("red1/camera/image", Instant(1ms), foxglove::RawImage());
  tick();
  const auto channel = advertised().at("red1/camera/image").id;
  say(Subscribe{{{1, channel}}});
  EXPECT_TRUE(heard<MessageData>().empty());
  for (int i = 0; i < 10; ++i) tick();
  const auto first = heard<MessageData>();
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(first[0].time, Instant(1ms));
  // While something happens, who comes waits for what comes.
  publish("red1/camera/image", Instant(2ms), foxglove::RawImage());
  tick();
  EXPECT_EQ(heard<MessageData>().size(), 1U);
  say(Unsubscribe{{1}});
  say(Subscribe{{{2, channel}}});
  EXPECT_TRUE(heard<MessageData>().empty());
}

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

TEST_F(SessionServerTest, aMessageIsSerializedOnceForAllClients) {
  std::vector<ClientPtr> clients{client_};
  while (clients.size() < 10) clients.push_back(*server_->server()->connect({}, [] {}));
  int encoded = 0;
  server_->setImageEncoder([&](const auto&) {
    ++encoded;
    return std::make_shared<foxglove::CompressedImage>();
  });
  publish<foxglove::RawImage>("red1/camera/image", Instant(1ms));
  tick();
  auto channels = advertised();
  const Frame frame = encode(ClientMessage(
      Subscribe{{{1, channels["red1/camera/image"].id}, {2, channels["red1/camera/image/jpeg"].id}}}));
  for (const ClientPtr& client : clients) {
    server_->server()->received(client, frame.kind, frame.bytes);
    while (server_->server()->next(*client, Instant())) {
    }
  }
  publish<foxglove::RawImage>("red1/camera/image", Instant(2ms));
  tick();
  std::map<SharedBytes, int> sent;
  for (const ClientPtr& client : clients) {
    while (const auto next = server_->server()->next(*client, Instant()))
      if (next->headSize == kMessageHeadSize) ++sent[next->payload];
  }
  EXPECT_EQ(encoded, 1);
  ASSERT_EQ(sent.size(), 2U) << "the image and the JPEG";
  for (const auto& [bytes, count] : sent) EXPECT_EQ(count, 10);
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

TEST_F(SessionServerTest, aKeyOfARobotThatWasGoneIsOffUntilSomebodySubscribesAnew) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  ASSERT_EQ(requests_.size(), 1U);
  session_.setRobots({});
  tick();
  session_.setRobots({"red1"});
  requests_.clear();
  publishTables();
  tick();
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
  say(Subscribe{{{2, advertised().at("red1/drawings/image/ball-percept/disc").id}}});
  EXPECT_EQ(requests_.back().set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
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

TEST_F(SessionServerTest, whatIsNoTableOnThePathOfATableChangesNothing) {
  publishTables();
  heard<Advertise>();
  for (const char* table : {"keys", "solutions", "processes"}) {
    publish("red1/tables/" + std::string(table), Instant(2ms), foxglove::Log());
    // A robot that was not there before.
    publish("blue1/tables/" + std::string(table), Instant(2ms), foxglove::Log());
  }
  tick();
  say(GetParameters{{"red1/keys/ball-percept/disc", "red1/solutions/ball-percept"}, "x"});
  const auto values = heard<ParameterValues>();
  ASSERT_FALSE(values.empty());
  EXPECT_EQ(values.back().parameters.size(), 2U);
}

TEST_F(SessionServerTest, aStreamThatChangesItsTypeGetsAnotherChannelButNotAllTheTime) {
  publish("red1/models/ball", Instant(1ms), foxglove::Log());
  tick();
  const auto old = advertised().at("red1/models/ball");
  say(Subscribe{{{1, old.id}}});
  for (int i = 0; i < 100; ++i) {
    publish("red1/models/ball", Instant(2ms), foxglove::RawImage());
    publish("red1/models/ball", Instant(2ms), foxglove::Log());
    tick();
  }
  const auto now = advertised();
  ASSERT_EQ(now.size(), 1U);
  EXPECT_EQ(now.at("red1/models/ball").schemaName, "foxglove.RawImage");
  EXPECT_NE(now.at("red1/models/ball").id, old.id);
  clock_->advance(1s);
  publish("red1/models/ball", Instant(3ms), foxglove::Log());
  tick();
  EXPECT_EQ(advertised().at("red1/models/ball").schemaName, "foxglove.Log");
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

TEST_F(SessionServerTest, whatAClientPublishesMovesTheRobotUntilItIsNotHeard) {
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  EXPECT_THAT(asked(), ElementsAre("motion 1"));
  ASSERT_NE(steering(), nullptr);
  EXPECT_EQ(steering()->who(), "x at 127.0.0.1:1");
  EXPECT_EQ(steering()->client(), client_->info.id);
  clock_->advance(490ms);
  tick();
  EXPECT_THAT(asked(), IsEmpty());
  clock_->advance(20ms);
  tick();
  EXPECT_THAT(asked(), ElementsAre("motion 0"));
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  asked();
  server_->server()->disconnected(client_);
  tick();
  EXPECT_THAT(asked(), ElementsAre("motion 0"));
  EXPECT_EQ(steering()->who(), "");
}

TEST_F(SessionServerTest, aFloodOfCommandsIsOneRequestATick) {
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  const Frame frame = encode(ClientMessage(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"}));
  for (int i = 0; i < 1000; ++i) server_->server()->received(client_, frame.kind, frame.bytes);
  tick();
  EXPECT_EQ(asked().size(), 1U);
}

TEST_F(SessionServerTest, whatIsWrongWithCommandsIsSaidOnce) {
  heard<ServerInfo>();
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}, {8, "/chatter", "json", "", "", ""}}});
  auto complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_THAT(complaints[0].message, HasSubstr("/chatter"));
  refusal_ = "the robot is asleep";
  for (int i = 0; i < 3; ++i) say(ClientMessageData{7, "{}"});
  complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_EQ(complaints[0].message, refusal_);
  refusal_.clear();
  say(ClientMessageData{7, "{}"});
  say(ClientMessageData{7, "["});
  EXPECT_EQ(heard<Status>().size(), 1U);
}

TEST_F(SessionServerTest, oneSteersAndTheOtherTakesOverButStopIsEverybodys) {
  auto ids = services();
  const ClientPtr other = *server_->server()->connect({0, "127.0.0.1:2", "y"}, [] {});
  const char* const kWalk = R"({"motion": {"kind": "WALK"}})";
  EXPECT_EQ(call(client_, ids["red1/motion"], kWalk), "");
  EXPECT_THAT(call(other, ids["red1/motion"], kWalk), HasSubstr("steered by x at 127.0.0.1:1"));
  EXPECT_THAT(call(other, ids["red1/set_goal"], "{}"), HasSubstr("steered by"));
  EXPECT_EQ(call(other, ids["red1/stop"], R"({"engaged": true})"), "");
  EXPECT_EQ(call(other, ids["red1/steer"], "{}"), "");
  EXPECT_THAT(asked(), ElementsAre("motion 1", "stop", "motion 0"));
  EXPECT_EQ(call(other, ids["red1/motion"], kWalk), "");
  EXPECT_THAT(call(client_, ids["red1/motion"], kWalk), HasSubstr("steered by y"));
  // A request of the session itself is one of a person at this machine.
  Request request;
  request.set_robot("red1");
  request.mutable_motion();
  session_.request(request);
  tick();
  EXPECT_EQ(steering()->who(), "this machine");
  EXPECT_THAT(call(other, ids["red1/motion"], kWalk), HasSubstr("steered by this machine"));
  EXPECT_EQ(call(other, ids["red1/steer"], R"({"give_up": true})"), "");
  EXPECT_THAT(call(other, ids["red1/steer"], "x"), HasSubstr("give_up"));
}

TEST_F(SessionServerTest, stopGoesBeforeWhatWaits) {
  auto ids = services();
  const auto post = [&](const char* service, const char* argument) {
    const Frame frame = encode(ClientMessage(ServiceCallRequest{ids[service], 1, "json", argument}));
    server_->server()->received(client_, frame.kind, frame.bytes);
  };
  post("red1/set_color_table", "{}");
  post("red1/motion", "{}");
  post("red1/stop", R"({"engaged": true})");
  tick();
  EXPECT_THAT(asked(), ElementsAre("stop", "set_color_table", "motion 0"));
}

TEST_F(SessionServerTest, whoOnlyWatchesMayEngageStopButNotReleaseIt) {
  auto ids = services();
  const ClientPtr watcher = *server_->server()->connect({0, "127.0.0.1:2", "y", true}, [] {});
  EXPECT_EQ(call(watcher, ids["red1/stop"], R"({"engaged": true})"), "");
  EXPECT_THAT(call(watcher, ids["red1/stop"], R"({"engaged": false})"), HasSubstr("only watch"));
  EXPECT_EQ(call(watcher, ids["red1/get_parameters"], "{}"), "");
  for (const char* service :
       {"red1/motion", "red1/set_key", "red1/steer", "red1/set_color_table", "control_simulation"})
    EXPECT_THAT(call(watcher, ids[service], "{}"), HasSubstr("only watch")) << service;
  EXPECT_THAT(asked(), ElementsAre("stop", "get_parameters"));
}

TEST_F(SessionServerTest, parametersOfSolutionsAreAskedForOfferedAndSet) {
  robotcontrol::SolutionTable solutions;
  solutions.add_tasks()->set_name("walking");
  auto& solution = *solutions.mutable_tasks(0)->add_solutions();
  solution.set_name("gait");
  solution.set_has_parameters(true);
  publish("red1/tables/solutions", Instant(1ms), solutions);
  tick();
  EXPECT_THAT(asked(), ElementsAre("get_parameters"));
  robotcontrol::ParameterValues values;
  values.set_task("walking");
  values.set_solution("gait");
  values.mutable_value()->set_type("robotcontrol.MotionRequest");
  publish("red1/parameters/walking/gait", Instant(2ms), values);
  say(SubscribeParameterUpdates{});
  heard<Advertise>();
  say(SetParameters{{{"red1/parameters/walking/gait/walk/x", Value{0.5}}}, "set"});
  ASSERT_EQ(requests_.size(), 1U);
  robotcontrol::MotionRequest set;
  ASSERT_TRUE(set.ParseFromString(requests_[0].set_parameters().value().data()));
  EXPECT_EQ(set.walk().x(), 0.5);
  EXPECT_EQ(asked().size(), 1U);
  // The robot tells what it made of it.
  values.mutable_value()->set_data(set.SerializeAsString());
  publish("red1/parameters/walking/gait", Instant(3ms), values);
  heard<ParameterValues>();
  tick();
  const auto updates = heard<ParameterValues>();
  ASSERT_EQ(updates.size(), 1U);
  EXPECT_EQ(updates[0].parameters.at(0).name, "red1/parameters/walking/gait/walk/x");
  // A refusal is told, and what holds is asked for.
  refusal_ = "too fast";
  say(SetParameters{{{"red1/parameters/walking/gait/walk/x", Value{99.0}}}, "set"});
  EXPECT_THAT(asked(), ElementsAre("set_parameters", "get_parameters"));
  const auto complaints = heard<Status>();
  ASSERT_EQ(complaints.size(), 1U);
  EXPECT_EQ(complaints[0].message, "too fast");
}

TEST_F(SessionServerTest, whoAsksForAKeyIsPublished) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  const auto subscribers = [&] {
    return session_.store().latestAs<robotcontrol::KeySubscribers>("red1/tables/subscribers", Instant::max());
  };
  ASSERT_NE(subscribers(), nullptr);
  ASSERT_EQ(subscribers()->keys_size(), 1);
  EXPECT_EQ(subscribers()->keys(0).name(), "ball-percept/disc");
  EXPECT_THAT(subscribers()->keys(0).clients(), ElementsAre("x at 127.0.0.1:1"));
  say(Unsubscribe{{1}});
  EXPECT_EQ(subscribers()->keys_size(), 0);
}

TEST_F(SessionServerTest, whenTheOfferEndsKeysAreAsBeforeAndRobotsStand) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  say(ClientAdvertise{{{7, "red1/remote/drive", "json", "", "", ""}}});
  say(ClientMessageData{7, R"({"velocity": {"x": 0.1}})"});
  EXPECT_THAT(asked(), ElementsAre("set_key", "motion 1"));
  server_.reset();
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[0].motion().motion().kind(), robotcontrol::MotionRequest::STAND);
  EXPECT_EQ(requests_[1].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
}

TEST_F(SessionServerTest, resultsThatComeWhenTheOfferHasEndedAreIgnored) {
  publishTables();
  heard<Advertise>();
  const Frame frame =
      encode(ClientMessage(SetParameters{{{"red1/solutions/ball-percept", Value{"blobs"}}}, "set"}));
  const auto server = server_->server();
  server->received(client_, frame.kind, frame.bytes);
  server_->tick();
  EXPECT_EQ(requests_.size(), 1U);
  server_.reset();
  session_.tick();  // the result
}

}  // namespace
}  // namespace robotlink::websocket
