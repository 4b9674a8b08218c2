// SPDX-License-Identifier: GPL-3.0-or-later
// What a line carries of messages that repeat themselves.
#include <gmock/gmock.h>

#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/Eventually.h"
#include "tests/robotlink/foxglove/RawClient.h"
#include "tests/robotlink/foxglove/Relay.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// A server with a channel of states and one of images, and a line to it that counts.
class CompressionTest : public testing::Test {
 protected:
  void listen(bool compresses) {
    server_ = Server::make({.name = "red1"}, {});
    ChannelSetup states{"states", "json", "", ""}, images{"images", "json", "", ""};
    states.delivery = Delivery::kComplete;
    images.isCompressible = false;
    const auto channels = server_->addChannels({states, images});
    states_ = channels[0];
    images_ = channels[1];
    Listener::Options options;
    options.address.port = 0;
    options.greetingDelay = Duration::zero();
    options.compressesLoopback = compresses;
    listener_ = *Listener::open(server_, options);
    relay_ = std::make_unique<Relay>(listener_->address().port, Relay::Line());
    options_.url = {false, "127.0.0.1", relay_->port(), "/"};
  }
  void connect() {
    ClientHandlers handlers;
    handlers.message = [this](const Channel& channel, Instant, std::string_view payload) {
      const std::lock_guard lock(mutex_);
      (channel.topic == "states" ? stateHeard_ : imageHeard_) = payload;
    };
    client_ = std::make_shared<Client>(std::move(handlers));
    client_->subscribe({"states", "images"});
    connector_ = std::make_unique<Connector>(client_, options_);
    ASSERT_TRUE(eventually([&] { return states_->isWanted() && images_->isWanted(); }));
  }
  /// How many bytes the line carries until the text was heard.
  std::size_t cost(const ChannelPtr& channel, const std::string& heard, const std::string& text) {
    const std::size_t before = relay_->carriedBytes();
    channel->publish(Instant(1s), text);
    EXPECT_TRUE(eventually([&] {
      const std::lock_guard lock(mutex_);
      return heard == text;
    }));
    return relay_->carriedBytes() - before;
  }

  Connector::Options options_;
  std::shared_ptr<Server> server_;
  ChannelPtr states_, images_;
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<Relay> relay_;
  std::mutex mutex_;
  std::string stateHeard_, imageHeard_;
  std::shared_ptr<Client> client_;
  std::unique_ptr<Connector> connector_;
};

std::string namesOfFrames(int first) {
  std::string text;
  for (int i = first; i < first + 1000; ++i) text += "red1/camera/link" + std::to_string(i) + ", ";
  return text;
}

TEST_F(CompressionTest, otherMachinesAreSentAllButImagesCompressed) {
  listen(true);
  connect();
  const std::string names = namesOfFrames(0);
  EXPECT_LT(cost(states_, stateHeard_, names), names.size() / 3);
  // The line knows the names by now, as those of frames and joints, which come again and again.
  const std::string again = "again: " + names;
  EXPECT_LT(cost(states_, stateHeard_, again), names.size() / 20);
  EXPECT_GE(cost(images_, imageHeard_, names), names.size());
  EXPECT_LT(cost(states_, stateHeard_, namesOfFrames(2000)), names.size() / 3) << "also behind an image";
}

TEST_F(CompressionTest, onLoopbackNothingIsCompressed) {
  listen(false);
  connect();
  const std::string names = namesOfFrames(0);
  EXPECT_GE(cost(states_, stateHeard_, names), names.size());
}

TEST_F(CompressionTest, clientsThatCannotDoItGetTheMessagesAsTheyAre) {
  listen(true);
  RawClient client(relay_->port());
  const auto channel = client.expect<Advertise>().channels.at(0);
  client.send(Subscribe{{{7, channel.id}}});
  ASSERT_TRUE(eventually([&] { return states_->isWanted(); }));
  states_->publish(Instant(1s), namesOfFrames(0));
  EXPECT_EQ(client.expect<MessageData>().payload, namesOfFrames(0));
}

TEST_F(CompressionTest, whatIsTooLongWhenUnpackedIsRefusedWithoutUnpackingAll) {
  listen(true);
  options_.messageBytes = 1U << 20U;
  connect();
  states_->publish(Instant(1s), std::string(3U << 20U, 'x'));
  EXPECT_TRUE(eventually([&] { return client_->state().phase == ConnectionState::Phase::kRefused; }));
  EXPECT_THAT(client_->state().reason, HasSubstr("more than 1 MiB"));
  EXPECT_TRUE(stateHeard_.empty());
  EXPECT_LT(relay_->carriedBytes(), 1U << 20U);
}

}  // namespace
}  // namespace robotlink::websocket::test
