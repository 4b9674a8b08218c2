// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: the game that its robots play: the umpire, and the radio of the teams.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "app/core/platform/PublishGate.h"
#include "app/core/program/RecordingTap.h"
#include "app/platforms/simulated/SceneResources.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/game/GameMessages.h"
#include "app/platforms/simulated/game/GameRules.h"
#include "app/platforms/simulated/game/KickOff.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/requests/GameRequests.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"

namespace app {

using robotlink::Errors;
using robotlink::Result;

namespace {

/// The period at which the remaining time is sent to robots.
constexpr robotlink::Duration kPublishEvery = std::chrono::milliseconds(96);

}  // namespace

Errors SimulatedRun::makeGame() {
  const std::string& ofScene = world_->simulation().scene().world().game;
  const std::string name = options_.game.empty() ? ofScene : options_.game;
  if (options_.kickOffs && !name.empty() && name != kNoGame) {
    if (options_.game.empty())
      if (Errors missing = missingGame(world_->simulation().scene()); !missing.empty()) return missing;
    auto rules = GameRules::load(gameRulesNamed(name));
    if (!rules) return rules.error();
    rules_ = std::make_shared<const GameRules>(std::move(*rules));
  }
  makeUmpire();
  if (rules_ && !options_.game.empty() && referee_ == nullptr)
    return {{"game.none",
             "--game: the game of the rules " + name +
                 " needs a field with a ball and a robot of one of the teams " +
                 fmt::format("{}", fmt::join(rules_->teams, ", ")) +
                 ", which this scene does not have; open one with them, such as game2002, or add robots with "
                 "--robots",
             {name},
             {}}};
  restartGame();
  return {};
}

void SimulatedRun::makeUmpire() {
  if (!options_.kickOffs) return;
  if (auto referee = Referee::create(rules_, field_, world_->simulation())) {
    referee_ = referee.get();
    umpire_ = std::move(referee);
  } else {
    umpire_ = KickOff::create(field_, world_->simulation());
  }
}

void SimulatedRun::restartGame() {
  if (referee_ != nullptr) referee_->startOver();
  if (umpire_ && referee_ == nullptr) umpire_->restart();
  radio_.restart(options_.world.seed);
  radio_.setSettings(rules_ ? rules_->radio : RadioSettings());
  for (auto& [robot, mail] : mails_) *mail = {};
  publishedAt_ = {};
}

void SimulatedRun::followModels() {
  if (!umpire_ || umpire_->followModels()) return;
  referee_ = nullptr;
  umpire_.reset();
  for (auto& [robot, mail] : mails_) mail->state.reset();
}

std::shared_ptr<GameMail> SimulatedRun::mailOf(const std::string& robot) {
  auto& mail = mails_[robot];
  if (!mail) mail = std::make_shared<GameMail>();
  return mail;
}

void SimulatedRun::watchGame() {
  passMail();
  if (!umpire_) return;
  for (const std::string& text : umpire_->step()) {
    if (listeners_.game) listeners_.game(world_->clock().now(), text);
    // The game belongs to no robot, but texts in a log must; the first one stands for it.
    if (tap_ && !robots_.empty())
      tap_->world(
          textMessage(robots_.front()->name(), "game", world_->clock().now(), foxglove::Log::INFO, text));
  }
  if (referee_ == nullptr) return;
  const robotlink::Instant now = world_->clock().now();
  if (referee_->changes() == publishedChanges_ && now - publishedAt_ < kPublishEvery && now >= publishedAt_)
    return;
  publishedChanges_ = referee_->changes();
  publishedAt_ = now;
  for (const auto& robot : robots_)
    mailOf(robot->name())->state = gameStateFor(*referee_, robot->name(), now);
  if (tap_) recordGame();
}

void SimulatedRun::recordGame() {
  if (tap_->wants(robotlink::streams::kGame))
    tap_->world({robotlink::streams::kGame, world_->clock().now(), gameStatus()});
}

void SimulatedRun::passMail() {
  const robotlink::Instant now = world_->clock().now();
  bool isSent = false;
  for (const auto& [robot, mail] : mails_) isSent = isSent || mail->sent;
  if (isSent) {
    std::vector<TeamRadio::Station> stations;
    for (const auto& robot : robots_) {
      const auto pose = world_->simulation().modelPose(robot->name());
      const robotlink::Vector2 place =
          pose ? robotlink::Vector2(pose->translation().head<2>()) : robotlink::Vector2(0, 0);
      stations.push_back({robot->name(), robot->robot().team, place});
    }
    radio_.setStations(std::move(stations));
    // In the order of the scene.
    for (const auto& robot : robots_) {
      if (auto message = std::exchange(mailOf(robot->name())->sent, nullptr))
        radio_.send(robot->name(), message, now);
    }
  }
  for (auto& [robot, mail] : mails_) {
    if (auto received = radio_.receive(robot, now)) mail->received = std::move(received);
  }
}

std::shared_ptr<const robotcontrol::GameStatus> SimulatedRun::gameStatus() const {
  if (referee_ == nullptr) return nullptr;
  return app::gameStatus(*referee_, radio_.settings(), world_->clock().now());
}

Result<void> SimulatedRun::controlGame(const robotcontrol::Request& request) {
  const robotcontrol::ControlGame& wanted = request.control_game();
  if (const std::string wrong = robotlink::wrongGame(request); !wrong.empty())
    return robotlink::failure("game.request", wrong);
  if (wanted.action() == robotcontrol::ControlGame::RADIO) {
    radio_.setSettings(wanted.radio());
  } else if (referee_ == nullptr) {
    return robotlink::failure("game.none",
                              "there is no referee: the scene names no rules of a game, or no robots play");
  } else if (auto done = referee_->control(wanted); !done) {
    return done;
  }
  journal_.add(stepsMade_, request);
  return {};
}

}  // namespace app
