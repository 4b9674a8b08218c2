// SPDX-License-Identifier: GPL-3.0-or-later
// A client and a server, connected by this test instead of a network.
#include "robotlink/foxglove/client/Client.h"

#include <gmock/gmock.h>

#include "robotlink/foxglove/protocol/CallPart.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/server/Server.h"

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ClientTest : public testing::Test {
 protected:
  ClientTest() {
    serverHandlers_.setParameters = [this](const ClientInfo&, const std::vector<Parameter>& parameters,
                                           Reply reply) {
      server_->updateParameters(parameters);
      reply.succeed();
    };
    serverHandlers_.clientMessage = [this](const ClientInfo&, const ClientChannel& channel,
                                           std::string_view payload) {
      published_.push_back(channel.topic + ":" + std::string(payload));
    };
    handlers_.message = [this](const Channel& channel, Instant, std::string_view payload) {
      messages_.push_back(channel.topic + ":" + std::string(payload));
    };
    handlers_.parameters = [this](const std::vector<Parameter>& parameters) {
      for (const Parameter& parameter : parameters) parameters_.push_back(parameter.name);
    };
    handlers_.connected = [this](const ServerInfo&) { events_.emplace_back("connected"); };
    handlers_.disconnected = [this] { events_.emplace_back("disconnected"); };
    handlers_.status = [this](const Status& status) { events_.push_back(status.message); };
    startServer();
    client_ = std::make_unique<Client>(handlers_, ClientLimits(), clock_);
  }
  void startServer() {
    server_ = Server::make({}, serverHandlers_);
    channels_ = server_->addChannels({{"a", "json", "", ""}, {"b", "json", "", "", "", Delivery::kComplete}});
  }
  void connect() {
    served_ = *server_->connect({0, "1.2.3.4:5", "x"}, [] {});
    client_->opened();
    exchange();
  }
  void cut() {
    server_->disconnected(served_);
    served_.reset();
    client_->lost();
  }
  /// Carries messages until nobody has any.
  void exchange() {
    for (bool isBusy = true; isBusy;) {
      isBusy = false;
      while (const auto frame = client_->next()) {
        server_->received(served_, frame->kind, frame->bytes);
        isBusy = true;
      }
      while (const auto next = server_->next(*served_, clock_->now())) {
        std::string bytes(reinterpret_cast<const char*>(next->head.data()), next->headSize);
        bytes += *next->payload;
        EXPECT_TRUE(client_->received(next->kind, bytes));
        isBusy = true;
      }
    }
  }
  void publish(std::size_t channel, const std::string& text) {
    channels_[channel]->publish(clock_->now(), text);
    exchange();
  }
  /// Adds a service that answers with its argument.
  void addEcho() {
    Service service;
    service.name = "echo";
    server_->addService(service, [](const ClientInfo&, const ServiceCallRequest& call, Reply reply) {
      reply.succeed(std::string(call.payload));
    });
  }
  Client::AnswerHandler keep() {
    return [this](const Result<Client::Answer>& answer) {
      answers_.push_back(answer ? answer->data : answer.error().text);
    };
  }
  Client::Call echo(std::string payload) {
    Client::Call call;
    call.service = "echo";
    call.encoding = "json";
    call.payload = std::move(payload);
    return call;
  }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  ServerHandlers serverHandlers_;
  ClientHandlers handlers_;
  std::shared_ptr<Server> server_;
  std::vector<ChannelPtr> channels_;
  ClientPtr served_;
  std::unique_ptr<Client> client_;
  std::vector<std::string> messages_, parameters_, events_, answers_, published_;
};

TEST_F(ClientTest, whatWasAskedForBeforeTheConnectionIsAskedForAfterEachConnection) {
  client_->subscribe({"a", "c"});
  client_->subscribeParameters(true);
  client_->setBudget(50'000);
  ClientChannel channel;
  channel.topic = "drive";
  channel.encoding = "json";
  client_->advertise(channel);
  EXPECT_FALSE(client_->publish("drive", "0"));
  for (int i = 0; i < 3; ++i) {
    startServer();
    server_->updateParameters({{"p", Value{true}}});
    connect();
    EXPECT_EQ(served_->outbox.budget().rate(), 50'000);
    publish(0, "1");
    publish(1, "2");
    server_->addChannels({{"c", "json", "", ""}})[0]->publish(clock_->now(), "not yet");
    exchange();
    EXPECT_TRUE(client_->publish("drive", "x"));
    exchange();
    EXPECT_THAT(messages_, ElementsAre("a:1"));
    EXPECT_THAT(published_, ElementsAre("drive:x"));
    EXPECT_THAT(parameters_, testing::Contains("p"));
    EXPECT_TRUE(client_->state().isConnected());
    cut();
    messages_.clear();
    published_.clear();
    parameters_.clear();
  }
  EXPECT_EQ(client_->state().connections, 3U);
}

TEST_F(ClientTest, whatIsUnsubscribedEndsAtTheServer) {
  client_->subscribe({"a", "b"});
  connect();
  client_->unsubscribe({"a"});
  exchange();
  EXPECT_FALSE(channels_[0]->isWanted());
  EXPECT_TRUE(channels_[1]->isWanted());
  client_->subscribe({"a"});
  exchange();
  publish(0, "1");
  EXPECT_THAT(messages_, ElementsAre("a:1"));
}

TEST_F(ClientTest, aCallIsAnsweredOrFailsWithASentence) {
  addEcho();
  connect();
  client_->call(echo("1"), keep());
  exchange();
  EXPECT_THAT(answers_, ElementsAre("1"));
  Client::Call unknown = echo("2");
  unknown.service = "jump";
  client_->call(unknown, keep());
  exchange();
  clock_->advance(2s);
  client_->tick();
  EXPECT_THAT(answers_, ElementsAre("1", "the robot offers no 'jump'"));
}

TEST_F(ClientTest, aCallWaitsForAConnectionButNotForever) {
  addEcho();
  client_->call(echo("early"), keep());
  client_->call(echo("late"), keep());
  connect();
  EXPECT_THAT(answers_, ElementsAre("early", "late"));
  cut();
  client_->setLink(ConnectionState::Phase::kSilent, clock_->now(), "nothing is heard of the robot");
  client_->call(echo("lost"), keep());
  clock_->advance(1999ms);
  client_->tick();
  EXPECT_EQ(answers_.size(), 2U);
  clock_->advance(1ms);
  client_->tick();
  EXPECT_EQ(answers_.back(), "there is no connection with the robot: nothing is heard of the robot");
}

TEST_F(ClientTest, aCallThatWasSentBeforeACutIsNotRepeated) {
  Service service;
  service.name = "echo";
  std::vector<Reply> replies;
  server_->addService(service, [&](const ClientInfo&, const ServiceCallRequest&, const Reply& reply) {
    replies.push_back(reply);
  });
  connect();
  client_->call(echo("1"), keep());
  exchange();
  ASSERT_EQ(replies.size(), 1U);
  cut();
  EXPECT_THAT(answers_, ElementsAre(HasSubstr("may or may not have been executed")));
  connect();
  EXPECT_EQ(replies.size(), 1U);
  replies[0].succeed("1");
  exchange();
  EXPECT_EQ(answers_.size(), 1U);
}

TEST_F(ClientTest, whatIsUrgentGoesAheadOfEverythingAlsoOfTheRestOfALongCall) {
  std::vector<std::string> called;
  for (const char* name : {"table", "stop", "key"}) {
    Service service;
    service.name = name;
    server_->addService(
        service, [&called, name](const ClientInfo&, const ServiceCallRequest& call, const Reply& reply) {
          called.push_back(name + std::to_string(call.payload.size()));
          reply.succeed();
        });
  }
  connect();
  Client::Call table = echo(std::string(100'000, 't')), key = echo("k"), stop = echo("");
  table.service = "table";
  key.service = "key";
  stop.service = "stop";
  stop.urgency = Client::Urgency::kUrgent;
  client_->call(table, keep());
  for (int i = 0; i < 10; ++i) {
    const auto part = client_->next();
    ASSERT_TRUE(part);
    EXPECT_LT(part->bytes.size(), 3000U);
    server_->received(served_, part->kind, part->bytes);
  }
  client_->call(key, keep());
  client_->call(stop, keep());
  exchange();
  EXPECT_THAT(called, ElementsAre("stop0", "key1", "table100000"));
  EXPECT_EQ(answers_.size(), 3U);
}

TEST_F(ClientTest, aMessageThatWaitsIsReplacedByANewerOneOfItsTopic) {
  ClientChannel channel;
  channel.topic = "drive";
  channel.encoding = "json";
  client_->advertise(channel);
  connect();
  for (const char* value : {"1", "2", "3"}) EXPECT_TRUE(client_->publish("drive", value));
  exchange();
  EXPECT_THAT(published_, ElementsAre("drive:3"));
}

TEST_F(ClientTest, whatTheServerThinnedAndDroppedIsKnown) {
  client_->subscribe({"a", "b"});
  connect();
  EXPECT_FALSE(client_->state().thinned);
  for (int i = 0; i < 5; ++i) channels_[0]->publish(clock_->now(), std::to_string(i));
  exchange();
  clock_->advance(2s);
  client_->tick();
  exchange();
  EXPECT_EQ(client_->state().thinned, 4U);
  EXPECT_EQ(client_->state().dropped, 0U);
  EXPECT_EQ(client_->counters().at("a").thinned, 4U);
}

TEST_F(ClientTest, aServerThatOffersTooMuchLosesOnlyItsConnection) {
  client_ = std::make_unique<Client>(handlers_, ClientLimits{.channels = 3}, clock_);
  connect();
  Advertise many;
  for (std::uint64_t i = 10; i < 12; ++i) many.channels.push_back({i, "t", "json", "", "", ""});
  const Frame frame = encode(many);
  const auto result = client_->received(frame.kind, frame.bytes);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text, HasSubstr("more than 3 channels"));
}

TEST_F(ClientTest, aConnectionThatIsEndedEndsWithTheNextMessage) {
  connect();
  client_->end("nobody follows");
  const Frame frame = encode(Status{StatusLevel::kInfo, "hello", ""});
  const auto result = client_->received(frame.kind, frame.bytes);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text, HasSubstr("nobody follows"));
}

TEST_F(ClientTest, schemasOfServicesAreBounded) {
  client_ = std::make_unique<Client>(handlers_, ClientLimits{.schemaBytes = 100}, clock_);
  connect();
  const auto offer = [this](const std::string& name, std::size_t bytes) {
    const ServiceSchema schema{"json", "A", "jsonschema", std::string(bytes / 2, 'x')};
    const Service service{40, name, "S", schema, schema};
    const Frame frame = encode(AdvertiseServices{{service}});
    return client_->received(frame.kind, frame.bytes);
  };
  EXPECT_TRUE(offer("a", 80));
  EXPECT_TRUE(offer("a", 90)) << "it takes the place of the one before";
  const Frame gone = encode(UnadvertiseServices{{40}});
  EXPECT_TRUE(client_->received(gone.kind, gone.bytes));
  EXPECT_TRUE(offer("b", 80));
  const auto refused = offer("c", 40);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("schemas"));
}

TEST_F(ClientTest, whatIsNotUnderstoodIsSaidAndSkipped) {
  connect();
  EXPECT_TRUE(client_->received(FrameKind::kText, R"({"op":"dance"})"));
  EXPECT_TRUE(client_->received(FrameKind::kBinary, "\x7f"));
  EXPECT_TRUE(client_->received(FrameKind::kText, "{"));
  EXPECT_THAT(events_, ElementsAre("connected", HasSubstr("'dance'"), HasSubstr("not understood"),
                                   HasSubstr("not understood")));
}

TEST_F(ClientTest, aChannelIdThatIsUsedAgainIsAnotherChannel) {
  client_->subscribe({"a", "z"});
  connect();
  Advertise again;
  again.channels.push_back({channels_[0]->id(), "z", "json", "", "", ""});
  const Frame frame = encode(again);
  EXPECT_TRUE(client_->received(frame.kind, frame.bytes));
  // The server knows nothing of it: it objects, and nothing else happens.
  exchange();
  EXPECT_EQ(client_->channels().size(), 2U);
  EXPECT_THAT(messages_, IsEmpty());
}

TEST_F(ClientTest, partsThatAreOutOfOrderAreRefused) {
  addEcho();
  connect();
  const auto sendPart = [&](std::uint32_t id, CallPart part, const std::string& payload) {
    const Frame frame = encode(ServiceCallRequest{1, id, toEncoding(part), payload});
    server_->received(served_, frame.kind, frame.bytes);
  };
  sendPart(7, {4, 8, "json"}, "5678");
  sendPart(8, {0, std::size_t{1} << 40U, "json"}, "1234");
  sendPart(9, {0, 8, "json"}, "1234");
  sendPart(9, {4, 8, "json"}, "56789");
  std::vector<std::string> failures;
  while (const auto next = server_->next(*served_, clock_->now())) {
    const auto message = decodeServerMessage(next->kind, *next->payload);
    if (const auto* failed = message ? std::get_if<ServiceCallFailure>(&*message) : nullptr)
      failures.push_back(std::to_string(failed->callId) + " " + failed->message);
  }
  EXPECT_THAT(failures, ElementsAre(HasSubstr("7 the parts"), HasSubstr("8 the argument is longer"),
                                    HasSubstr("9 the parts")));
}

}  // namespace
}  // namespace robotlink::websocket
