// SPDX-License-Identifier: GPL-3.0-or-later
// Servers that know nothing of this program, such as foxglove_bridge, as robots of a session.
#include <gmock/gmock.h>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/server/Listener.h"
#include "robotlink/foxglove/session/remote/SessionClient.h"
#include "tests/Eventually.h"

namespace robotlink::websocket::test {
namespace {

using namespace std::chrono_literals;
using robotcontrol::KeyMode;
using robotcontrol::ProcessTable;
using robotcontrol::Request;
using testing::ElementsAre;
using testing::HasSubstr;

class ForeignServerTest : public testing::Test {
 protected:
  void SetUp() override {
    channels_ =
        server_->addChannels({{"/battery", "json", "Battery",
                               R"({"type":"object","properties":{"volts":{"type":"number"}}})", "jsonschema"},
                              {"/rosout", "protobuf", "foxglove.Log", "", "protobuf"},
                              {"/camera", "protobuf", "foxglove.RawImage", "", "protobuf"},
                              {"/cloud", "flatbuffer", "foxglove.PointCloud", "table", "flatbuffer"},
                              {"/scan/width", "cdr", "std_msgs/msg/UInt32", "uint32 data"},
                              {"/old/width", "ros1", "std_msgs/UInt32", "uint32 data", "ros1msg"},
                              {"/status", "ros1", "rosgraph_msgs/Log", "string msg", "ros1msg"},
                              {"/tf", "protobuf", "foxglove.FrameTransforms", "", "protobuf"}});
    Listener::Options listening;
    listening.address.port = 0;
    listener_ = *Listener::open(server_, listening);
    SessionClient::Options options;
    options.connection.url = {false, "127.0.0.1", listener_->address().port, "/"};
    client_ = std::make_unique<SessionClient>(session_, options);
  }
  template <typename Condition>
  bool soon(const Condition& condition) {
    return eventually([&] {
      client_->tick();
      session_.tick();
      return condition();
    });
  }
  std::string shown(const std::string& stream) {
    const auto* message = session_.store().latest("foxglove_bridge/" + stream, Instant::max());
    return message == nullptr ? std::string() : message->value->ShortDebugString();
  }
  bool publishText(const std::string& text) {
    foxglove::Log log;
    log.set_message(text);
    channels_[1]->publish(Instant(1s), log.SerializeAsString());
    return soon([&] { return shown("log").find(text) != std::string::npos; });
  }

  Session session_;
  std::shared_ptr<Server> server_ = Server::make({.name = "foxglove bridge"}, {});
  std::vector<ChannelPtr> channels_;
  std::unique_ptr<Listener> listener_;
  std::unique_ptr<SessionClient> client_;
};

TEST_F(ForeignServerTest, isOneRobotWhoseMessagesAreDecoded) {
  EXPECT_TRUE(soon([&] { return channels_[0]->isWanted() && channels_[1]->isWanted(); }));
  EXPECT_THAT(client_->robots(), ElementsAre("foxglove_bridge"));
  EXPECT_FALSE(channels_[2]->isWanted());
  EXPECT_FALSE(channels_[3]->isWanted());
  channels_[0]->publish(Instant(1s), R"({"volts": 11.5})");
  EXPECT_TRUE(publishText("hello"));
  EXPECT_TRUE(soon([&] { return shown("battery") != ""; }));
  EXPECT_TRUE(soon([&] { return channels_[4]->isWanted() && channels_[5]->isWanted(); }));
  channels_[4]->publish(Instant(1s), std::string("\0\1\0\0\7\0\0\0", 8));
  channels_[5]->publish(Instant(1s), std::string("\10\0\0\0", 4));
  EXPECT_TRUE(soon([&] { return shown("scan/width") == "data: 7" && shown("old/width") == "data: 8"; }))
      << shown("scan/width") << shown("old/width");
  EXPECT_TRUE(soon([&] { return channels_[6]->isWanted(); }));
  channels_[6]->publish(Instant(2s), std::string("\2\0\0\0hi", 6));
  EXPECT_TRUE(soon([&] { return shown("log").find("\"hi\"") != std::string::npos; }))
      << "texts of ROS are where all texts are: " << shown("log");
}

TEST_F(ForeignServerTest, transformsKeepTheirPathSinceTheirFramesAreNotThoseOfTheScene) {
  ASSERT_TRUE(soon([&] { return channels_[7]->isWanted(); }));
  foxglove::FrameTransforms transforms;
  transforms.add_transforms()->set_child_frame_id("odom");
  channels_[7]->publish(Instant(1s), transforms.SerializeAsString());
  EXPECT_TRUE(soon([&] { return shown("tf").find("odom") != std::string::npos; }));
  EXPECT_EQ(session_.store().find("transforms"), nullptr);
}

TEST_F(ForeignServerTest, imagesAreSwitchedOnLikeDebugKeys) {
  EXPECT_TRUE(soon([&] { return channels_[0]->isWanted(); }));
  Request request;
  request.set_robot("foxglove_bridge");
  request.mutable_set_key()->set_name("channel/camera");
  request.mutable_set_key()->mutable_mode()->set_kind(KeyMode::ALWAYS);
  client_->request(request);
  EXPECT_TRUE(soon([&] { return channels_[2]->isWanted(); }));
}

TEST_F(ForeignServerTest, whatIsNotDecodedIsNamedOnce) {
  EXPECT_TRUE(soon([&] {
    return shown("log").find("not decoded here: /cloud (flatbuffer)") != std::string::npos;
  })) << shown("log");
  const auto streams = client_->streams();
  ASSERT_EQ(streams.size(), 8U);
  EXPECT_EQ(streams[2].encoding, "flatbuffer");
  EXPECT_FALSE(streams[2].isDecoded);
  EXPECT_TRUE(streams[0].isDecoded);
  // For another one, only that is news.
  server_->addChannels({{"/odd", "msgpack", "Odd", "", ""}});
  EXPECT_TRUE(soon([&] {
    return shown("log").find("not decoded here: /odd (msgpack)") != std::string::npos;
  })) << shown("log");
}

TEST_F(ForeignServerTest, itsNodesAreProcesses) {
  server_->setConnectionGraph(
      {{{"/battery", {"/driver"}}}, {{"/battery", {"/planner", "/monitor"}}, {"/goal", {"/planner"}}}, {}});
  const auto table = [this] {
    const auto* newest =
        session_.store().latestAs<ProcessTable>("foxglove_bridge/tables/processes", Instant::max());
    return newest == nullptr ? ProcessTable() : *newest;
  };
  EXPECT_TRUE(soon([&] { return table().processes_size() == 3; }));
  const ProcessTable all = table();
  EXPECT_EQ(all.processes(0).name(), "/driver");
  ASSERT_EQ(all.processes(0).senders_size(), 1);
  EXPECT_EQ(all.processes(0).senders(0).type(), "Battery");
  EXPECT_EQ(all.processes(1).name(), "/planner");
  ASSERT_EQ(all.processes(1).receivers_size(), 2);
  EXPECT_EQ(all.processes(1).receivers(0).peer(), "/driver");
  EXPECT_EQ(all.processes(1).receivers(1).package(), "/goal");
  EXPECT_EQ(all.processes(1).receivers(1).peer(), "");
  // A node that ends is not shown any more.
  server_->setConnectionGraph({{{"/battery", {"/driver"}}}, {{"/battery", {"/monitor"}}}, {}});
  EXPECT_TRUE(soon([&] { return table().processes_size() == 2; }));
  server_->setConnectionGraph({});
  EXPECT_TRUE(soon([&] { return table().processes_size() == 0; }));
}

}  // namespace
}  // namespace robotlink::websocket::test
