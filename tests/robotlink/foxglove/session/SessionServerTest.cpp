// SPDX-License-Identifier: GPL-3.0-or-later
// What clients are offered of a session: streams, tables, parameters.
#include "robotlink/foxglove/session/SessionServer.h"

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "tests/robotlink/foxglove/session/OfferedSessionTest.h"

namespace robotlink::websocket::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using SessionServerTest = OfferedSessionTest;

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
  server_->setImageEncoders({{kJpegChannel, [&](const auto&) {
                                ++encoded;
                                return std::make_shared<foxglove::CompressedImage>();
                              }}});
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
  server_->finishImages();
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

TEST_F(SessionServerTest, whoComesAfterAResetGetsTablesAtTheTimeOfTheSession) {
  publish("transforms", Instant(759s), foxglove::FrameTransforms());
  publish("red1/tables/keys", Instant(760s), robotcontrol::KeyTable());
  tick();
  publish("transforms", Instant(), foxglove::FrameTransforms());
  tick();
  say(Subscribe{{{1, advertised().at("red1/tables/keys").id}}});
  const auto tables = heard<MessageData>();
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].time, Instant());
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

TEST_F(SessionServerTest, tablesShowKeysAsTheyAreWithoutSubscribers) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/tables/keys").id}}});
  const auto shown = [&]() -> std::optional<robotcontrol::KeyMode::Kind> {
    const auto messages = heard<MessageData>();
    robotcontrol::KeyTable table;
    if (messages.empty() || !table.ParseFromString(std::string(messages.back().payload))) return std::nullopt;
    return table.keys(0).mode().kind();
  };
  const auto publishMode = [&](int ms, robotcontrol::KeyMode::Kind kind) {
    auto table = *session_.store().latestAs<robotcontrol::KeyTable>("red1/tables/keys", Instant::max());
    table.mutable_keys(0)->mutable_mode()->set_kind(kind);
    publish("red1/tables/keys", Instant(std::chrono::milliseconds(ms)), table);
    tick();
  };
  EXPECT_EQ(shown(), robotcontrol::KeyMode::OFF);
  say(Subscribe{{{2, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  publishMode(5, robotcontrol::KeyMode::ALWAYS);
  EXPECT_EQ(shown(), robotcontrol::KeyMode::OFF) << "it is on for this client alone";
  say(Unsubscribe{{2}});
  publishMode(6, robotcontrol::KeyMode::ALWAYS);
  EXPECT_EQ(shown(), robotcontrol::KeyMode::OFF) << "an older table must not bring the subscription back";
  publishMode(7, robotcontrol::KeyMode::OFF);
  publishMode(8, robotcontrol::KeyMode::ALWAYS);
  EXPECT_EQ(shown(), robotcontrol::KeyMode::ALWAYS) << "the robot switched it on itself";
}

TEST_F(SessionServerTest, aKeyThatSomebodySetsWhileItIsOnForAClientIsShownAsOn) {
  publishTables();
  const auto channels = advertised();
  say(Subscribe{{{1, channels.at("red1/tables/keys").id}}});
  say(Subscribe{{{2, channels.at("red1/drawings/image/ball-percept/disc").id}}});
  auto table = *session_.store().latestAs<robotcontrol::KeyTable>("red1/tables/keys", Instant::max());
  table.mutable_keys(0)->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  publish("red1/tables/keys", Instant(5ms), table);
  tick();
  heard<MessageData>();
  Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("ball-percept/disc");
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  session_.request(request);
  // The robot's table does not change by that, and the clients' does.
  say(Subscribe{{{3, channels.at("red1/camera/image").id}}});
  const auto messages = heard<MessageData>();
  ASSERT_FALSE(messages.empty());
  ASSERT_TRUE(table.ParseFromString(std::string(messages.back().payload)));
  EXPECT_EQ(table.keys(0).mode().kind(), robotcontrol::KeyMode::ALWAYS);
}

TEST_F(SessionServerTest, servicesAreAnnouncedBeforeChannels) {
  publishTables();
  const ClientPtr late = *server_->server()->connect({0, "127.0.0.1:2", "y"}, [] {});
  std::vector<std::string> order;
  while (const auto next = server_->server()->next(*late, Instant())) {
    const std::string bytes =
        std::string(reinterpret_cast<const char*>(next->head.data()), next->headSize) + *next->payload;
    const ServerMessage message = decodeServerMessage(next->kind, bytes).value();
    if (std::holds_alternative<Advertise>(message)) order.emplace_back("channels");
    if (std::holds_alternative<AdvertiseServices>(message)) order.emplace_back("services");
  }
  EXPECT_THAT(order, ElementsAre("services", "channels"));
}

TEST_F(SessionServerTest, whatWasNeverPublishedIsAChannelAsSoonAsItsKeyIsKnown) {
  EXPECT_EQ(advertised().at("red1/steering").schemaName, "robotcontrol.SteeringStatus");
  publishTables();
  EXPECT_EQ(advertised().count("red1/stopwatches/cognition"), 0U);
  robotcontrol::KeyTable keys;
  const auto addKey = [&](const std::string& name, const std::string& stream) {
    keys.add_keys()->set_name(name);
    keys.mutable_keys()->rbegin()->set_stream(stream);
  };
  addKey("timing/tasks", "stopwatches");
  // These are in no table of processes.
  addKey("package/camera/settings", "camera/settings");
  addKey("package/oracle/classes", "oracle/classes");
  addKey("package/models/unknown", "models/unknown");
  publish("red1/tables/keys", Instant(2ms), keys);
  tick();
  const auto channels = advertised();
  EXPECT_EQ(channels.size(), 3U);
  EXPECT_EQ(channels.at("red1/stopwatches/cognition").schemaName, "robotcontrol.StopwatchTimes");
  EXPECT_EQ(channels.at("red1/camera/settings").schemaName, "robotcontrol.CameraSettings");
  EXPECT_EQ(channels.at("red1/oracle/classes").schemaName, "foxglove.RawImage");
  say(Subscribe{{{1, channels.at("red1/stopwatches/cognition").id}}});
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].set_key().name(), "timing/tasks");
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

TEST_F(SessionServerTest, theModeOfAKeyThatAClientSetsEndsWithIt) {
  publishTables();
  heard<Advertise>();
  say(SetParameters{{{"red1/keys/ball-percept/disc", Value{"every 3"}}}, "set"});
  ASSERT_EQ(requests_.size(), 1U);
  EXPECT_EQ(requests_[0].set_key().mode().n(), 3U);
  server_->server()->disconnected(client_);
  tick();
  ASSERT_EQ(requests_.size(), 2U);
  EXPECT_EQ(requests_[1].set_key().name(), "ball-percept/disc");
  EXPECT_EQ(requests_[1].set_key().mode().kind(), robotcontrol::KeyMode::OFF);
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
  session_.setRobots({});
  tick();
  const auto gone = heard<ConnectionGraphUpdate>();
  ASSERT_EQ(gone.size(), 1U);
  EXPECT_THAT(gone[0].removedTopics, testing::Contains("red1/camera/image"));
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
  EXPECT_EQ(channels, 7U);
  EXPECT_GT(services, 5U);
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

}  // namespace
}  // namespace robotlink::websocket::test
