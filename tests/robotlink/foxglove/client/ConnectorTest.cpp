// SPDX-License-Identifier: GPL-3.0-or-later
// Over real sockets on loopback.
#include "robotlink/foxglove/client/Connector.h"

#include <gmock/gmock.h>

#include <atomic>
#include <stdexcept>

#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/PlainServer.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Phase = ConnectionState::Phase;

class ConnectorTest : public testing::Test {
 protected:
  void listen(std::string token = {}, std::uint16_t port = 0) {
    ServerHandlers handlers;
    handlers.report = [this](const std::string& sentence) {
      const std::lock_guard lock(mutex_);
      reported_ += sentence + "\n";
    };
    server_ = Server::make({.name = "red1", .limits = limits_}, std::move(handlers));
    channel_ = server_->addChannels({{"a", "json", "", ""}})[0];
    Listener::Options options;
    options.address.port = port;
    options.admission.token = std::move(token);
    options.admission.wrongTokenDelay = Duration::zero();
    options.greetingDelay = Duration::zero();
    options.messageBytes = takenBytes_;
    auto listener = Listener::open(server_, options);
    ASSERT_TRUE(listener) << listener.error().text;
    listener_ = *std::move(listener);
    options_.url = {false, "127.0.0.1", listener_->address().port, "/"};
  }
  void connect() {
    ClientHandlers handlers;
    handlers.message = [this](const Channel&, Instant, std::string_view payload) {
      const std::lock_guard lock(mutex_);
      newest_ = payload;
    };
    client_ = std::make_shared<Client>(std::move(handlers));
    client_->subscribe({"a"});
    connector_ = std::make_unique<Connector>(client_, options_);
  }
  bool reaches(Phase phase) {
    return eventually([&] { return client_->state().phase == phase; });
  }
  std::string reason() {
    EXPECT_TRUE(eventually([&] { return !client_->state().reason.empty(); }));
    return client_->state().reason;
  }
  bool receives(const std::string& text) {
    return eventually([&] {
      channel_->publish(Instant(1s), text);
      const std::lock_guard lock(mutex_);
      return newest_ == text;
    });
  }

  std::string reported() {
    const std::lock_guard lock(mutex_);
    return reported_;
  }

  Connector::Options options_;
  ServerLimits limits_;
  std::size_t takenBytes_ = Listener::Options().messageBytes;
  /// Both are protected by the mutex.
  std::mutex mutex_;
  std::string reported_;
  std::shared_ptr<Server> server_;
  std::unique_ptr<Listener> listener_;
  ChannelPtr channel_;
  std::shared_ptr<Client> client_;
  std::unique_ptr<Connector> connector_;
  std::string newest_;
};

TEST_F(ConnectorTest, itConnectsAndMeasuresTheRoundTrip) {
  listen();
  options_.times.pingInterval = 10ms;
  connect();
  EXPECT_TRUE(reaches(Phase::kConnected));
  EXPECT_TRUE(receives("hello"));
  EXPECT_TRUE(eventually([&] { return client_->state().roundTrip.has_value(); }));
  EXPECT_EQ(client_->state().serverName, "red1");
  EXPECT_GT(client_->state().bytes, 100U);
}

TEST_F(ConnectorTest, aServerThatComesBackIsFoundWithEverythingAskedForBefore) {
  listen();
  options_.times.retryTime = 10ms;
  connect();
  EXPECT_TRUE(receives("1"));
  const std::uint16_t port = listener_->address().port;
  listener_.reset();
  EXPECT_TRUE(reaches(Phase::kConnecting));
  EXPECT_TRUE(
      eventually([&] { return client_->state().reason.find("nothing is listening") != std::string::npos; }));
  listen("", port);
  EXPECT_TRUE(receives("2"));
  EXPECT_EQ(client_->state().connections, 2U);
}

TEST_F(ConnectorTest, aHandlerThatThrowsCostsOnlyTheConnection) {
  listen();
  options_.times.retryTime = 10ms;
  ClientHandlers handlers;
  handlers.message = [this](const Channel&, Instant, std::string_view payload) {
    if (payload == "bad") throw std::runtime_error("no memory");
    const std::lock_guard lock(mutex_);
    newest_ = payload;
  };
  client_ = std::make_shared<Client>(std::move(handlers));
  client_->subscribe({"a"});
  connector_ = std::make_unique<Connector>(client_, options_);
  ASSERT_TRUE(receives("1"));
  channel_->publish(Instant(1s), "bad");
  EXPECT_TRUE(eventually([&] { return client_->state().connections == 2; }));
  EXPECT_TRUE(receives("2"));
}

TEST_F(ConnectorTest, aWrongTokenIsSaidAndARightOneIsShown) {
  listen("secret");
  connect();
  EXPECT_TRUE(reaches(Phase::kRefused));
  EXPECT_THAT(reason(), AllOf(HasSubstr("the robot requires a token"), HasSubstr("HTTP 401")));
  EXPECT_EQ(client_->state().objection.kind, ServerObjection::Kind::kToken);
  connector_.reset();
  options_.token = "wrong";
  connect();
  EXPECT_TRUE(reaches(Phase::kRefused));
  EXPECT_THAT(reason(), AllOf(HasSubstr("a different token"), HasSubstr("HTTP 401")));
  connector_.reset();
  options_.token = "secret";
  connect();
  EXPECT_TRUE(reaches(Phase::kConnected));
}

TEST_F(ConnectorTest, aTokenOfSeveralLinesIsNotSent) {
  listen("secret");
  options_.token = "Whoever\nsecret";
  connect();
  EXPECT_TRUE(reaches(Phase::kRefused));
  EXPECT_THAT(reason(), HasSubstr("without spaces and line breaks"));
  EXPECT_EQ(client_->state().objection.kind, ServerObjection::Kind::kToken);
}

TEST_F(ConnectorTest, aServerWithTooManyClientsIsNamedAsLongAsItRefuses) {
  limits_.clients = 0;
  listen();
  connect();
  EXPECT_TRUE(reaches(Phase::kRefused));
  EXPECT_THAT(reason(), AllOf(HasSubstr("too many clients"), HasSubstr("HTTP 503")));
  EXPECT_TRUE(eventually([&] { return reported().find("was refused") != std::string::npos; }));
}

TEST_F(ConnectorTest, aServerThatSendsMessagesThatAreTooLongIsRefused) {
  options_.messageBytes = 2U << 20U;
  options_.times.refusedTime = 1h;
  listen();
  connect();
  ASSERT_TRUE(reaches(Phase::kConnected));
  EXPECT_TRUE(eventually([&] {
    channel_->publish(Instant(1s), std::string(3U << 20U, 'x'));
    return client_->state().phase == Phase::kRefused;
  }));
  EXPECT_THAT(reason(), HasSubstr("more than 2 MiB"));
}

TEST_F(ConnectorTest, whatIsTooLongForTheServerIsNamedAtBothEnds) {
  options_.times.retryTime = 1h;
  takenBytes_ = 1000;
  listen();
  connect();
  ASSERT_TRUE(reaches(Phase::kConnected));
  client_->setParameters({{"a", Value{Value::Bytes(2000)}}});
  EXPECT_TRUE(reaches(Phase::kConnecting));
  EXPECT_THAT(reason(), HasSubstr("longer than it accepts"));
  EXPECT_TRUE(eventually([&] { return reported().find("longer than 1000 bytes") != std::string::npos; }));
}

TEST_F(ConnectorTest, whatIsNoFoxgloveServerIsNamed) {
  const PlainServer other("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nhi");
  options_.url = {false, "127.0.0.1", other.port(), "/"};
  connect();
  EXPECT_TRUE(reaches(Phase::kRefused));
  EXPECT_THAT(reason(), HasSubstr("HTTP 200: hi"));
  connector_.reset();
  const PlainServer noise("SSH-2.0-OpenSSH\r\n");
  options_.url.port = noise.port();
  connect();
  EXPECT_THAT(reason(), HasSubstr("is this the robot's port?"));
}

TEST_F(ConnectorTest, aHostThatIsNotThereIsNamed) {
  options_.url = {false, "no-such-robot.invalid", 8765, "/"};
  connect();
  EXPECT_THAT(reason(), HasSubstr("there is no machine named 'no-such-robot.invalid'"));
}

/// Names that are found when the test says so.
class SlowNames {
 public:
  SlowNames() = default;
  ~SlowNames() { finish(); }
  SlowNames(const SlowNames&) = delete;
  SlowNames& operator=(const SlowNames&) = delete;

  HostLookup::Resolver resolver() {
    return [state = state_](const std::string&) -> HostLookup::Outcome {
      ++state->asked;
      state->mayFinish.wait(false);
      return std::vector<std::string>{"127.0.0.1"};
    };
  }
  void finish() {
    state_->mayFinish = true;
    state_->mayFinish.notify_all();
  }
  void begin() { state_->mayFinish = false; }
  int asked() const { return state_->asked; }

 private:
  struct State {
    std::atomic<bool> mayFinish{false};
    std::atomic<int> asked{0};
  };
  // Shared with threads that nobody waits for.
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

TEST_F(ConnectorTest, aNameThatIsFoundLateIsAskedForOnceAndConnected) {
  listen();
  SlowNames names;
  const auto clock = std::make_shared<ManualClock>();
  options_.url.host = "red1";
  options_.resolver = names.resolver();
  options_.clock = clock;
  connect();
  ASSERT_TRUE(eventually([&] { return names.asked() == 1; }));
  clock->advance(10s);
  EXPECT_THAT(reason(), HasSubstr("the name of the robot"));
  // It is given up, but the system is not asked a second time meanwhile.
  clock->advance(25s);
  EXPECT_TRUE(
      eventually([&] { return client_->state().reason.find("check the name") != std::string::npos; }));
  clock->advance(1s);
  names.finish();
  EXPECT_TRUE(reaches(Phase::kConnected));
  EXPECT_EQ(names.asked(), 1);
}

TEST_F(ConnectorTest, afterACutTheAddressIsKnownThoughTheNameIsNotFoundMeanwhile) {
  listen();
  SlowNames names;
  names.finish();
  options_.url.host = "red1";
  options_.resolver = names.resolver();
  options_.times.retryTime = 10ms;
  connect();
  EXPECT_TRUE(receives("1"));
  names.begin();
  const std::uint16_t port = listener_->address().port;
  listener_.reset();
  EXPECT_TRUE(reaches(Phase::kConnecting));
  listen("", port);
  EXPECT_TRUE(receives("2"));
  EXPECT_EQ(names.asked(), 2);
}

TEST_F(ConnectorTest, goingDoesNotWaitForAName) {
  listen();
  SlowNames names;
  options_.url.host = "red1";
  options_.resolver = names.resolver();
  connect();
  ASSERT_TRUE(eventually([&] { return names.asked() == 1; }));
  connector_.reset();
  EXPECT_EQ(client_->state().phase, Phase::kConnecting);
}

TEST_F(ConnectorTest, goingNeverWaits) {
  const PlainServer silent("");
  options_.url = {false, "127.0.0.1", silent.port(), "/"};
  connect();
  const auto begin = std::chrono::steady_clock::now();
  connector_.reset();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace robotlink::websocket::test
