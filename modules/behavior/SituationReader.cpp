// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/SituationReader.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// The number at the end of a robot's name, "red2"; 1 without one.
int numberOf(const std::string& robot) {
  std::size_t digits = robot.size();
  while (digits > 0 && std::isdigit(static_cast<unsigned char>(robot[digits - 1])) != 0) --digits;
  const std::string number = robot.substr(digits, 4);
  return number.empty() ? 1 : std::max(1, std::stoi(number));
}

}  // namespace

SituationReader::SituationReader(robotlink::SolutionContext& context)
    : clock_(context.clock()),
      name_(context.robot().name),
      team_(context.robot().team),
      number_(numberOf(context.robot().name)),
      field_(context.robot().field),
      ball_(context.input(robotlink::kBallModel)),
      pose_(context.input(robotlink::kRobotPose)),
      players_(context.input(robotlink::kPlayersModel)),
      teamBall_(context.input(robotlink::kTeamBall)),
      messages_(context.input(robotlink::kTeamMessages)),
      game_(context.input(robotlink::kGameState)),
      robotState_(context.input(robotlink::kRobotState)),
      regions_(context.input(robotlink::kColorRegions)),
      status_(context.input(robotlink::kMotionStatus)),
      landmarks_(context.input(robotlink::kLandmarkPercepts)) {}

Pose2 SituationReader::teamInField() const {
  bool isTurned = field_ && field_->playingDirection(team_) < 0;
  if (game_ && field_) {
    for (const auto& team : game_->teams()) {
      const auto goal =
          std::ranges::find(field_->goals, team.attacks(), &robotlink::FieldDescription::Goal::name);
      if (team.name() == team_ && goal != field_->goals.end()) isTurned = goal->x < 0;
    }
  }
  return {0, 0, isTurned ? robotlink::kPi : 0};
}

GameSituation SituationReader::read(const Options& options) {
  GameSituation now;
  now.time = robotlink::seconds(clock_.now());
  now.number = number_;
  readGame(now);
  readBody(now);
  readLandmarks(now);
  now.seesField = seesField(options.minimumColored);
  if (pose_ && pose_->position_deviation() <= options.positionDeviation &&
      pose_->heading_deviation() <= options.headingDeviation)
    now.pose = teamInField().inverse() * robotlink::pose2(pose_->robot_in_field());
  readBall(now, options);
  readMates(now, options);
  readRobots(now, options);
  return now;
}

void SituationReader::readGame(GameSituation& now) const {
  if (!game_) return;
  static constexpr std::array kPhases{GameSituation::Phase::kInitial, GameSituation::Phase::kReady,
                                      GameSituation::Phase::kSet, GameSituation::Phase::kPlaying,
                                      GameSituation::Phase::kFinished};
  const int phase = game_->phase();
  if (phase >= 0 && phase < static_cast<int>(kPhases.size()))
    now.phase = kPhases[static_cast<std::size_t>(phase)];
  now.penalized = game_->penalized();
  now.ownKickOff = game_->kick_off().empty() || game_->kick_off() == team_;
  if (game_->number() > 0) now.number = static_cast<int>(game_->number());
  now.givenRole = roleOf(game_->role());
}

void SituationReader::readBody(GameSituation& now) const {
  now.pickedUp = robotState_ && robotState_->picked_up();
  if (!status_) return;
  now.fallen = status_->fallen();
  now.stable = status_->stable();
  now.playsMotion = status_->executed().kind() == robotcontrol::MotionRequest::KEY_FRAMES;
}

void SituationReader::readLandmarks(GameSituation& now) {
  if (!landmarks_) return;
  if (!landmarkSeenAt_ || !landmarks_->landmarks().empty()) landmarkSeenAt_ = now.time;
  now.landmarkAge = now.time - *landmarkSeenAt_;
}

/// A blind camera shows no color at all. In front of a wall or in a goal there is no green, but white or the
/// goal's color.
bool SituationReader::seesField(double minimumColored) const {
  // Without regions, only the ball model knows.
  if (!regions_) return true;
  double colored = 0;
  for (const robotcontrol::ColorRegion& region : regions_->regions()) colored += region.area();
  return colored > minimumColored * regions_->width() * regions_->height();
}

void SituationReader::readBall(GameSituation& now, const Options& options) const {
  if (ball_ && ball_->known()) {
    now.knowsBall = true;
    now.ball = robotlink::vector2(ball_->position_in_robot());
    now.ballVelocity = robotlink::vector2(ball_->velocity_in_robot());
    // The age in the model is that at its last frame.
    now.ballAge = ball_->seconds_since_seen() +
                  std::max(0.0, now.time - robotlink::seconds(robotlink::instant(ball_->timestamp())));
  }
  const bool isOld = !now.knowsBall || now.ballAge > options.teamBallAfter;
  if (!isOld || !now.pose || !teamBall_ || !teamBall_->known()) return;
  const std::optional<double> age = secondsSinceMatesSawBall(now.time);
  // Knowledge that only this robot has is not newer.
  if (!age || (now.knowsBall && now.ballAge < *age)) return;
  const Pose2 fieldInRobot = (teamInField() * *now.pose).inverse();
  now.knowsBall = true;
  now.ballFromTeam = true;
  now.ballAge = *age;
  now.ball = fieldInRobot * robotlink::vector2(teamBall_->position_in_field());
  now.ballVelocity =
      Eigen::Rotation2Dd(fieldInRobot.heading) * robotlink::vector2(teamBall_->velocity_in_field());
}

std::optional<double> SituationReader::secondsSinceMatesSawBall(double now) const {
  std::optional<double> least;
  if (!messages_) return least;
  const auto& seenBy = teamBall_->seen_by();
  for (const robotcontrol::TeamMessage& message : messages_->messages()) {
    if (message.sender() == name_ || std::ranges::find(seenBy, message.sender()) == seenBy.end()) continue;
    const double sent = robotlink::seconds(robotlink::instant(message.timestamp()));
    const double age = message.seconds_since_ball_seen() + std::max(0.0, now - sent);
    least = std::min(age, least.value_or(age));
  }
  return least;
}

void SituationReader::readMates(GameSituation& now, const Options& options) const {
  if (!messages_) return;
  const Pose2 fieldInTeam = teamInField().inverse();
  for (const robotcontrol::TeamMessage& message : messages_->messages()) {
    if (message.sender() == name_ || message.team() != team_) continue;
    if (now.time - robotlink::seconds(robotlink::instant(message.timestamp())) > options.mateTimeout)
      continue;
    now.mates.push_back({static_cast<int>(message.number()), roleOf(message.role()),
                         fieldInTeam * robotlink::pose2(message.pose_in_field()), message.seconds_to_ball(),
                         message.ball_known()});
  }
}

void SituationReader::readRobots(GameSituation& now, const Options& options) const {
  if (!players_ || !now.pose) return;
  const Pose2 fieldInTeam = teamInField().inverse();
  const Pose2 teamInRobot = now.pose->inverse();
  for (const auto& player : players_->players()) {
    if (player.confidence() < options.robotConfidence) continue;
    const Vector2 place = fieldInTeam * robotlink::vector2(player.position_in_field());
    now.robots.push_back(teamInRobot * place);
    if (player.team() != team_) now.opponents.push_back(place);
  }
}

}  // namespace modules
