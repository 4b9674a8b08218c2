// SPDX-License-Identifier: GPL-3.0-or-later
// The server without a transport: clients are values, and what would be sent is looked at.
#include "robotlink/foxglove/server/Server.h"

#include <gmock/gmock.h>

#include "robotlink/foxglove/server/ServedClient.h"

namespace robotlink::websocket::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const ServiceCallRequest kCall{1, 9, "json", "{}"};

class ServerTest : public testing::Test {
 protected:
  void start(ServerOptions options = {}) {
    handlers_.subscribersChanged = [this](const ChannelPtr& channel, const std::vector<ClientInfo>& clients) {
      std::string text = channel->setup().topic + ":";
      for (const ClientInfo& client : clients) text += " " + client.name;
      events_.push_back(text);
    };
    options.sessionId = "s";
    server_ = Server::make(std::move(options), handlers_);
  }
  ClientPtr join(const std::string& name) {
    auto client = server_->connect({0, "127.0.0.1:1", name}, [this] { ++wakes_; });
    return client ? *client : nullptr;
  }
  void say(const ClientPtr& client, const ClientMessage& message) {
    const Frame frame = encode(message);
    server_->received(client, frame.kind, frame.bytes);
  }
  /// All that waits for a client; payloads refer to the frames, which are kept.
  std::vector<ServerMessage> heard(const ClientPtr& client) {
    std::vector<ServerMessage> messages;
    while (const auto next = server_->next(*client, Instant())) {
      std::string& bytes =
          kept_.emplace_back(reinterpret_cast<const char*>(next->head.data()), next->headSize);
      bytes += *next->payload;
      messages.push_back(decodeServerMessage(next->kind, bytes).value());
    }
    return messages;
  }
  template <typename Message>
  std::vector<Message> heardOf(const ClientPtr& client) {
    std::vector<Message> found;
    for (const ServerMessage& message : heard(client))
      if (const auto* one = std::get_if<Message>(&message)) found.push_back(*one);
    return found;
  }
  std::vector<std::string> complaints(const ClientPtr& client) {
    std::vector<std::string> texts;
    for (const Status& status : heardOf<Status>(client)) texts.push_back(status.message);
    return texts;
  }
  static ChannelSetup setup(const std::string& topic, Delivery delivery = Delivery::kComplete) {
    return {topic, "json", "S", "{}", "jsonschema", delivery};
  }

  ServerHandlers handlers_;
  std::shared_ptr<Server> server_;
  std::vector<std::string> events_;
  std::deque<std::string> kept_;
  int wakes_ = 0;
};

TEST_F(ServerTest, newClientsLearnAllThatIsOffered) {
  handlers_.clientMessage = [](const auto&...) {};
  ServerOptions options;
  options.publishesTime = true;
  start(options);
  const auto channels = server_->addChannels({setup("a"), setup("b")});
  server_->removeChannels(std::span(channels).first(1));
  const auto id = server_->addService({0, "stop", "Stop", {}, {}}, [](const auto&...) {});
  server_->publishStatus({StatusLevel::kInfo, "gone", ""});
  const auto messages = heard(join("x"));
  ASSERT_EQ(messages.size(), 3U);
  const auto info = std::get<ServerInfo>(messages[0]);
  EXPECT_THAT(info.capabilities, ElementsAre("parameters", "parametersSubscribe", "services",
                                             "connectionGraph", "time", "clientPublish"));
  EXPECT_EQ(std::get<Advertise>(messages[2]).channels,
            (std::vector<Channel>{{channels[1]->id(), "b", "json", "S", "{}", "jsonschema"}}));
  EXPECT_EQ(std::get<AdvertiseServices>(messages[1]).services[0].id, id);
}

TEST_F(ServerTest, whoMayOnlyWatchIsToldThatNothingIsTaken) {
  handlers_.clientMessage = [](const auto&...) {};
  handlers_.playbackControl = [](const auto&...) {};
  start();
  const ClientPtr watcher = *server_->connect({0, "127.0.0.1:2", "y", true}, [] {});
  const auto infoOf = [&] { return std::get<ServerInfo>(heard(watcher).at(0)); };
  EXPECT_THAT(infoOf().capabilities, Not(Contains("clientPublish")));
  server_->setPlayable(TimeRange{Instant(), Instant(std::chrono::seconds(1))});
  const auto later = infoOf();
  EXPECT_THAT(later.capabilities, Not(Contains("clientPublish")));
  EXPECT_THAT(later.capabilities, Contains("playbackControl"));
}

TEST_F(ServerTest, theOfferIsEncodedOnceForAllClientsUntilItChanges) {
  start();
  const auto channels = server_->addChannels({setup("a")});
  const auto service = server_->addService({0, "stop", "Stop", {}, {}}, [](const auto&...) {});
  const auto greeting = [&](const ClientPtr& client) {
    std::vector<SharedBytes> all;
    while (const auto next = server_->next(*client, Instant())) all.push_back(next->payload);
    return all;
  };
  const auto first = greeting(join("x")), second = greeting(join("y"));
  ASSERT_EQ(first.size(), 3U);
  ASSERT_EQ(second.size(), 3U);
  EXPECT_EQ(first[1], second[1]) << "the same bytes, not equal ones";
  EXPECT_EQ(first[2], second[2]);
  server_->addChannels({setup("b")});
  EXPECT_EQ(std::get<Advertise>(heard(join("z"))[2]).channels.size(), 2U);
  server_->removeChannels(channels);
  server_->removeService(service);
  const auto last = heard(join("w"));
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(std::get<Advertise>(last[1]).channels.at(0).topic, "b");
}

TEST_F(ServerTest, whatAClientSaysThatHasGoneIsIgnored) {
  start();
  const auto channel = server_->addChannels({setup("a")})[0];
  const auto x = join("x");
  server_->disconnected(x);
  say(x, Subscribe{{{5, channel->id()}}});
  EXPECT_FALSE(channel->isWanted()) << "nobody would ever end it";
  EXPECT_THAT(events_, IsEmpty());
}

TEST_F(ServerTest, nothingIsSentUnlessSomebodySubscribed) {
  start();
  const auto channel = server_->addChannels({setup("a")})[0];
  const auto x = join("x"), y = join("y");
  heard(x), heard(y);
  channel->publish(Instant(), "unheard");
  EXPECT_FALSE(channel->isWanted());
  say(x, Subscribe{{{5, channel->id()}}});
  EXPECT_TRUE(channel->isWanted());
  channel->publish(Instant(Duration(7)), "one");
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(MessageData{5, Instant(Duration(7)), "one"})));
  EXPECT_THAT(heard(y), IsEmpty());
  say(y, Subscribe{{{6, channel->id()}}});
  say(x, Unsubscribe{{5, 99}});
  channel->publish(Instant(), "two");
  EXPECT_THAT(heard(x), IsEmpty());
  EXPECT_THAT(heardOf<MessageData>(y), ElementsAre(MessageData{6, Instant(), "two"}));
  server_->disconnected(y);
  EXPECT_FALSE(channel->isWanted());
  EXPECT_THAT(events_, ElementsAre("a: x", "a: x y", "a: y", "a:"));
}

TEST_F(ServerTest, allClientsShareTheBytesOfAMessage) {
  start();
  const auto channel = server_->addChannels({setup("a")})[0];
  const auto bytes = std::make_shared<const std::string>("image");
  std::vector<ClientPtr> clients;
  for (int i = 0; i < 10; ++i) {
    clients.push_back(join("x"));
    heard(clients.back());
    say(clients.back(), Subscribe{{{static_cast<std::uint32_t>(i), channel->id()}}});
  }
  channel->publish(Instant(), bytes);
  for (const auto& client : clients) EXPECT_EQ(server_->next(*client, Instant())->payload, bytes);
}

TEST_F(ServerTest, whoCannotSubscribeIsToldWhy) {
  ServerOptions options;
  options.limits.subscriptions = 2;
  start(options);
  const auto channels = server_->addChannels({setup("a"), setup("b"), setup("c")});
  const auto x = join("x");
  heard(x);
  say(x, Subscribe{{{1, channels[0]->id()}, {2, 99}}});
  EXPECT_THAT(complaints(x), ElementsAre("there is no channel 99"));
  say(x, Subscribe{{{1, channels[1]->id()}}});
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("has the id of another one: 1")));
  say(x, Subscribe{{{2, channels[0]->id()}, {3, 98}}});
  EXPECT_THAT(complaints(x), ElementsAre("you have subscribed to a already (and 1 more problems)"));
  say(x, Subscribe{{{2, channels[1]->id()}, {3, channels[2]->id()}}});
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("2 are allowed")));
  server_->received(x, FrameKind::kText, "{");
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("not JSON")));
}

TEST_F(ServerTest, latchedChannelsSendTheirNewestMessageToNewSubscribers) {
  start();
  auto latched = setup("map");
  latched.latched = true;
  const auto channel = server_->addChannels({latched})[0];
  channel->publish(Instant(), "old");
  channel->publish(Instant(Duration(1)), "new");
  const auto x = join("x");
  heard(x);
  say(x, Subscribe{{{1, channel->id()}}});
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(MessageData{1, Instant(Duration(1)), "new"})));
}

TEST_F(ServerTest, removedChannelsAreSilentAlsoForThoseWhoStillHoldThem) {
  start();
  const auto channels = server_->addChannels({setup("a")});
  const auto x = join("x");
  say(x, Subscribe{{{1, channels[0]->id()}}});
  channels[0]->publish(Instant(), "waits");
  server_->removeChannels(channels);
  channels[0]->publish(Instant(), "late");
  EXPECT_FALSE(channels[0]->isWanted());
  EXPECT_THAT(heardOf<MessageData>(x), IsEmpty());
  server_.reset();
  channels[0]->publish(Instant(), "later");
}

TEST_F(ServerTest, aClientThatTakesNothingIsToldWhyAndClosed) {
  ServerOptions options;
  options.limits.outbox.controlMessages = 10;
  start(options);
  const auto x = join("x"), y = join("y");
  for (int i = 0; i < 20; ++i) say(x, GetParameters{{}, "r"});
  EXPECT_THAT(server_->closingReason(*x), HasSubstr("too slowly"));
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("too slowly")));
  say(x, GetParameters{{}, "r"});
  EXPECT_THAT(heard(x), IsEmpty());
  EXPECT_EQ(server_->closingReason(*y), "");
}

TEST_F(ServerTest, theLinkIsWokenOnceUntilItHasSentAll) {
  start();
  const auto channel = server_->addChannels({setup("a")})[0];
  const auto x = join("x");
  say(x, Subscribe{{{1, channel->id()}}});
  heard(x);
  wakes_ = 0;
  for (int i = 0; i < 5; ++i) channel->publish(Instant(), "m");
  EXPECT_EQ(wakes_, 1);
  heard(x);
  channel->publish(Instant(), "m");
  EXPECT_EQ(wakes_, 2);
}

TEST_F(ServerTest, parametersAreReadAndTheirChangesPushed) {
  start();
  server_->updateParameters({{"a", Value{1.0}}, {"b", Value{true}}});
  const auto x = join("x"), y = join("y"), z = join("z");
  heard(x), heard(y), heard(z);
  say(x, GetParameters{{"a", "a", "missing"}, "r"});
  EXPECT_THAT(heardOf<ParameterValues>(x), ElementsAre(ParameterValues{{{"a", Value{1.0}}}, "r"}));
  say(x, SubscribeParameterUpdates{{"a"}});
  say(y, SubscribeParameterUpdates{});
  server_->updateParameters({{"a", Value{1.0}}, {"b", std::nullopt}, {"c", std::nullopt}});
  EXPECT_THAT(heard(x), IsEmpty()) << "what stays the same is not pushed";
  EXPECT_THAT(heardOf<ParameterValues>(y), ElementsAre(ParameterValues{{{"b", std::nullopt}}, ""}));
  server_->updateParameters({{"a", Value{2.0}}});
  EXPECT_THAT(heardOf<ParameterValues>(x), ElementsAre(ParameterValues{{{"a", Value{2.0}}}, ""}));
  heard(y);
  say(x, UnsubscribeParameterUpdates{{"a"}});
  say(y, UnsubscribeParameterUpdates{});
  server_->updateParameters({{"a", Value{3.0}}});
  EXPECT_THAT(heard(x), IsEmpty());
  EXPECT_THAT(heardOf<ParameterValues>(y), IsEmpty());
  EXPECT_THAT(heard(z), IsEmpty());
}

TEST_F(ServerTest, settingAParameterIsAnsweredWithWhatTheRobotMadeOfIt) {
  std::optional<Reply> reply;
  handlers_.setParameters = [&](const ClientInfo& client, const std::vector<Parameter>& parameters, Reply r) {
    events_.push_back(client.name + " sets " + parameters[0].name);
    reply = r;
  };
  start();
  const auto x = join("x");
  heard(x);
  say(x, SetParameters{{{"a", Value{9.0}}}, "r"});
  EXPECT_THAT(heard(x), IsEmpty());
  server_->updateParameters({{"a", Value{5.0}}});
  reply->succeed();
  reply->fail("only the first answer counts");
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(ParameterValues{{{"a", Value{5.0}}}, "r"})));
  say(x, SetParameters{{{"a", Value{9.0}}}, "r2"});
  reply->fail("a must be below 6");
  EXPECT_THAT(complaints(x), ElementsAre("a must be below 6"));
  EXPECT_THAT(events_, ElementsAre("x sets a", "x sets a"));
}

TEST_F(ServerTest, aClientSetsItsOwnBudgetAndSeesItsCounters) {
  start();
  const auto channel = server_->addChannels({setup("a", Delivery::kLatest)})[0];
  const auto x = join("x"), y = join("y");
  say(x, Subscribe{{{1, channel->id()}}});
  channel->publish(Instant(), "1");
  channel->publish(Instant(), "2");
  heard(x), heard(y);
  say(x, SetParameters{{{kBudgetParameter, Value{std::int64_t{125'000}}}}, "r"});
  EXPECT_THAT(heardOf<ParameterValues>(x),
              ElementsAre(ParameterValues{{{kBudgetParameter, Value{125'000.0}}}, "r"}));
  EXPECT_EQ(server_->clients()[0].budget, 125'000);
  EXPECT_EQ(server_->clients()[1].budget, 0);
  say(x, SetParameters{{{kBudgetParameter, Value{std::string("much")}}}, ""});
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("a number of bytes a second")));
  const Value rates = valueOf({{"a", 5.0}});
  say(x, SetParameters{{{kRatesParameter, rates}}, "r"});
  EXPECT_THAT(heardOf<ParameterValues>(x), ElementsAre(ParameterValues{{{kRatesParameter, rates}}, "r"}));
  EXPECT_EQ(server_->clients()[0].rates, (std::map<std::string, double>{{"a", 5.0}}));
  say(x, SetParameters{{{kRatesParameter, valueOf({{"a", -1.0}})}}, ""});
  EXPECT_THAT(complaints(x), ElementsAre(HasSubstr("the rate of a must be a number of messages a second")));
  say(x, GetParameters{{kCountersParameter}, "r"});
  const auto number = [](std::int64_t n) { return Value{n}; };
  const Value::Object counters{
      {"sent", number(1)}, {"bytes", number(14)}, {"thinned", number(1)}, {"dropped", number(0)}};
  EXPECT_THAT(heardOf<ParameterValues>(x),
              ElementsAre(ParameterValues{
                  {{kCountersParameter, Value{Value::Object{{"a", Value{counters}}}}}}, "r"}));
  EXPECT_EQ(server_->clients()[0].streams.at("a"), (StreamCounters{1, 14, 1, 0}));
}

TEST_F(ServerTest, servicesAnswerLaterFromAnyThreadAndFailIfNobodyAnswers) {
  std::vector<Reply> replies;
  start();
  const auto id = server_->addService({0, "s", "S", {}, {}},
                                      [&](const ClientInfo&, const ServiceCallRequest& call, Reply reply) {
                                        events_.push_back(std::string(call.payload));
                                        replies.push_back(reply);
                                      });
  const auto x = join("x");
  heard(x);
  for (std::uint32_t call = 1; call <= 3; ++call) say(x, ServiceCallRequest{id, call, "json", "{}"});
  replies[1].succeed("done");
  replies[0].fail("no");
  replies.clear();
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(ServiceCallResponse{id, 2, "json", "done"}),
                                    ServerMessage(ServiceCallFailure{id, 1, "no"}),
                                    ServerMessage(ServiceCallFailure{id, 3, "the robot gave no answer"})));
  say(x, ServiceCallRequest{99, 4, "json", ""});
  EXPECT_THAT(heardOf<ServiceCallFailure>(x),
              ElementsAre(ServiceCallFailure{99, 4, "there is no service 99"}));
  EXPECT_THAT(events_, ElementsAre("{}", "{}", "{}"));
}

TEST_F(ServerTest, aClientMayHave32CallsAtATime) {
  std::vector<Reply> replies;
  start();
  server_->addService({0, "s", "S", {}, {}},
                      [&](const auto&, const auto&, Reply reply) { replies.push_back(reply); });
  const auto x = join("x"), y = join("y");
  heard(x), heard(y);
  for (int i = 0; i < 33; ++i) say(x, kCall);
  EXPECT_EQ(replies.size(), 32U);
  EXPECT_THAT(
      heardOf<ServiceCallFailure>(x),
      ElementsAre(ServiceCallFailure{1, 9, "too many of your calls have no answer yet: 32 are allowed"}));
  say(y, kCall);
  EXPECT_EQ(replies.size(), 33U) << "others are not concerned";
  replies[0].succeed();
  say(x, kCall);
  EXPECT_EQ(replies.size(), 34U);
  server_->disconnected(x);
  server_.reset();
  replies.clear();  // answers nobody waits for
}

TEST_F(ServerTest, clientsPublishOnTheirChannelsUntilTheyGo) {
  handlers_.clientMessage = [this](const ClientInfo& client, const ClientChannel& channel,
                                   std::string_view payload) {
    events_.push_back(client.name + " " + channel.topic + " " + std::string(payload));
  };
  handlers_.clientUnadvertised = [this](const ClientInfo&, const ClientChannel& channel) {
    events_.push_back("end of " + channel.topic);
  };
  start();
  const auto x = join("x");
  heard(x);
  say(x, ClientAdvertise{{{4, "drive", "json", "D", "", ""},
                          {5, "stop", "json", "S", "", ""},
                          {6, "odd", "cdr", "", "", ""}}});
  EXPECT_THAT(complaints(x), ElementsAre("odd has the encoding cdr, which this robot does not accept"));
  say(x, ClientMessageData{4, "{}"});
  say(x, ClientMessageData{6, "{}"});
  EXPECT_THAT(complaints(x), ElementsAre("you have not advertised a channel 6"));
  say(x, ClientUnadvertise{{5}});
  server_->disconnected(x);
  EXPECT_THAT(events_, ElementsAre("x drive {}", "end of stop", "end of drive"));
}

TEST_F(ServerTest, theConnectionGraphIsUpdatedByDifferences) {
  start();
  server_->setConnectionGraph({{{"t", {"p"}}, {"u", {"p"}}}, {{"t", {"q"}}}, {{"s", {"p"}}}});
  const auto x = join("x");
  heard(x);
  say(x, SubscribeConnectionGraph{});
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(ConnectionGraphUpdate{
                            {{"t", {"p"}}, {"u", {"p"}}}, {{"t", {"q"}}}, {{"s", {"p"}}}, {}, {}})));
  server_->setConnectionGraph({{}, {{"t", {"q"}}, {"v", {}}}, {}});
  EXPECT_THAT(heard(x),
              ElementsAre(ServerMessage(ConnectionGraphUpdate{{{"t", {}}}, {{"v", {}}}, {}, {"u"}, {"s"}})));
  say(x, UnsubscribeConnectionGraph{});
  server_->setConnectionGraph({});
  EXPECT_THAT(heard(x), IsEmpty());
}

TEST_F(ServerTest, whoAsksForAFileGetsNone) {
  start();
  const auto x = join("x");
  heard(x);
  say(x, FetchAsset{"file:///etc/passwd", 3});
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(FetchAssetResponse{3, "this robot offers no files", ""})));
}

TEST_F(ServerTest, playbackIsSteeredByClientsAndItsStateToldToAll) {
  handlers_.playbackControl = [this](const ClientInfo& client, const PlaybackControl& control) {
    events_.push_back(client.name + " wants speed " + std::to_string(static_cast<int>(control.speed)));
    server_->publishPlaybackState(
        {PlaybackState::Phase::kPlaying, Instant(), control.speed, false, control.requestId});
  };
  start();
  server_->setPlayable(TimeRange{});
  const auto x = join("x"), y = join("y");
  heard(x), heard(y);
  say(x, PlaybackControl{PlaybackControl::Command::kPlay, 2, {}, "r"});
  EXPECT_THAT(heardOf<PlaybackState>(y),
              ElementsAre(PlaybackState{PlaybackState::Phase::kPlaying, Instant(), 2, false, "r"}));
  EXPECT_EQ(heardOf<PlaybackState>(join("z"))[0].requestId, "");
  EXPECT_THAT(events_, ElementsAre("x wants speed 2"));
}

TEST_F(ServerTest, clientsAreToldWhenThereIsALogToPlay) {
  handlers_.playbackControl = [](const ClientInfo&, const PlaybackControl&) {};
  start();
  const auto x = join("x");
  EXPECT_THAT(heardOf<ServerInfo>(x)[0].capabilities, testing::Not(testing::Contains("playbackControl")));
  say(x, PlaybackControl{});
  EXPECT_THAT(complaints(x), ElementsAre("this is not a log, so it cannot be played"));
  const TimeRange range{Instant(std::chrono::seconds(2)), Instant(std::chrono::seconds(5))};
  for (int i = 0; i < 2; ++i) server_->setPlayable(range);
  const auto told = heardOf<ServerInfo>(x);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_THAT(told[0].capabilities, testing::Contains("playbackControl"));
  EXPECT_EQ(told[0].dataStart, range.start);
  EXPECT_EQ(told[0].dataEnd, range.end);
  server_->publishPlaybackState({});
  server_->setPlayable({});
  EXPECT_THAT(heardOf<ServerInfo>(x)[0].capabilities, testing::Not(testing::Contains("playbackControl")));
  EXPECT_TRUE(heardOf<PlaybackState>(join("y")).empty());
}

TEST_F(ServerTest, timeIsLatestOnly) {
  start();
  const auto x = join("x");
  heard(x);
  for (int i = 0; i < 100; ++i) server_->publishTime(Instant(Duration(i)));
  EXPECT_THAT(heard(x), ElementsAre(ServerMessage(Time{Instant(Duration(99))})));
}

TEST_F(ServerTest, aMessageFromBeforeTheFirstTimeCanBeRead) {
  start();
  const auto channel = server_->addChannels({setup("a")})[0];
  const auto x = join("x");
  say(x, Subscribe{{{1, channel->id()}}});
  heard(x);
  channel->publish(Instant(Duration(-5)), "early");
  const auto messages = heardOf<MessageData>(x);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_EQ(messages[0].time, Instant());
}

TEST_F(ServerTest, whatRobotsCannotDoIsSaid) {
  start();
  const auto x = join("x");
  heard(x);
  say(x, PlaybackControl{});
  say(x, SetParameters{{{"a", Value{1.0}}}, ""});
  say(x, ClientAdvertise{{{4, "drive", "json", "D", "", ""}}});
  EXPECT_THAT(complaints(x), ElementsAre("this is not a log, so it cannot be played",
                                         "the parameters of this robot cannot be set",
                                         "this robot accepts no messages from clients"));
}

TEST_F(ServerTest, moreClientsThanAllowedAreRefused) {
  ServerOptions options;
  options.limits.clients = 1;
  start(options);
  const auto x = join("x");
  EXPECT_EQ(join("y"), nullptr);
  server_->disconnected(x);
  EXPECT_NE(join("y"), nullptr);
}

}  // namespace
}  // namespace robotlink::websocket::test
