// SPDX-License-Identifier: GPL-3.0-or-later
// A hundred times 20 s of silence, by a manual clock: client and server, and a line between them that this
// test carries and cuts.
#include <gmock/gmock.h>

#include <deque>

#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/LinkWatch.h"
#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/server/Server.h"

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;

/// 100 ms each way, looked at every 10 ms. While it is down, whatever is on its way or sent is lost, and with
/// it the connection, of which neither end is told.
class SilentLine : public testing::Test {
 protected:
  static constexpr Duration kStep = 10ms, kDelay = 100ms;

  void step() {
    clock_->advance(kStep);
    const Instant now = clock_->now();
    switch (watch_.next(now)) {
      case LinkWatch::Action::kConnect:
        watch_.addressFound(now);
        // Two round trips for TCP and the handshake.
        served_.reset();
        back_.clear();
        connectedAt_ = isUp_ ? std::optional(now + 4 * kDelay) : std::nullopt;
        break;
      case LinkWatch::Action::kGiveUp:
        served_.reset();
        connectedAt_.reset();
        client_.lost();
        break;
      case LinkWatch::Action::kPing:
        if (served_ && isUp_) back_.push_back({now + 2 * kDelay, std::nullopt});
        break;
      default:
        break;
    }
    if (connectedAt_ && now >= *connectedAt_) {
      connectedAt_.reset();
      watch_.stepDone(now);
      client_.opened();
      served_ = *server_->connect({0, "1.2.3.4:5", "x"}, [] {});
    }
    carry(now);
    client_.tick();
  }
  void carry(Instant now) {
    if (!served_) return;
    while (const auto frame = client_.next())
      if (isUp_) server_->received(served_, frame->kind, frame->bytes);
    while (const auto next = server_->next(*served_, now)) {
      std::string bytes(reinterpret_cast<const char*>(next->head.data()), next->headSize);
      if (isUp_) back_.push_back({now + kDelay, Frame{next->kind, bytes + *next->payload}});
    }
    for (; !back_.empty() && back_.front().first <= now; back_.pop_front()) {
      watch_.heard(now);
      if (!back_.front().second) continue;
      EXPECT_TRUE(client_.received(back_.front().second->kind, back_.front().second->bytes));
      if (client_.isGreeted() && !watch_.isGreeted()) watch_.greeted(now);
    }
  }
  void cut() {
    isUp_ = false;
    back_.clear();
    // What is lost never comes, whatever TCP does.
    if (served_) server_->disconnected(served_);
    served_.reset();
    connectedAt_.reset();
  }

  const std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
  const std::shared_ptr<Server> server_ = Server::make({}, {});
  const ChannelPtr channel_ = server_->addChannels({{"a", "json", "", ""}})[0];
  int received_ = 0;
  Client client_{{.message = [this](const Channel&, Instant, std::string_view) { ++received_; }}, {}, clock_};
  LinkWatch watch_{{}, clock_->now()};
  bool isUp_ = true;
  ClientPtr served_;
  std::optional<Instant> connectedAt_;
  std::deque<std::pair<Instant, std::optional<Frame>>> back_;
};

TEST_F(SilentLine, isBackWithinTwoSecondsEachTimeWithEverythingAskedForBefore) {
  client_.subscribe({"a"});
  for (int i = 0; i < 200; ++i) step();
  ASSERT_TRUE(channel_->isWanted());
  for (int round = 0; round < 100; ++round) {
    cut();
    // Each time at another moment of the tries.
    const Instant end = clock_->now() + 20s + round * 17ms;
    const Instant begin = clock_->now();
    bool wasSilent = false;
    while (clock_->now() < end) {
      step();
      const bool isSilent = watch_.phase() == ConnectionState::Phase::kSilent;
      wasSilent |= isSilent;
      EXPECT_TRUE(isSilent || clock_->now() <= begin + 1200ms) << "round " << round;
    }
    EXPECT_TRUE(wasSilent) << "round " << round;
    isUp_ = true;
    const Instant back = clock_->now();
    received_ = 0;
    while (received_ == 0 && clock_->now() < back + 5s) {
      if (channel_->isWanted()) channel_->publish(clock_->now(), "{}");
      step();
    }
    EXPECT_LE(clock_->now() - back, 2s) << "round " << round;
    EXPECT_EQ(watch_.phase(), ConnectionState::Phase::kConnected);
    for (int i = 0; i < 50; ++i) step();
  }
  EXPECT_EQ(client_.state().connections, 101U);
}

}  // namespace
}  // namespace robotlink::websocket
