// SPDX-License-Identifier: GPL-3.0-or-later
// The stretches of a session's time in which a link was cut.
#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotlink/foxglove/session/LinkNames.h"
#include "robotlink/foxglove/session/remote/RemoteSession.h"

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

class RemoteGapsTest : public testing::Test {
 protected:
  RemoteGapsTest() {
    remote_.onConnected({"", {}, {}, {{kSessionKey, "1"}}, "1", {}, {}});
    remote_.robots.add("red1", "red1");
  }
  void hear(const std::string& path, Instant time) {
    const Channel channel{1, path, "protobuf", "foxglove.Log", "", "protobuf"};
    remote_.onMessage(
        {std::make_shared<RemoteChannel>(channel), time, std::make_shared<foxglove::Log>(), 0, {}});
  }
  void cut() {
    ConnectionState state;
    state.phase = ConnectionState::Phase::kSilent;
    state.reason = "cut";
    remote_.lookAtGaps(state);
  }

  Session session_;
  RemoteSession remote_{session_, {}};
};

TEST_F(RemoteGapsTest, endWithTheFirstNewerMessage) {
  hear("red1/log", Instant(2s));
  cut();
  EXPECT_THAT(remote_.gaps, ElementsAre(SessionGap{Instant(2s), {}, "cut"}));
  hear("red1/log", Instant(5s));
  hear("red1/log", Instant(6s));
  EXPECT_THAT(remote_.gaps, ElementsAre(SessionGap{Instant(2s), Instant(5s), "cut"}));
}

TEST_F(RemoteGapsTest, areKnownAlsoIfAnOlderMessageComesFirst) {
  hear("red1/log", Instant(2s));
  cut();
  // The newest one of a stream that was not subscribed to before, of a robot that pauses.
  hear("red1/camera/image", Instant(1s));
  EXPECT_THAT(remote_.gaps, ElementsAre(SessionGap{Instant(2s), {}, "cut"}));
  hear("red1/log", Instant(5s));
  EXPECT_THAT(remote_.gaps, ElementsAre(SessionGap{Instant(2s), Instant(5s), "cut"}));
}

TEST_F(RemoteGapsTest, areNoneWhereTheRobotPausedAllTheTime) {
  hear("red1/log", Instant(2s));
  cut();
  hear("red1/log", Instant(2s));
  EXPECT_THAT(remote_.gaps, IsEmpty());
  hear("red1/log", Instant(3s));
  EXPECT_THAT(remote_.gaps, IsEmpty());
}

TEST_F(RemoteGapsTest, areGoneWithTheHistoryBeforeAReset) {
  hear("red1/log", Instant(9s));
  cut();
  hear("red1/log", Instant(1s));
  EXPECT_THAT(remote_.gaps, IsEmpty());
  cut();
  hear("red1/log", Instant(4s));
  EXPECT_THAT(remote_.gaps, ElementsAre(SessionGap{Instant(1s), Instant(4s), "cut"}));
}

}  // namespace
}  // namespace robotlink::websocket
