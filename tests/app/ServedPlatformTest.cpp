// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ServedPlatform.h"

#include <gmock/gmock.h>

#include <atomic>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/core/simulated/SimulatedRun.h"
#include "app/core/simulated/SimulationFeed.h"
#include "foxglove/Image.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/foxglove/server/Listener.h"
#include "tests/robotlink/foxglove/RawClient.h"

namespace app {
namespace {

using robotlink::websocket::Advertise;
using robotlink::websocket::AdvertiseServices;
using robotlink::websocket::Channel;
using robotlink::websocket::Frame;
using robotlink::websocket::Listener;
using robotlink::websocket::MessageData;
using robotlink::websocket::Server;
using robotlink::websocket::ServerMessage;
using robotlink::websocket::Service;
using robotlink::websocket::ServiceCallRequest;
using robotlink::websocket::ServiceCallResponse;
using robotlink::websocket::Subscribe;
using robotlink::websocket::test::RawClient;
using testing::HasSubstr;

/// A stream that tells when its first line is complete.
class FirstLine : public std::stringbuf {
 public:
  std::string wait() { return line_.get_future().get(); }

 protected:
  int sync() override {
    if (!isTold_ && str().find('\n') != std::string::npos) {
      isTold_ = true;
      line_.set_value(str());
    }
    return 0;
  }

 private:
  std::promise<std::string> line_;
  bool isTold_ = false;
};

/// A served simulation of the usual field, and a client of it.
class ServedPlatformTest : public testing::Test {
 protected:
  ServedPlatformTest() {
    const std::string line = printed_.wait();
    client_ =
        std::make_unique<RawClient>(static_cast<std::uint16_t>(std::stoi(line.substr(line.rfind(':') + 1))));
    while (!channels_.contains("red1/camera/image") || !services_.contains("red1/stop")) hear();
  }
  ~ServedPlatformTest() override {
    interrupted_ = true;
    EXPECT_TRUE(served_.get().empty());
  }
  /// Notes what a message advertises, and returns it; its payload is valid until the next one.
  ServerMessage hear() {
    const Frame* frame = client_->receive();
    if (frame == nullptr) throw std::runtime_error("the connection was closed");
    ServerMessage message = decodeServerMessage(frame->kind, frame->bytes).value();
    if (const auto* offered = std::get_if<Advertise>(&message)) {
      for (const Channel& channel : offered->channels) channels_[channel.topic] = channel.id;
    } else if (const auto* services = std::get_if<AdvertiseServices>(&message)) {
      for (const Service& service : services->services) services_[service.name] = service.id;
    }
    return message;
  }
  template <typename Message>
  Message expect() {
    while (true) {
      const ServerMessage message = hear();
      if (const auto* found = std::get_if<Message>(&message)) return *found;
    }
  }

  FirstLine printed_;
  std::ostream out_{&printed_};
  logplayer::Recorder recorder_{{}};
  std::atomic<bool> interrupted_{false};
  std::future<robotlink::Errors> served_ = std::async(std::launch::async, [this] {
    return serve(
        SimulationFeed::opening(defaultSimulation()), {}, recorder_, [this] { return interrupted_.load(); },
        out_);
  });
  std::unique_ptr<RawClient> client_;
  std::map<std::string, std::uint64_t> channels_;
  std::map<std::string, std::uint32_t> services_;
};

TEST_F(ServedPlatformTest, imagesComeWhileSomebodySubscribesToThem) {
  client_->send(Subscribe{{{1, channels_["red1/camera/image"]}}});
  const auto first = expect<MessageData>();
  foxglove::RawImage image;
  ASSERT_TRUE(image.ParseFromString(std::string(first.payload)));
  EXPECT_EQ(image.width(), 176U);
  const auto time = first.time;
  EXPECT_GT(expect<MessageData>().time, time);
}

TEST_F(ServedPlatformTest, stopActsAtThePlatform) {
  client_->send(ServiceCallRequest{services_["red1/stop"], 5, "json", R"({"engaged": true})"});
  const auto answer = expect<ServiceCallResponse>();
  EXPECT_EQ(nlohmann::json::parse(answer.payload)["accepted"], true);
  client_->send(Subscribe{{{1, channels_["simulation"]}}});
  robotcontrol::SimulationStatus status;
  ASSERT_TRUE(status.ParseFromString(std::string(expect<MessageData>().payload)));
  EXPECT_THAT(status.stopped_robots(), testing::ElementsAre("red1"));
  EXPECT_TRUE(status.running());
}

TEST(ServedPlatform, whatCannotBeOpenedEndsWithTheReason) {
  logplayer::Recorder recorder({});
  std::ostringstream out;
  RunOptions run = defaultSimulation();
  run.scene = "no-such-scene.sdf";
  const auto errors = serve(
      SimulationFeed::opening(run), {}, recorder, [] { return false; }, out);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front().describe(), HasSubstr("no-such-scene.sdf"));
}

TEST(ServedPlatform, aPortThatIsTakenIsNamed) {
  logplayer::Recorder recorder({});
  std::ostringstream out;
  const auto server = Server::make({}, {});
  const auto listener = Listener::open(server, {.address = {"127.0.0.1", 0}});
  ASSERT_TRUE(listener);
  const auto errors = serve(
      SimulationFeed::opening(defaultSimulation()), {.address = (*listener)->address()}, recorder,
      [] { return false; }, out);
  ASSERT_FALSE(errors.empty());
  EXPECT_THAT(errors.front().text, HasSubstr(std::to_string((*listener)->address().port)));
}

}  // namespace
}  // namespace app
