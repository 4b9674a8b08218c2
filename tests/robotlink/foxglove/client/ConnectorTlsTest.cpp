// SPDX-License-Identifier: GPL-3.0-or-later
// The client's end of encryption, over real sockets on loopback.
#include <gmock/gmock.h>

#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/TestFolder.h"

namespace robotlink::websocket::test {
namespace {

using testing::HasSubstr;
using Phase = ConnectionState::Phase;

class ConnectorTlsTest : public testing::Test {
 protected:
  ConnectorTlsTest() { listen(makeCertificate("red1").value()); }
  void listen(const std::optional<Certificate>& certificate) {
    Listener::Options options;
    options.address.port = port_;
    options.certificate = certificate;
    options.admission.token = "0123456789abcdef";
    listener_.reset();
    listener_ = Listener::open(server_, options).value();
    port_ = listener_->address().port;
  }
  /// Connects until it is known whether that succeeds.
  ConnectionState connect(bool isEncrypted = true) {
    Connector::Options options;
    options.url = {isEncrypted, "127.0.0.1", port_, "/"};
    options.token = "0123456789abcdef";
    options.knownServers = folder_.path() / "known";
    options.isTrusted = [this](const std::string& server, const std::string& fingerprint) {
      asked_.push_back(server + " " + fingerprint);
      return trusts_;
    };
    const auto client = std::make_shared<Client>(ClientHandlers());
    const Connector connector(client, options);
    EXPECT_TRUE(eventually([&] {
      const ConnectionState state = client->state();
      return state.phase == Phase::kConnected || !state.reason.empty();
    }));
    return client->state();
  }
  void expectConnected() {
    const ConnectionState state = connect();
    EXPECT_EQ(state.phase, Phase::kConnected) << state.reason;
  }

  const TestFolder folder_;
  const std::shared_ptr<Server> server_ = Server::make({.name = "red1"}, {});
  std::unique_ptr<Listener> listener_;
  std::uint16_t port_ = 0;
  std::vector<std::string> asked_;
  bool trusts_ = true;
};

TEST_F(ConnectorTlsTest, aRobotIsBelievedOnceAndKnownAfterwards) {
  expectConnected();
  ASSERT_EQ(asked_.size(), 1U);
  EXPECT_THAT(asked_[0], HasSubstr("127.0.0.1:" + std::to_string(port_) + " SHA256:"));
  trusts_ = false;
  expectConnected();
  EXPECT_EQ(asked_.size(), 1U);
}

TEST_F(ConnectorTlsTest, aRobotThatIsNotBelievedIsNotConnected) {
  trusts_ = false;
  const ConnectionState state = connect();
  EXPECT_EQ(state.phase, Phase::kRefused);
  EXPECT_THAT(state.reason, HasSubstr("never seen before; its fingerprint is SHA256:"));
  EXPECT_EQ(state.objection.kind, ServerObjection::Kind::kNewCertificate);
  EXPECT_EQ(asked_.front(), state.objection.server + " " + state.objection.fingerprint);
  EXPECT_TRUE(KnownServers(folder_.path() / "known").read().value().empty());
}

TEST_F(ConnectorTlsTest, anotherCertificateAtTheSamePlaceIsRefused) {
  expectConnected();
  listen(makeCertificate("red1").value());
  const ConnectionState state = connect();
  EXPECT_EQ(state.phase, Phase::kRefused);
  EXPECT_THAT(state.reason, HasSubstr("is not the one that was there before"));
  EXPECT_EQ(state.objection.kind, ServerObjection::Kind::kOtherCertificate);
  EXPECT_EQ(asked_.front(), state.objection.server + " " + state.objection.knownFingerprint);
  EXPECT_NE(state.objection.fingerprint, state.objection.knownFingerprint);
  EXPECT_EQ(asked_.size(), 1U);
}

TEST_F(ConnectorTlsTest, whoDoesNotEncryptIsToldAndSoIsWhoDoes) {
  EXPECT_THAT(connect(false).reason, HasSubstr("wss://"));
  listen({});
  EXPECT_THAT(connect().reason, HasSubstr("ws://"));
}

}  // namespace
}  // namespace robotlink::websocket::test
