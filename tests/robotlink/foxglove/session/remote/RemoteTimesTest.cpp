// SPDX-License-Identifier: GPL-3.0-or-later
// The times in the session of messages that are latched at the server, some since before a reset.
#include <gtest/gtest.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using robotcontrol::KeyTable;

class RemoteTimesTest : public testing::Test {
 protected:
  void begin(SessionClientOptions options = {}) {
    remote_.emplace(session_, std::move(options));
    remote_->onConnected({"", {}, {}, {{kSessionKey, "1"}}, "1", {}, {}});
    remote_->robots.add("red1", "red1");
  }
  template <typename Message>
  void hear(const std::string& path, Instant time) {
    const Channel channel{1, path, "protobuf", Message::descriptor()->full_name(), "", "protobuf"};
    remote_->onMessage({std::make_shared<RemoteChannel>(channel), time, std::make_shared<Message>(), 0, {}});
    session_.tick();
  }
  Instant timeOf(const std::string& path) {
    const StreamMessage* message = session_.store().latest(path, Instant::max());
    return message == nullptr ? Instant::max() : message->time;
  }

  Session session_;
  std::optional<RemoteSession> remote_;
};

TEST_F(RemoteTimesTest, whatWasLatchedBeforeAResetIsBroughtToTheRobotsTime) {
  begin();
  hear<foxglove::SceneUpdate>("scene", Instant(763s));
  hear<KeyTable>("red1/tables/keys", Instant(760s));
  EXPECT_EQ(session_.store().newest(), Instant(763s));
  hear<foxglove::FrameTransforms>("transforms", Instant(14s));
  session_.tick();
  EXPECT_EQ(session_.store().newest(), Instant(14s));
  EXPECT_EQ(timeOf("scene"), Instant(14s));
  EXPECT_EQ(timeOf("red1/tables/keys"), Instant(14s));
  hear<foxglove::FrameTransforms>("transforms", Instant(15s));
  EXPECT_EQ(remote_->shift.newest(), Instant(15s));
}

TEST_F(RemoteTimesTest, aLatchedMessageDoesNotMoveTheRobotsTime) {
  begin();
  hear<foxglove::FrameTransforms>("transforms", Instant(14s));
  hear<KeyTable>("red1/tables/subscribers", Instant(760s));
  EXPECT_EQ(timeOf("red1/tables/subscribers"), Instant(14s));
  EXPECT_EQ(session_.store().newest(), Instant(14s));
  hear<KeyTable>("red1/tables/keys", Instant(3s));
  EXPECT_EQ(timeOf("red1/tables/keys"), Instant(3s));
}

TEST_F(RemoteTimesTest, aFollowingConnectionHasLatchedMessagesAtTheLeadingTime) {
  SessionClientOptions options;
  options.leadingTime = [] { return std::optional(Instant(100s)); };
  begin(std::move(options));
  hear<KeyTable>("red1/tables/keys", Instant(760s));
  EXPECT_EQ(timeOf("red1/tables/keys"), Instant(100s));
  hear<foxglove::Log>("red1/log", Instant(14s));
  EXPECT_EQ(timeOf("red1/log"), Instant(100s));
}

}  // namespace
}  // namespace robotlink::websocket
