// SPDX-License-Identifier: GPL-3.0-or-later
// Encryption, over real sockets on loopback.
#include <gmock/gmock.h>
#include <openssl/tls1.h>

#include <thread>

#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/TlsClient.h"

namespace robotlink::websocket::test {
namespace {

using testing::HasSubstr;

class ListenerTlsTest : public testing::Test {
 protected:
  ListenerTlsTest() {
    options_.address.port = 0;
    options_.greetingDelay = Duration::zero();
    options_.clock = clock_;
    options_.certificate = certificate_;
    options_.admission.token = "0123456789abcdef";
    options_.admission.watchToken = "fedcba9876543210";
    listener_ = Listener::open(server_, options_).value();
    port_ = listener_->address().port;
  }
  TlsClient::Options showing(const std::string& token) const { return {"/?token=" + token, {}, 0}; }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  const Certificate certificate_ = makeCertificate("red1").value();
  Listener::Options options_;
  std::atomic<int> sets_{0}, calls_{0};
  std::shared_ptr<Server> server_ =
      Server::make({.name = "red1"}, {.setParameters = [this](auto&&...) { ++sets_; }});
  std::unique_ptr<Listener> listener_;
  std::uint16_t port_ = 0;
};

template <typename Message>
Message expect(TlsClient& client) {
  while (const Frame* frame = client.receive()) {
    const auto message = decodeServerMessage(frame->kind, frame->bytes);
    if (message && std::holds_alternative<Message>(*message)) return std::get<Message>(*message);
  }
  return {};
}

TEST_F(ListenerTlsTest, aClientTalksEncryptedAndSeesTheRobotsCertificate) {
  TlsClient client(port_, showing("0123456789abcdef"));
  ASSERT_EQ(client.status(), 101U);
  EXPECT_EQ(client.version(), "TLSv1.3");
  EXPECT_EQ(client.fingerprint(), certificate_.fingerprint);
  EXPECT_EQ(expect<ServerInfo>(client).name, "red1");
  // Large messages, both ways.
  const auto channel = server_->addChannels({{"a", "json", "", ""}})[0];
  client.send(Subscribe{{{1, channel->id()}}});
  ASSERT_TRUE(eventually([&] { return channel->isWanted(); }));
  const std::string large(3'000'000, 'x');
  channel->publish(Instant(), large);
  EXPECT_EQ(std::string(expect<MessageData>(client).payload), large);
}

TEST_F(ListenerTlsTest, oldVersionsAndRenegotiationAreRefused) {
  EXPECT_FALSE(TlsClient(port_, {"/", {}, TLS1_1_VERSION}).isSecured());
  TlsClient client(port_, {"/?token=0123456789abcdef", {}, TLS1_2_VERSION});
  EXPECT_EQ(client.status(), 101U);
  EXPECT_EQ(client.version(), "TLSv1.2");
  EXPECT_FALSE(client.renegotiates());
}

TEST_F(ListenerTlsTest, withoutEncryptionAClientIsToldToUseIt) {
  const RawClient client(port_, {kSdkProtocol, "/?token=0123456789abcdef"});
  EXPECT_EQ(client.status(), 426U);
  EXPECT_THAT(client.text(), HasSubstr("wss://"));
}

TEST_F(ListenerTlsTest, aWatcherLooksButChangesNothing) {
  const auto service = [this](const char* name, ServiceAccess access) {
    return server_->addService(
        {0, name, "S", {}, {}},
        [this](const auto&, const auto&, const Reply& reply) { ++calls_, reply.succeed("{}"); }, access);
  };
  const auto forControl = service("reset", ServiceAccess::kControl),
             forAll = service("stop", ServiceAccess::kAnybody);
  TlsClient client(port_, showing("fedcba9876543210"));
  ASSERT_EQ(client.status(), 101U);
  expect<ServerInfo>(client);
  client.send(ServiceCallRequest{forControl, 1, "json", "{}"});
  EXPECT_THAT(expect<ServiceCallFailure>(client).message, HasSubstr("only watch"));
  client.send(ServiceCallRequest{forAll, 2, "json", "{}"});
  EXPECT_EQ(expect<ServiceCallResponse>(client).callId, 2U);
  client.send(SetParameters{{{"x", Value{1.0}}}, "p"});
  EXPECT_THAT(expect<Status>(client).message, HasSubstr("only watch"));
  // What concerns only itself it may set.
  client.send(SetParameters{{{kBudgetParameter, Value{5e6}}}, "b"});
  EXPECT_EQ(expect<ParameterValues>(client).id, "p");
  EXPECT_EQ(expect<ParameterValues>(client).parameters.at(0).value, Value{5e6});
  EXPECT_EQ(calls_, 1);
  EXPECT_EQ(sets_, 0);
}

TEST_F(ListenerTlsTest, aHandshakeThatStopsHalfWayEnds) {
  const auto handshake = [this](const std::string& bytes) {
    std::atomic<bool> isOver{false};
    std::thread client([&] { talkTcp(port_, bytes), isOver = true; });
    // First the wait for a byte, then that for the rest.
    while (!isOver) {
      clock_->advance(std::chrono::seconds(1));
      std::this_thread::yield();
    }
    client.join();
    return true;
  };
  EXPECT_TRUE(handshake(""));
  EXPECT_TRUE(handshake(std::string("\x16\x03\x01\x02\x00\x01", 6)));
  EXPECT_TRUE(handshake(std::string("\x16\xff\xff\xff\xff\xff", 6)));
}

TEST_F(ListenerTlsTest, aListenerThatGoesEndsItsConnections) {
  TlsClient client(port_, showing("0123456789abcdef"));
  expect<ServerInfo>(client);
  listener_.reset();
  EXPECT_EQ(client.receive(), nullptr);
  EXPECT_TRUE(server_->clients().empty());
}

}  // namespace
}  // namespace robotlink::websocket::test
