// SPDX-License-Identifier: GPL-3.0-or-later
// A session whose other end is no program of ours, such as a bridge of ROS.
#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/SessionClient.h"
#include "tests/Eventually.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

/// The channels of the server, by their places.
enum Channels { kBattery, kTexts, kCamera, kCloud, kScan, kOldScan, kOldTexts };

class ForeignServerTest : public testing::Test {
 protected:
  ForeignServerTest() {
    Listener::Options listening;
    listening.address.port = 0;
    listener_ = *Listener::open(server_, listening);
    SessionClient::Options options;
    options.connection.url = {false, "127.0.0.1", listener_->address().port, "/"};
    client_ = std::make_unique<SessionClient>(session_, options);
  }

  bool soon(const std::function<bool()>& condition) {
    return eventually([&] {
      client_->tick();
      session_.tick();
      return condition();
    });
  }
  bool isSubscribed(Channels channel) {
    return soon([&] { return channels_[channel]->isWanted(); });
  }
  /// The newest message of a stream as a text; empty if there is none.
  std::string shown(const std::string& stream) {
    const auto* message = session_.store().latest("foxglove_bridge/" + stream, Instant::max());
    return message == nullptr ? std::string() : message->value->ShortDebugString();
  }
  bool shows(const std::string& stream, const std::string& text) {
    return soon([&] { return shown(stream).find(text) != std::string::npos; });
  }

  const std::shared_ptr<Server> server_ = Server::make({.name = "foxglove bridge"}, {});
  const std::vector<ChannelPtr> channels_ =
      server_->addChannels({{"/battery", "json", "Battery",
                             R"({"type":"object","properties":{"volts":{"type":"number"}}})", "jsonschema"},
                            {"/rosout", "protobuf", "foxglove.Log", "", "protobuf"},
                            {"/camera", "protobuf", "foxglove.RawImage", "", "protobuf"},
                            {"/cloud", "flatbuffer", "foxglove.PointCloud", "table", "flatbuffer"},
                            {"/scan/width", "cdr", "std_msgs/msg/UInt32", "uint32 data"},
                            {"/old/width", "ros1", "std_msgs/UInt32", "uint32 data", "ros1msg"},
                            {"/status", "ros1", "rosgraph_msgs/Log", "string msg", "ros1msg"}});
  std::unique_ptr<Listener> listener_;
  Session session_;
  std::unique_ptr<SessionClient> client_;
};

TEST_F(ForeignServerTest, isOneRobotWhoseMessagesAreDecoded) {
  EXPECT_TRUE(isSubscribed(kBattery) && isSubscribed(kTexts));
  EXPECT_THAT(client_->robots(), ElementsAre("foxglove_bridge"));
  channels_[kBattery]->publish(Instant(1s), R"({"volts": 11.5})");
  foxglove::Log text;
  text.set_message("hello");
  channels_[kTexts]->publish(Instant(1s), text.SerializeAsString());
  EXPECT_TRUE(shows("battery", "11.5"));
  EXPECT_TRUE(shows("log", "hello"));
}

TEST_F(ForeignServerTest, messagesOfRosAreDecoded) {
  EXPECT_TRUE(isSubscribed(kScan) && isSubscribed(kOldScan) && isSubscribed(kOldTexts));
  channels_[kScan]->publish(Instant(1s), std::string("\0\1\0\0\7\0\0\0", 8));
  channels_[kOldScan]->publish(Instant(1s), std::string("\10\0\0\0", 4));
  EXPECT_TRUE(shows("scan/width", "data: 7")) << shown("scan/width");
  EXPECT_TRUE(shows("old/width", "data: 8")) << shown("old/width");
  channels_[kOldTexts]->publish(Instant(2s), std::string("\2\0\0\0hi", 6));
  EXPECT_TRUE(shows("log", "\"hi\"")) << "texts of ROS are where all texts are: " << shown("log");
}

TEST_F(ForeignServerTest, imagesAreSwitchedOnLikeDebugKeys) {
  EXPECT_TRUE(isSubscribed(kBattery));
  EXPECT_FALSE(channels_[kCamera]->isWanted());
  robotcontrol::Request request;
  request.set_robot("foxglove_bridge");
  request.mutable_set_key()->set_name("channel/camera");
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  client_->request(request);
  EXPECT_TRUE(isSubscribed(kCamera));
}

TEST_F(ForeignServerTest, whatCannotBeDecodedIsListed) {
  EXPECT_TRUE(isSubscribed(kBattery));
  EXPECT_FALSE(channels_[kCloud]->isWanted());
  const auto streams = client_->streams();
  ASSERT_EQ(streams.size(), 7U);
  EXPECT_EQ(streams[2].encoding, "flatbuffer");
  EXPECT_FALSE(streams[2].isDecoded);
  EXPECT_TRUE(streams[0].isDecoded);
}

}  // namespace
}  // namespace robotlink::websocket::test
