// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/Referee.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/platforms/simulated/game/FieldOfPlay.h"
#include "app/platforms/simulated/game/GameTime.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "robotlink/config/FieldDescription.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"

namespace app {

using robotlink::Duration;
using robotlink::Vector2;
using robotlink::Vector3;
using Phase = GameMachine::Phase;

namespace {

constexpr Duration kRefereeStep = SimulatedWorld::kStep;
/// A robot that is farther from its place, m, is put back to it.
constexpr double kLeftPlace = 0.15, kLeftPenaltyPlace = 0.5;
/// The same of the ball.
constexpr double kBallLeftPlace = 0.03;
/// The cosine of the tilt from which a robot counts as lying.
constexpr double kLies = 0.5;
/// A ball that is dropped goes at least so far, m.
constexpr double kFarDrop = 0.3;

const char* sentenceOf(Phase phase) {
  switch (phase) {
    case Phase::kInitial:
      return "The game has not begun.";
    case Phase::kReady:
      return "The robots go to their places.";
    case Phase::kSet:
      return "The robots wait for the kick-off.";
    case Phase::kPlaying:
      return "The game goes on.";
    default:
      return "The half is over.";
  }
}

bool hasGame(const simcore::Scene& scene) {
  return !scene.field().empty() && !scene.balls().empty();
}

}  // namespace

std::unique_ptr<Referee> Referee::create(std::shared_ptr<const GameRules> rules,
                                         std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation) {
  if (!rules || !field || !hasGame(simulation.scene())) return nullptr;
  auto referee = std::unique_ptr<Referee>(new Referee(std::move(rules), std::move(field), simulation));
  return referee->players_.empty() ? nullptr : std::move(referee);
}

Referee::Referee(std::shared_ptr<const GameRules> rules,
                 std::shared_ptr<const robotlink::FieldDescription> field, simcore::Simulation& simulation)
    : rules_(std::move(rules)),
      field_(std::move(field)),
      simulation_(simulation),
      machine_(*rules_),
      fouls_(*rules_, *field_),
      placing_(*rules_, *field_, simulation_) {
  findPlayers();
  noteGoals();
}

void Referee::findPlayers() {
  const auto before = std::move(players_);
  const auto penalties = std::move(penalized_);
  ball_ = simulation_.scene().balls().front();
  players_ = playersOf(simulation_.scene(), *rules_);
  penalized_.assign(players_.size(), std::nullopt);
  toPlace_.assign(players_.size(), false);
  for (std::size_t i = 0; i < players_.size(); ++i) {
    GamePlayer& player = players_[i];
    const auto known = std::ranges::find(before, player.robot, &GamePlayer::robot);
    const auto pose = simulation_.modelPose(player.robot);
    if (known != before.end()) {
      player.height = known->height;
      penalized_[i] = penalties[static_cast<std::size_t>(known - before.begin())];
    } else if (pose) {
      player.height = pose->translation().z();
    }
  }
  fouls_.restart(players_.size());
  tallies_.assign(players_.size(), {});
  outside_.assign(players_.size(), {});
}

bool Referee::followModels() {
  if (!hasGame(simulation_.scene())) return false;
  findPlayers();
  ++changes_;
  return !players_.empty();
}

void Referee::restart() {
  machine_.restart();
  penalized_.assign(players_.size(), std::nullopt);
  toPlace_.assign(players_.size(), false);
  ballToPlace_ = false;
  fouls_.restart(players_.size());
  untilFouls_ = outFor_ = stuckFor_ = {};
  tallies_.assign(players_.size(), {});
  outside_.assign(players_.size(), {});
  texts_.clear();
  message_.clear();
  noteGoals();
  ++changes_;
}

void Referee::worldJumped() {
  fouls_.restart(players_.size());
  outFor_ = stuckFor_ = {};
}

void Referee::say(std::string text) {
  message_ = text;
  texts_.push_back(std::move(text));
  ++changes_;
}

void Referee::noteGoals() {
  for (std::size_t team = 0; team < rules_->teams.size(); ++team)
    goals_[rules_->teams[team]] = static_cast<int>(machine_.goals(team));
}

std::vector<std::string> Referee::step() {
  machine_.pass(kRefereeStep);
  if (isAutomatic_) followPhases();
  continuePlacing();
  if (isAutomatic_ && machine_.phase() == Phase::kPlaying) watchBall();
  untilFouls_ -= kRefereeStep;
  if (untilFouls_ <= Duration()) {
    untilFouls_ = FoulWatch::kEvery;
    tally();
    watchFouls();
  }
  passPenalties();
  return std::exchange(texts_, {});
}

void Referee::followPhases() {
  const auto next = machine_.due();
  // The ball must be in its place before the game continues.
  if (!next || (*next == Phase::kPlaying && ballToPlace_)) return;
  (void)enter(*next);
}

robotlink::Result<void> Referee::enter(Phase phase) {
  const bool wasSet = machine_.phase() == Phase::kSet;
  if (auto entered = machine_.enter(phase); !entered) return entered;
  outFor_ = stuckFor_ = {};
  if (phase == Phase::kSet) beginPlacing();
  if (phase == Phase::kPlaying && wasSet) correctPlaces();
  say(machine_.isOver() ? "The game is over." : sentenceOf(phase));
  return {};
}

void Referee::beginPlacing() {
  ballToPlace_ = true;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const GamePlayer& player = players_[i];
    const bool mayStay = rules_->placing == GameRules::Placing::kIllegal &&
                         placing_.mayStand(player, directionOf(player), kicks(player));
    toPlace_[i] = !penalized_[i] && !mayStay;
  }
  fouls_.restart(players_.size());
  // A robot in another one's place leaves it in the first round, so the second one succeeds.
  continuePlacing();
  continuePlacing();
}

void Referee::continuePlacing() {
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const GamePlayer& player = players_[i];
    if (!toPlace_[i]) continue;
    toPlace_[i] = !placing_.put(player, placing_.kickOffPlace(player, directionOf(player), kicks(player)));
  }
  if (ballToPlace_) ballToPlace_ = !placing_.putBall(ball_, Vector2::Zero());
}

void Referee::correctPlaces() {
  const auto ball = ballPlace();
  if (ball && ball->head<2>().norm() > kBallLeftPlace) ballToPlace_ = true;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const GamePlayer& player = players_[i];
    const auto pose = placing_.poseOf(player);
    if (penalized_[i] || !pose || rules_->placing != GameRules::Placing::kAll) continue;
    const auto place = placing_.kickOffPlace(player, directionOf(player), kicks(player));
    toPlace_[i] = (pose->translation() - place.translation()).norm() > kLeftPlace;
  }
  continuePlacing();
  // A robot that finds no room now plays from where it is.
  toPlace_.assign(players_.size(), false);
}

std::optional<Vector3> Referee::ballPlace() const {
  const auto pose = simulation_.modelPose(ball_);
  if (!pose) return std::nullopt;
  return Vector3(pose->translation());
}

void Referee::watchBall() {
  const auto ball = ballPlace();
  if (!ball) return;
  if (const int side = goalWithBall(*field_, *ball); side != 0) return noteGoal(machine_.attackerOf(side));
  const Vector2 place = ball->head<2>();
  if (!isBallOnField(*field_, *ball)) {
    if (outFor_ == Duration()) say("The ball left the field.");
    outFor_ += kRefereeStep;
    if (outFor_ < rules_->ballOut) return;
    if (placing_.putBall(ball_, nearestInside(*field_, place, rules_->ballInset))) {
      outFor_ = {};
      say("The ball is on the field again.");
    }
    return;
  }
  outFor_ = {};
  if ((place - stuckPlace_).norm() > rules_->stuckDistance) {
    stuckPlace_ = place;
    stuckFor_ = {};
  }
  stuckFor_ += kRefereeStep;
  if (rules_->ballStuck > Duration() && stuckFor_ >= rules_->ballStuck) dropBall(place);
}

void Referee::noteGoal(std::size_t team) {
  machine_.score(team);
  noteGoals();
  std::string score;
  for (const std::string& name : rules_->teams) {
    std::string word = name;
    if (score.empty() && !word.empty() && word.front() >= 'a' && word.front() <= 'z')
      word.front() = static_cast<char>(word.front() - 'a' + 'A');
    score += fmt::format("{}{} {}", score.empty() ? "" : ", ", word, goals_[name]);
  }
  (void)enter(Phase::kReady);
  say(fmt::format("Goal for the {} team! {}.", rules_->teams[team], score));
}

void Referee::dropBall(const Vector2& from) {
  std::vector<Vector2> drops = rules_->drops;
  std::erase_if(drops, [&](const Vector2& drop) { return (drop - from).norm() < kFarDrop; });
  std::ranges::stable_sort(drops, {}, [&](const Vector2& drop) { return (drop - from).norm(); });
  for (const Vector2& drop : drops) {
    if (!placing_.putBall(ball_, drop)) continue;
    say("The ball was stuck; it lies elsewhere now.");
    break;
  }
  stuckFor_ = {};
}

void Referee::watchFouls() {
  if (!isAutomatic_ || machine_.phase() != Phase::kPlaying) return;
  std::vector<FoulWatch::Robot> robots;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const GamePlayer& player = players_[i];
    const auto pose = placing_.poseOf(player);
    if (penalized_[i] || !pose) continue;
    robots.push_back({i, player.team, -directionOf(player), player.isGoalie(), pose->translation()});
  }
  const auto ball = ballPlace();
  const auto touching = [this](std::size_t a, std::size_t b) {
    const auto touched = simulation_.modelsTouching(players_[a].robot);
    return std::ranges::find(touched, players_[b].robot) != touched.end();
  };
  for (const auto& foul :
       fouls_.look(robots, ball ? std::optional<Vector2>(ball->head<2>()) : std::nullopt, touching))
    penalize(foul.robot, *foul.penalty);
}

void Referee::tally() {
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const auto pose = simulation_.modelPose(players_[i].robot);
    if (!pose || penalized_[i]) {
      outside_[i] = {};
      continue;
    }
    const Vector2 place = pose->translation().head<2>();
    outside_[i] =
        isRobotOnField(*field_, place, rules_->leavingMargin) ? Duration() : outside_[i] + FoulWatch::kEvery;
    tallies_[i].longestOutside = std::max(tallies_[i].longestOutside, outside_[i]);
    if (pose->linear()(2, 2) < kLies) tallies_[i].fallen += FoulWatch::kEvery;
  }
}

void Referee::penalize(std::size_t player, const GameRules::Penalty& penalty) {
  penalized_[player] = Penalized{&penalty, penalty.time};
  toPlace_[player] = false;
  fouls_.forget(player);
  ++tallies_[player].penalties;
  placing_.put(players_[player], placing_.penaltyPlace(players_[player], directionOf(players_[player])));
  say(fmt::format("{} is penalized for {} s: {}.", players_[player].robot, robotlink::seconds(penalty.time),
                  penalty.reason));
}

bool Referee::returnPlayer(std::size_t player) {
  if (!placing_.putBack(players_[player], directionOf(players_[player]))) return false;
  penalized_[player].reset();
  fouls_.forget(player);
  say(fmt::format("{} plays again.", players_[player].robot));
  return true;
}

void Referee::passPenalties() {
  const Phase phase = machine_.phase();
  const bool isRunning = phase != Phase::kInitial && phase != Phase::kFinished;
  for (std::size_t i = 0; i < players_.size(); ++i) {
    auto& penalized = penalized_[i];
    if (!penalized) continue;
    if (isRunning) penalized->left = std::max(Duration(), penalized->left - kRefereeStep);
    if (isAutomatic_ && penalized->left == Duration() && returnPlayer(i)) continue;
    // A penalized robot that walks away is carried back.
    const auto pose = placing_.poseOf(players_[i]);
    const auto place = placing_.penaltyPlace(players_[i], directionOf(players_[i]));
    if (pose && (pose->translation() - place.translation()).norm() > kLeftPenaltyPlace)
      placing_.put(players_[i], place);
  }
}

void Referee::transfer(simcore::StateStream& stream) {
  auto players = static_cast<std::uint32_t>(players_.size());
  stream.raw(players);
  if (players != players_.size()) return stream.fail();
  machine_.transfer(stream);
  stream.flag(isAutomatic_);
  fouls_.transfer(stream);
  for (auto& penalized : penalized_) {
    auto which =
        static_cast<std::uint32_t>(penalized ? penalized->penalty - rules_->penalties.data() + 1 : 0);
    std::int64_t left = penalized ? penalized->left.count() : 0;
    stream.raw(which);
    stream.raw(left);
    if (which > rules_->penalties.size() || left < 0) stream.fail();
    if (!stream.isReading() || !stream.good()) continue;
    penalized.reset();
    if (which > 0) penalized = Penalized{&rules_->penalties[which - 1], Duration(left)};
  }
  for (std::size_t i = 0; i < players_.size(); ++i) {
    stream.raw(tallies_[i].penalties);
    for (Duration* time : {&tallies_[i].longestOutside, &tallies_[i].fallen, &outside_[i]})
      transferTime(stream, *time);
  }
  stream.bits(toPlace_);
  stream.flag(ballToPlace_);
  for (Duration* time : {&untilFouls_, &outFor_, &stuckFor_}) transferTime(stream, *time);
  stream.number(stuckPlace_.x());
  stream.number(stuckPlace_.y());
  noteGoals();
  ++changes_;
}

}  // namespace app
