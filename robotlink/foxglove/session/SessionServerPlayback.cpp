// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a SessionServer, which clients play.
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/foxglove/session/SessionServer.h"

namespace robotlink::websocket {

using robotcontrol::ControlReplay;
using robotcontrol::ReplayStatus;

void SessionServer::offerPlayback() {
  const StreamMessage* newest = session_.store().latest(streams::kReplay, Instant::max());
  const auto* status = newest == nullptr ? nullptr : dynamic_cast<const ReplayStatus*>(newest->value.get());
  if (status == nullptr) {
    replay_.reset();
    return server_->setPlayable({});
  }
  server_->setPlayable(TimeRange{Instant(Duration(status->begin())), Instant(Duration(status->end()))});
  if (plays_ > 0 || newest->value == replay_) return;
  // A jump replaces the history.
  publishPlayback(replay_ && session_.store().generation() != generation_, {});
}

void SessionServer::publishPlayback(bool didSeek, const std::string& requestId) {
  const StreamMessage* newest = session_.store().latest(streams::kReplay, Instant::max());
  const auto* known = newest == nullptr ? nullptr : dynamic_cast<const ReplayStatus*>(newest->value.get());
  if (known == nullptr) return;
  replay_ = newest->value;
  generation_ = session_.store().generation();
  const ReplayStatus& status = *known;
  using Phase = PlaybackState::Phase;
  const bool ended = !status.playing() && status.time() >= status.end();
  const Phase phase = status.playing() ? Phase::kPlaying : ended ? Phase::kEnded : Phase::kPaused;
  server_->publishPlaybackState(
      {phase, Instant(Duration(status.time())), static_cast<float>(status.speed()), didSeek, requestId});
}

void SessionServer::play(const PlaybackControl& control) {
  const auto refuse = [this](const robotcontrol::RequestResult& result) {
    if (!result.accepted()) server_->publishStatus({StatusLevel::kWarning, result.reason(), {}});
  };
  if (control.seek) {
    robotcontrol::Request jump;
    jump.mutable_control_replay()->set_action(ControlReplay::JUMP_TO_TIME);
    jump.mutable_control_replay()->set_time(control.seek->time_since_epoch().count());
    request(std::move(jump), refuse);
  }
  robotcontrol::Request act;
  const bool plays = control.command == PlaybackControl::Command::kPlay;
  act.mutable_control_replay()->set_action(plays ? ControlReplay::PLAY : ControlReplay::PAUSE);
  act.mutable_control_replay()->set_speed(static_cast<double>(control.speed));
  ++plays_;
  request(std::move(act), [this, refuse, control](const robotcontrol::RequestResult& result) {
    refuse(result);
    --plays_;
    publishPlayback(control.seek.has_value(), control.requestId);
  });
}

}  // namespace robotlink::websocket
