// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameMachine.h"

#include <algorithm>

#include "app/platforms/simulated/game/GameTime.h"

namespace app {

using robotlink::Duration;

namespace {

constexpr unsigned kMaxGoals = 1000, kMaxHalves = 10;

}  // namespace

void GameMachine::restart() {
  phase_ = Phase::kInitial;
  half_ = 1;
  ofPhase_ = ofHalf_ = {};
  kickOff_ = 0;
  goals_ = {};
}

void GameMachine::pass(Duration time) {
  ofPhase_ += time;
  if (phase_ != Phase::kInitial && phase_ != Phase::kFinished) ofHalf_ += time;
}

std::optional<GameMachine::Phase> GameMachine::due() const {
  const auto after = [&](Duration time, Phase next) {
    return ofPhase_ >= time ? std::optional(next) : std::nullopt;
  };
  const bool isRunning = phase_ != Phase::kInitial && phase_ != Phase::kFinished;
  if (isRunning && ofHalf_ >= rules_.half) return Phase::kFinished;
  switch (phase_) {
    case Phase::kInitial:
      return after(rules_.initial, Phase::kReady);
    case Phase::kReady:
      return after(rules_.ready, Phase::kSet);
    case Phase::kSet:
      return after(rules_.set, Phase::kPlaying);
    case Phase::kFinished:
      return isOver() ? std::nullopt : after(rules_.pause, Phase::kReady);
    default:
      return std::nullopt;
  }
}

robotlink::Result<void> GameMachine::enter(Phase phase) {
  if (isOver() && phase != Phase::kFinished)
    return robotlink::failure("game.over", "the game is over; start another with game.restart");
  const bool beginsHalf = phase_ == Phase::kFinished && phase == Phase::kReady;
  if (phase_ == Phase::kFinished && !beginsHalf && phase != Phase::kFinished)
    return robotlink::failure("game.half", "the half is over; begin the next one with game.ready");
  if (beginsHalf) {
    ++half_;
    ofHalf_ = {};
    kickOff_ = (half_ - 1) % 2;
  }
  phase_ = phase;
  ofPhase_ = {};
  return {};
}

void GameMachine::score(std::size_t team) {
  goals_[team] = std::min(goals_[team] + 1, kMaxGoals);
  kickOff_ = 1 - team;
}

Duration GameMachine::left() const {
  return std::max(Duration(), rules_.half - ofHalf_);
}

int GameMachine::direction(std::size_t team) const {
  const bool isSwitched = rules_.switchSides && half_ % 2 == 0;
  return (team == 0) == isSwitched ? -1 : 1;
}

void GameMachine::transfer(simcore::StateStream& stream) {
  stream.choice(phase_, Phase::kFinished);
  stream.upTo(half_, kMaxHalves);
  stream.require(half_ >= 1);
  transferTime(stream, ofPhase_);
  transferTime(stream, ofHalf_);
  auto kickOff = static_cast<std::uint8_t>(kickOff_);
  stream.upTo(kickOff, std::uint8_t{1});
  kickOff_ = kickOff;
  for (unsigned& goals : goals_) stream.upTo(goals, kMaxGoals);
}

}  // namespace app
