// SPDX-License-Identifier: GPL-3.0-or-later
// SimulationFeed: the game that robots play, and the layouts of their programs.
#include "app/platforms/simulated/SimulationFeed.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

/// The period at which the remaining time is published, in real time.
constexpr std::chrono::milliseconds kGameEvery{200};

}  // namespace

robotlink::Result<void> SimulationFeed::controlGame(const robotcontrol::Request& request) {
  auto done = run_->controlGame(request);
  if (done) {
    publishGameStatus();
    publishTransforms();
  }
  return done;
}

robotlink::Errors SimulationFeed::setLayout(const std::filesystem::path& file) {
  robotlink::Errors errors = run_->setLayout(file);
  if (errors.empty()) afterLayout();
  return errors;
}

robotlink::Errors SimulationFeed::setLayoutOf(const std::string& name, const std::filesystem::path& file) {
  robotlink::Errors errors = run_->setLayoutOf(name, file);
  if (errors.empty()) afterLayout();
  return errors;
}

void SimulationFeed::afterLayout() {
  keepChoices();
  publishAnswers();
}

void SimulationFeed::publishGameStatus() {
  auto status = run_->gameStatus();
  if (!status) return;
  lastGame_ = Clock::now();
  gameChanges_ = run_->referee()->changes();
  gate_.publish({robotlink::streams::kGame, now(), std::move(status)});
}

void SimulationFeed::stepGame(Clock::time_point real) {
  if (run_->referee() == nullptr || !demand_.anything) return;
  const bool isNew = run_->referee()->changes() != gameChanges_;
  if (isNew || !running_ || real - lastGame_ >= kGameEvery) publishGameStatus();
}

}  // namespace app
