// SPDX-License-Identifier: GPL-3.0-or-later
// Over real sockets on loopback, with a client made of Beast alone.
#include "robotlink/foxglove/server/Listener.h"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>
#include <unistd.h>

#include <thread>

#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/RawClient.h"

namespace robotlink::websocket::test {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class ListenerTest : public testing::Test {
 protected:
  ListenerTest() {
    options_.address.port = 0;
    options_.greetingDelay = Duration::zero();
    options_.clock = clock_;
    handlers_.report = [this](const std::string& sentence) {
      const std::lock_guard lock(mutex_);
      reports_.push_back(sentence);
    };
  }
  void start(ServerOptions options = {}) {
    server_ = Server::make(std::move(options), handlers_);
    auto listener = Listener::open(server_, options_);
    ASSERT_TRUE(listener) << listener.error().text;
    listener_ = *std::move(listener);
    port_ = listener_->address().port;
  }
  /// A client that has read the greeting.
  std::unique_ptr<RawClient> join(RawClient::Options options = {}) {
    auto client = std::make_unique<RawClient>(port_, std::move(options));
    client->expect<ServerInfo>();
    return client;
  }
  ChannelPtr addChannel(Delivery delivery, std::size_t maxWaiting = 1024) {
    return server_->addChannels({{"a", "json", "S", "", "", delivery, maxWaiting}})[0];
  }
  void subscribe(RawClient& client, const ChannelPtr& channel) {
    client.send(Subscribe{{{1, channel->id()}}});
    EXPECT_TRUE(eventually([&] { return channel->isWanted(); }));
  }
  std::vector<std::string> reports() {
    const std::lock_guard lock(mutex_);
    return reports_;
  }
  bool isAlone() {
    return eventually([&] { return server_->clients().empty(); });
  }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  Listener::Options options_;
  ServerHandlers handlers_;
  std::mutex mutex_;
  std::vector<std::string> reports_;
  std::shared_ptr<Server> server_;
  std::unique_ptr<Listener> listener_;
  std::uint16_t port_ = 0;
};

std::string wantedProtocols(const char* protocols, std::uint16_t port) {
  RawClient client(port, {protocols});
  return client.status() == 101 ? client.protocol() : std::to_string(client.status()) + " " + client.text();
}

TEST_F(ListenerTest, aSubProtocolIsNegotiated) {
  start();
  EXPECT_EQ(wantedProtocols("foxglove.websocket.v1", port_), "foxglove.websocket.v1");
  EXPECT_EQ(wantedProtocols("x, foxglove.websocket.v1, foxglove.sdk.v1", port_), "foxglove.sdk.v1");
  const RawClient listed(port_, {"x", "/", {{"Sec-WebSocket-Protocol", "foxglove.sdk.v1"}}});
  EXPECT_EQ(listed.protocol(), "foxglove.sdk.v1") << "a list may be spread over several fields";
  EXPECT_THAT(wantedProtocols("", port_), HasSubstr("400 This robot speaks the sub-protocols"));
  RawClient browser(port_, {"", "/", {}, 0, false});
  EXPECT_EQ(browser.status(), 426U);
  EXPECT_THAT(browser.text(), HasSubstr("Foxglove"));
}

TEST_F(ListenerTest, webPagesAndStrangersAreRefusedAndReported) {
  options_.admission = {"secret", {"https://a.org"}};
  start();
  EXPECT_EQ(RawClient(port_, {kSdkProtocol, "/", {{"Origin", "https://b.org"}}}).status(), 403U);
  EXPECT_EQ(
      RawClient(port_, {kSdkProtocol, "/", {{"Authorization", "Bearer secret"}, {"Origin", "https://a.org"}}})
          .status(),
      101U);
  EXPECT_EQ(RawClient(port_, {kSdkProtocol, "/?token=wrong"}).status(), 401U);
  EXPECT_THAT(reports(), Contains(HasSubstr("The token is not one of this robot's")));
  EXPECT_THAT(reports(), Contains(HasSubstr("https://b.org")));
}

TEST_F(ListenerTest, aPageThatTriesAgainAndAgainDoesNotFillTheLog) {
  start();
  const auto knock = [&] {
    return RawClient(port_, {kSdkProtocol, "/", {{"Origin", "https://b.org"}}}).status();
  };
  for (int i = 0; i < 60; ++i) EXPECT_EQ(knock(), 403U);
  EXPECT_EQ(reports().size(), 50U);
  clock_->advance(std::chrono::seconds(10));
  EXPECT_EQ(knock(), 403U);
  EXPECT_EQ(reports().size(), 52U);
  EXPECT_THAT(reports(), Contains("10 more messages about clients were left out"));
}

TEST_F(ListenerTest, afterAWrongTokenEvenTheRightOneWaits) {
  options_.admission.token = "secret";
  start();
  EXPECT_EQ(RawClient(port_).status(), 401U);
  std::atomic<unsigned> status{0};
  std::thread client([&] { status = RawClient(port_, {kSdkProtocol, "/?token=secret"}).status(); });
  clock_->advance(milliseconds(999));
  EXPECT_EQ(status, 0U);
  EXPECT_THAT(server_->clients(), IsEmpty());
  clock_->advance(milliseconds(1));
  EXPECT_TRUE(eventually([&] { return status == 101; }));
  client.join();
}

TEST_F(ListenerTest, whereOneCannotListenTheErrorSaysWhatToDo) {
  start();
  const auto problem = [&](const ListenAddress& address) {
    Listener::Options options;
    options.address = address;
    const auto listener = Listener::open(server_, options);
    return listener ? "none" : listener.error().text;
  };
  EXPECT_THAT(problem({"127.0.0.1", port_}),
              HasSubstr("another program is listening there: end it, or choose another port"));
  EXPECT_THAT(problem({"192.0.2.1", 0}), HasSubstr("this machine does not have that address"));
  EXPECT_THAT(problem({"robot", 0}), HasSubstr("not an IP address"));
}

TEST_F(ListenerTest, messagesArriveWholeAndInOrder) {
  start();
  const auto channel = addChannel(Delivery::kComplete);
  const auto client = join();
  const auto channels = client->expect<Advertise>().channels;
  ASSERT_EQ(channels.size(), 1U);
  subscribe(*client, channel);
  const std::string image(3'000'000, 'x');
  channel->publish(Instant(Duration(5)), "small");
  channel->publish(Instant(Duration(6)), image);
  channel->publish(Instant(Duration(7)), std::string());
  EXPECT_EQ(client->expect<MessageData>(), (MessageData{1, Instant(Duration(5)), "small"}));
  EXPECT_EQ(client->expect<MessageData>(), (MessageData{1, Instant(Duration(6)), image}));
  EXPECT_EQ(client->expect<MessageData>(), (MessageData{1, Instant(Duration(7)), ""}));
}

TEST_F(ListenerTest, clientsHaveNamesAndAddresses) {
  start();
  const auto client = join({kSdkProtocol, "/", {{"User-Agent", "Workbench of Ann"}}});
  const auto clients = server_->clients();
  ASSERT_EQ(clients.size(), 1U);
  EXPECT_EQ(clients[0].info.name, "Workbench of Ann");
  EXPECT_THAT(clients[0].info.address, testing::StartsWith("127.0.0.1:"));
  server_->disconnect(clients[0].info.id, "the robot is being switched off");
  EXPECT_EQ(client->closeReason(), "the robot is being switched off");
  EXPECT_TRUE(isAlone());
}

TEST_F(ListenerTest, aStalledClientGetsTheNewestMessageAndSlowsNobody) {
  start();
  const auto channel = addChannel(Delivery::kLatest);
  const auto stalled = join({kSdkProtocol, "/", {}, 4096});
  const auto quick = join();
  subscribe(*stalled, channel);
  quick->send(Subscribe{{{1, channel->id()}}});
  quick->send(GetParameters{{}, "subscribed"});
  quick->expect<ParameterValues>();
  constexpr int kFrames = 200;
  for (int i = 0; i < kFrames; ++i) {
    channel->publish(Instant(Duration(i)), std::string(200'000, 'x'));
    EXPECT_EQ(quick->expect<MessageData>().time, Instant(Duration(i)));
  }
  const ClientState state = server_->clients()[0];
  EXPECT_GT(state.streams.at("a").thinned, 100U);
  EXPECT_LE(state.waitingBytes, 201'000U) << "one frame waits";
  Instant last;
  while (last != Instant(Duration(kFrames - 1))) {
    const Instant time = stalled->expect<MessageData>().time;
    ASSERT_GE(time, last);
    last = time;
  }
}

TEST_F(ListenerTest, aCompleteChannelIsBoundedUnderAStalledClient) {
  start();
  const auto channel = addChannel(Delivery::kComplete, 10);
  const auto stalled = join({kSdkProtocol, "/", {}, 4096});
  subscribe(*stalled, channel);
  for (int i = 0; i < 200; ++i) channel->publish(Instant(Duration(i)), std::string(200'000, 'x'));
  const ClientState state = server_->clients()[0];
  EXPECT_GT(state.streams.at("a").dropped, 100U);
  EXPECT_LE(state.waitingBytes, 2'001'000U);
  std::vector<Instant> times;
  do times.push_back(stalled->expect<MessageData>().time);
  while (times.back() != Instant(Duration(199)));
  EXPECT_EQ(times.size() + state.streams.at("a").dropped, 200U) << "every message is accounted for";
}

TEST_F(ListenerTest, whoAsksAndNeverReadsIsClosed) {
  ServerOptions options;
  options.limits.outbox.controlBytes = 100'000;
  options_.messagesPerSecond = 0;
  start(options);
  server_->updateParameters({{"a", Value{std::string(20'000, 'x')}}});
  const auto client = join({kSdkProtocol, "/", {}, 4096});
  EXPECT_TRUE(eventually([&] {
    client->send(GetParameters{{"a"}, "r"});
    clock_->advance(milliseconds(100));
    return server_->clients().empty();
  }));
  EXPECT_THAT(reports(), testing::ElementsAre(HasSubstr("too slowly")));
}

TEST_F(ListenerTest, aBudgetIsKeptByTheClock) {
  start();
  const auto channel = addChannel(Delivery::kLatest);
  const auto client = join();
  subscribe(*client, channel);
  client->send(SetParameters{{{kBudgetParameter, Value{10'000.0}}}, "r"});
  client->expect<ParameterValues>();
  clock_->advance(seconds(1));
  channel->publish(Instant(Duration(1)), std::string(10'000, 'x'));  // costs a second
  EXPECT_EQ(client->expect<MessageData>().time, Instant(Duration(1)));
  channel->publish(Instant(Duration(2)), std::string("late"));
  client->send(GetParameters{{"none"}, "r"});
  client->expect<ParameterValues>();  // control messages pass
  EXPECT_EQ(server_->clients()[0].streams.at("a").sent, 1U);
  channel->publish(Instant(Duration(3)), std::string("newest"));
  clock_->advance(seconds(1));
  EXPECT_EQ(client->expect<MessageData>().payload, "newest");
}

TEST_F(ListenerTest, whoFloodsIsReadMoreSlowly) {
  options_.messagesPerSecond = 100;
  std::atomic<int> heard{0};
  handlers_.clientMessage = [&](const auto&...) { ++heard; };
  start();
  const auto client = join();
  clock_->advance(seconds(1));
  client->send(ClientAdvertise{{{1, "a", "json", "", "", ""}}});
  for (int i = 0; i < 200; ++i) client->send(ClientMessageData{1, "{}"});
  EXPECT_TRUE(eventually([&] { return heard >= 5; }));
  EXPECT_LE(heard, 12) << "a tenth of a second at once";
  // The clock waits for the listener: a client that is silent for long would be given up.
  for (int due = heard + 10; heard < 200; due += 10) {
    clock_->advance(milliseconds(100));
    ASSERT_TRUE(eventually([&] { return heard >= std::min(due, 200); })) << "nothing is lost";
  }
}

TEST_F(ListenerTest, brokenFramesAndLyingLengthsEndOnlyTheirConnection) {
  start();
  const auto bystander = join();
  const std::string mask = "\x80\x01\x02\x03";
  for (const std::string& bytes :
       {std::string("\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xff", 10) + mask,  // 2^63 bytes
        std::string("\x81\x02{}"),                                           // not masked
        std::string(20, '\xff'), std::string("\x83\x80\x01\x02\x03\x04"),
        std::string("\x81\x81\x01\x02\x03\x04\xfe", 7)}) {  // no UTF-8
    const auto client = join();
    client->sendRaw(bytes);
    EXPECT_EQ(client->receive(), nullptr);
  }
  const auto client = join();
  client->send(Frame{FrameKind::kBinary, "\x02\x01"});
  client->send(Frame{FrameKind::kText, "{\"op\":\"nonsense\"}"});
  EXPECT_THAT(client->expect<Status>().message, HasSubstr("shorter than"));
  EXPECT_THAT(client->expect<Status>().message, HasSubstr("nonsense"));
  bystander->send(GetParameters{{}, "still there"});
  EXPECT_EQ(bystander->expect<ParameterValues>().id, "still there");
}

TEST_F(ListenerTest, messagesThatAreTooLongAreRefused) {
  options_.messageBytes = 100'000;
  options_.textBytes = 10'000;
  start();
  const auto text = join(), binary = join();
  text->send(Frame{FrameKind::kText, std::string(20'000, ' ')});
  EXPECT_THAT(text->closeReason(), HasSubstr("longer than 10000 bytes"));
  binary->send(Frame{FrameKind::kBinary, std::string(200'000, '\x01')});
  EXPECT_EQ(binary->receive(), nullptr);
  EXPECT_TRUE(isAlone());
}

TEST_F(ListenerTest, whoNeverFinishesTheHandshakeIsClosed) {
  options_.handshakes = 4;
  start();
  std::vector<std::thread> slow;
  std::atomic<int> finished{0};
  for (int i = 0; i < 8; ++i)
    slow.emplace_back([&] {
      EXPECT_THAT(talkTcp(port_, "GET / HTTP/1.1\r\nX: "), IsEmpty());
      ++finished;
    });
  // One that connects late is closed late.
  EXPECT_TRUE(eventually([&] {
    clock_->advance(seconds(1));
    return reports().size() >= 4 && finished == 8;
  }));
  EXPECT_THAT(reports(), testing::Each(HasSubstr("handshake took too long")));
  for (std::thread& thread : slow) thread.join();
  EXPECT_EQ(RawClient(port_).status(), 101U);
  EXPECT_THAT(talkTcp(port_, "GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x')), IsEmpty())
      << "headers are bounded";
}

TEST_F(ListenerTest, whatThrowsInItsThreadKeepsNothingElseFromHappening) {
  std::atomic<int> thrown{0};
  handlers_.report = [&](const std::string& sentence) {
    if (sentence.find("took too long") != std::string::npos && ++thrown < 3)
      throw std::runtime_error("no memory");
  };
  start();
  std::atomic<bool> isClosed{false};
  std::thread slow([&] {
    EXPECT_THAT(talkTcp(port_, "GET / HTTP/1.1\r\nX: "), IsEmpty());
    isClosed = true;
  });
  EXPECT_TRUE(eventually([&] {
    clock_->advance(seconds(1));
    return isClosed.load();
  }));
  slow.join();
  EXPECT_GE(thrown, 3);
  EXPECT_EQ(RawClient(port_).status(), 101U);
}

TEST_F(ListenerTest, silentClientsAreAskedForASignOfLifeAndThenGivenUp) {
  start();
  const auto answering = join();
  std::thread reader([&] { answering->receive(); });  // which answers pings
  for (int i = 1; i <= 10; ++i) {
    clock_->advance(seconds(6));
    // The last answer may have come only after the clock was advanced.
    int looks = 0;
    EXPECT_TRUE(eventually([&] {
      if (answering->pings() >= i) return true;
      if (++looks % 200 == 0) clock_->advance(seconds(1));
      return false;
    })) << i;
  }
  listener_.reset();
  reader.join();
  EXPECT_THAT(reports(), IsEmpty()) << "60 s without a message, but not without a sign of life";
  start();
  const auto silent = join();  // does not read, and so does not answer
  EXPECT_TRUE(eventually([&] {
    clock_->advance(milliseconds(500));
    return server_->clients().empty();
  }));
  EXPECT_THAT(reports(), testing::ElementsAre(HasSubstr("it was silent for too long")));
}

TEST_F(ListenerTest, aMessageThatTricklesInIsGivenUp) {
  start();
  const auto client = join();
  client->sendRaw(std::string("\x82\xfe\x10\x00", 4) + "mask" + "abc");
  EXPECT_TRUE(eventually([&] {
    client->sendRaw("x");
    clock_->advance(seconds(1));
    return server_->clients().empty();
  }));
  EXPECT_THAT(reports(), Contains(HasSubstr("took too long")));
}

TEST_F(ListenerTest, greetingsComeLaterThanTheAnswerToTheHandshake) {
  options_.greetingDelay = milliseconds(100);
  start();
  RawClient client(port_);
  ASSERT_EQ(client.status(), 101U);
  EXPECT_EQ(server_->clients()[0].sentBytes, 0U);
  Duration passed{0};
  EXPECT_TRUE(eventually([&] {
    if (server_->clients()[0].sentBytes > 0) return true;
    clock_->advance(milliseconds(1));
    passed += milliseconds(1);
    return false;
  }));
  EXPECT_GE(passed, options_.greetingDelay);
  EXPECT_EQ(client.expect<ServerInfo>().name, "RobotControl");
}

TEST_F(ListenerTest, moreClientsThanAllowedAreRefusedWithASentence) {
  ServerOptions options;
  options.limits.clients = 2;
  start(options);
  const auto x = join(), y = join();
  RawClient z(port_);
  EXPECT_EQ(z.status(), 503U);
  EXPECT_THAT(z.text(), HasSubstr("there are 2 clients already"));
}

TEST_F(ListenerTest, disconnectingAmidEverythingLeavesNothingBehind) {
  handlers_.clientMessage = [](const auto&...) {};
  std::vector<Reply> replies;
  std::mutex repliesMutex;
  start();
  const auto channel = addChannel(Delivery::kLatest);
  server_->addService({0, "s", "S", {}, {}}, [&](const auto&, const auto&, const Reply& reply) {
    const std::lock_guard lock(repliesMutex);
    replies.push_back(reply);
  });
  std::atomic<bool> isOver{false};
  std::thread publisher([&] {
    for (int i = 0; !isOver; ++i) {
      channel->publish(Instant(Duration(i)), std::string(100'000, 'x'));
      server_->updateParameters({{"a", Value{static_cast<double>(i)}}});
      std::this_thread::yield();
    }
  });
  for (int i = 0; i < 20; ++i) {
    const auto client = join();
    client->send(Subscribe{{{1, channel->id()}}});
    client->send(SubscribeParameterUpdates{});
    client->send(SubscribeConnectionGraph{});
    client->send(ClientAdvertise{{{1, "a", "json", "", "", ""}}});
    client->send(ServiceCallRequest{1, 1, "json", "{}"});
    if (i % 2 == 0) client->expect<MessageData>();
    client->cut();
    const std::lock_guard lock(repliesMutex);
    if (!replies.empty()) replies.erase(replies.begin());
  }
  EXPECT_TRUE(isAlone());
  EXPECT_FALSE(channel->isWanted());
  isOver = true;
  publisher.join();
}

TEST_F(ListenerTest, theListenerGoesWhileClientsAreConnectedAndRobotsPublish) {
  std::atomic<int> goings{0};
  handlers_.subscribersChanged = [&](const ChannelPtr&, const std::vector<ClientInfo>& who) {
    goings += who.empty() ? 1 : 0;
  };
  start();
  const auto channel = addChannel(Delivery::kLatest);
  const auto idle = join(), stalled = join({kSdkProtocol, "/", {}, 4096});
  subscribe(*stalled, channel);
  std::atomic<bool> isOver{false};
  std::thread publisher([&] {
    while (!isOver) channel->publish(Instant(), std::string(100'000, 'x')), std::this_thread::yield();
  });
  listener_.reset();
  EXPECT_EQ(goings, 1);
  EXPECT_TRUE(server_->clients().empty());
  idle->closeReason();
  isOver = true;
  publisher.join();
}

/// A TCP connection from another address of this machine, on which nothing is said yet.
int connectFrom(const char* address, std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in from{}, to{};
  from.sin_family = to.sin_family = AF_INET;
  ::inet_pton(AF_INET, address, &from.sin_addr);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  to.sin_port = htons(port);
  const bool isConnected = ::bind(socket, reinterpret_cast<const sockaddr*>(&from), sizeof from) == 0 &&
                           ::connect(socket, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  EXPECT_TRUE(isConnected);
  return socket;
}

TEST_F(ListenerTest, aMachineThatHoldsAllHandshakesDoesNotKeepOthersOut) {
  options_.handshakes = 3;
  start();
  std::vector<int> sockets;
  for (int i = 0; i < 3; ++i) sockets.push_back(connectFrom("127.0.0.2", port_));
  // A fourth of the same machine is closed at once, after which the others are known to be there.
  sockets.push_back(connectFrom("127.0.0.2", port_));
  char byte = 0;
  EXPECT_EQ(::recv(sockets.back(), &byte, 1, 0), 0);
  RawClient other(port_);
  EXPECT_EQ(other.status(), 101U);
  for (const int socket : sockets) ::close(socket);
}

}  // namespace
}  // namespace robotlink::websocket::test
