// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/KickOff.h"

#include <algorithm>
#include <cctype>

#include "app/platforms/simulated/game/FieldOfPlay.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/world/StateStream.h"

namespace app {
namespace {

using robotlink::Vector3;

std::string capitalized(std::string name) {
  if (!name.empty()) name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

}  // namespace

std::unique_ptr<KickOff> KickOff::create(std::shared_ptr<const robotlink::FieldDescription> field,
                                         simcore::Simulation& simulation) {
  const simcore::Scene& scene = simulation.scene();
  if (!field || scene.field().empty() || scene.balls().empty()) return nullptr;
  return std::unique_ptr<KickOff>(new KickOff(std::move(field), simulation));
}

KickOff::KickOff(std::shared_ptr<const robotlink::FieldDescription> field, simcore::Simulation& simulation)
    : field_(std::move(field)), simulation_(simulation), ball_(simulation.scene().balls().front()) {
  for (const auto& robot : simulation.scene().robots()) {
    if (const auto pose = simulation.modelPose(robot.name))
      robots_.push_back({robot.name, robotlink::groundPose(*pose)});
  }
  restart();
}

void KickOff::restart() {
  goals_.clear();
  for (const auto& team : field_->teams) goals_[team.name] = 0;
  outSince_.reset();
}

void KickOff::transfer(simcore::StateStream& stream) {
  for (auto& [team, count] : goals_) {
    stream.raw(count);
    stream.require(count >= 0);
  }
  bool isOut = outSince_.has_value();
  stream.flag(isOut);
  std::int64_t since = outSince_.value_or(robotlink::Duration()).count();
  stream.raw(since);
  stream.require(since >= 0 && since <= simulation_.time().count());
  if (!stream.isReading()) return;
  outSince_.reset();
  if (isOut && stream.good()) outSince_ = robotlink::Duration(since);
}

bool KickOff::followModels() {
  const simcore::Scene& scene = simulation_.scene();
  if (scene.field().empty() || scene.balls().empty()) return false;
  ball_ = scene.balls().front();
  std::vector<Robot> robots;
  for (const auto& robot : scene.robots()) {
    const auto known = std::ranges::find(robots_, robot.name, &Robot::name);
    const auto pose = simulation_.modelPose(robot.name);
    if (known != robots_.end()) {
      robots.push_back(*known);
    } else if (pose) {
      robots.push_back({robot.name, robotlink::groundPose(*pose)});
    }
  }
  robots_ = std::move(robots);
  return true;
}

std::optional<std::string> KickOff::scorer(const Vector3& ball) const {
  const int side = goalWithBall(*field_, ball);
  if (side == 0) return std::nullopt;
  for (const auto& team : field_->teams) {
    if (field_->playingDirection(team.name) * side > 0) return team.name;
  }
  return std::nullopt;
}

std::string KickOff::score() const {
  std::string text;
  for (const auto& team : field_->teams)
    text += (text.empty() ? "" : ", ") + team.name + " " + std::to_string(goals_.at(team.name));
  return capitalized(text) + ".";
}

std::vector<std::string> KickOff::step() {
  const auto pose = simulation_.modelPose(ball_);
  if (!pose) return {};
  const Vector3 ball = pose->translation();
  const auto text = outSince_ ? whileWaiting(ball) : whilePlaying(ball);
  return text ? std::vector{*text} : std::vector<std::string>();
}

std::optional<std::string> KickOff::whilePlaying(const Vector3& ball) {
  const auto team = scorer(ball);
  if (!team && isBallOnField(*field_, ball)) return std::nullopt;
  outSince_ = simulation_.time();
  if (!team) return "The ball left the field.";
  ++goals_[*team];
  return "Goal for the " + *team + " team! " + score();
}

std::optional<std::string> KickOff::whileWaiting(const Vector3& ball) {
  // The user brought it back.
  if (!scorer(ball) && isBallOnField(*field_, ball)) {
    outSince_.reset();
    return std::nullopt;
  }
  if (simulation_.time() - *outSince_ < kPause) return std::nullopt;
  placeRobots();
  // If a robot in the middle could not be moved away, try again at the next step.
  if (!simulation_.placeModel(ball_, {})) return std::nullopt;
  outSince_.reset();
  return "Kick-off: the ball is back at the center, and the robots are at their starting positions.";
}

void KickOff::placeRobots() {
  // A robot in another one's place leaves it in the first round, so the second one succeeds.
  for (int round = 0; round < 2; ++round) {
    for (const Robot& robot : robots_) (void)simulation_.placeModel(robot.name, robot.start);
  }
}

}  // namespace app
