// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/SoccerMind.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// The bid of a player that cannot play, s.
constexpr double kNever = 1e3;
/// Added to the bid of a player that has not seen the ball itself, s.
constexpr double kHearsayPenalty = 0.7;
/// Looking up takes at least this long, and ends with a beacon that was seen this long ago, s.
constexpr double kEnoughLooking = 0.4, kJustSeen = 0.1;
/// The error of the position of a ball that the team reports before the paws, m.
constexpr double kTeamBallError = 0.1;
/// A ball that was left to the goalie has to be this far beyond the margin before others come back, m.
constexpr double kComesBack = 0.1;
/// How long a player bids for a ball that it has lost, s.
constexpr double kForgetting = 1;
/// A ball that vanished at the paws longer ago than this is somewhere else, s.
constexpr double kMayStillCover = 6;
/// The time after which it tries again if stepping back did not help, s.
constexpr double kUncoverAgain = 1;
constexpr double kLongAgo = -1e9;
/// The distance from which on a ball counts as having been moved by somebody, m.
constexpr double kMoved = 0.12;
/// After this many rounds the time of a way has converged.
constexpr int kSubstitutions = 4;

}  // namespace

SoccerMind::SoccerMind(const robotlink::FieldDescription& field, const Options& options)
    : options_(options),
      places_(field, options.places),
      skills_(options.skills),
      kicks_(places_, options.kicks),
      roles_(options.roles) {}

void SoccerMind::setOptions(const Options& options) {
  options_ = options;
  skills_.setOptions(options.skills);
  kicks_.setOptions(options.kicks);
  roles_.setOptions(options.roles);
}

Vector2 SoccerMind::ballAfter(double seconds) const {
  const double speed = now_.ballVelocity.norm();
  if (speed < 1e-6) return now_.ball;
  return now_.ball + now_.ballVelocity * (options_.roll.wayAfter(speed, seconds) / speed);
}

Vector2 SoccerMind::ballAtKick() const {
  return ballAfter(kick_ == KickKind::kFarAhead ? options_.farDelay : options_.kickDelay);
}

Vector2 SoccerMind::meetingPoint() const {
  // The time of the way to a place that depends on that time, by repeated substitution.
  double seconds = 0;
  for (int i = 0; i < kSubstitutions; ++i)
    seconds = std::min(options_.interceptTime, ballAfter(seconds).norm() / options_.skills.forwardSpeed);
  return ballAfter(seconds);
}

double SoccerMind::playDirection() {
  if (!now_.ballInTeam()) {
    kick_ = KickKind::kAhead;
    return std::atan2(meets_.y(), meets_.x());
  }
  const KickPlanner::Choice choice = kicks_.choose(
      {*now_.pose, places_.within(*now_.pose * meets_, 0), now_.opponents, matesInTeam(), skills_},
      isAtBall_);
  kick_ = choice.kind;
  return normalizedAngle(choice.heading() - now_.pose->heading);
}

std::optional<double> SoccerMind::aim() const {
  if (!now_.knowsBall) return std::nullopt;
  return aim_ + angleOf(kick_);
}

double SoccerMind::distanceToGoal() const {
  const auto ball = now_.ballInTeam();
  return ball ? (places_.opponentGoal() - *ball).norm() : 1e3;
}

bool SoccerMind::isUnderPressure() const {
  const auto ball = now_.ballInTeam();
  return ball && std::ranges::any_of(now_.opponents, [&](const Vector2& opponent) {
           return (opponent - *ball).norm() < options_.kickPressure;
         });
}

bool SoccerMind::shouldKick() const {
  return !now_.pose || distanceToGoal() < options_.kickRange || isUnderPressure() ||
         roles_.role() == Role::kGoalie;
}

std::vector<Vector2> SoccerMind::matesInTeam() const {
  std::vector<Vector2> places;
  for (const Mate& mate : now_.mates) places.push_back(mate.pose.translation());
  return places;
}

bool SoccerMind::isForGoalie() const {
  const auto ball = now_.ballInTeam();
  const double margin = options_.ownAreaMargin + (isLeftToGoalie_ ? kComesBack : 0);
  return ball && roles_.role() != Role::kGoalie && places_.isGoaliesBall(*ball, margin) &&
         std::ranges::any_of(now_.mates, [](const Mate& mate) { return mate.role == Role::kGoalie; });
}

bool SoccerMind::isAtPlace() const {
  if (!now_.pose) return false;
  const Pose2 rest = now_.pose->inverse() * place_;
  return rest.translation().norm() < options_.placeTolerance && std::abs(rest.heading) < options_.placeAngle;
}

bool SoccerMind::mustGlance() const {
  return now_.time - glancedAt_ > options_.glanceAgain + options_.glanceTime;
}

void SoccerMind::lookUp() {
  const bool mayLookUp = now_.time - lookedUpAt_ > options_.lookUpAfter && now_.seesBall();
  if (mayLookUp && now_.landmarkAge > options_.lookUpAfter) lookedUpAt_ = now_.time;
  const double looking = now_.time - lookedUpAt_;
  // Some frames with a beacon tell enough.
  const bool isEnough = looking > kEnoughLooking && now_.landmarkAge < kJustSeen;
  if (looking < options_.lookUpTime && !isEnough) intention_.head = Intention::Head::kLookAround;
}

bool SoccerMind::coversBall() const {
  // While the robot looks up for beacons, it cannot see the ball.
  if (now_.time - lookedUpAt_ < options_.lookUpTime + options_.coveredAfter) return false;
  if (now_.time - uncoveringSince_ < options_.stepBackTime + kUncoverAgain) return false;
  const double unseen = now_.time - ballSeenAt_;
  if (unseen < options_.coveredAfter || machine_.stateTime() < options_.coveredAfter) return false;
  const double near = options_.coveredDistance + kTeamBallError;
  if (now_.ballFromTeam && now_.ball.norm() > near) return false;
  // A robot that carries a ball along under its body learns of it from the others.
  const bool isTold = now_.ballFromTeam && now_.ball.norm() < options_.coveredDistance;
  return isTold || (lastBall_.norm() < options_.coveredDistance && unseen < kMayStillCover);
}

bool SoccerMind::uncoversBall() const {
  return now_.time - uncoveringSince_ < options_.stepBackTime;
}

bool SoccerMind::hidesBall() const {
  // The model may have forgotten the ball already.
  const double unseen = now_.time - ballSeenAt_;
  return lastBall_.norm() < options_.dribbleDistance && unseen > options_.coveredAfter &&
         unseen < 2 * options_.lostAfter && machine_.stateTime() > options_.coveredAfter;
}

void SoccerMind::observe(const GameSituation& now) {
  if (!started_) fieldSeenAt_ = now.time;
  started_ = true;
  const bool wasPlaying = now_.phase == GameSituation::Phase::kPlaying && now_.time > 0;
  now_ = now;
  if (now.seesField) fieldSeenAt_ = now.time;
  if (now.seesBall()) {
    lastBall_ = now.ball;
    ballSeenAt_ = now.time;
    if (now.ball.norm() > options_.coveredDistance) uncoveringSince_ = kLongAgo;
  }
  if (now.phase == GameSituation::Phase::kPlaying) {
    if (!wasPlaying) {
      playingSince_ = now.time;
      ballMoved_ = false;
      ballAtKickOff_ = now.ballInTeam();
    }
    if (const auto ball = now.ballInTeam(); ball && !now.ballFromTeam) {
      if (!ballAtKickOff_) ballAtKickOff_ = ball;
      if ((*ball - *ballAtKickOff_).norm() > kMoved + 0.1 * now.ball.norm()) ballMoved_ = true;
    }
  }
  meets_ = meetingPoint();
  aim_ = playDirection();
  const bool mayPlay = !now.fallen && !now.penalized && !now.pickedUp;
  // A ball that is forgotten is often seen again at once: roles wait for that.
  if (!mayPlay || (!now.knowsBall && now.time - ballKnownAt_ > kForgetting)) secondsToBall_ = kNever;
  if (now.knowsBall) ballKnownAt_ = now.time;
  if (now.knowsBall && mayPlay) {
    // At its paws it does not see the ball while it looks up.
    const bool isNear = std::max(lastBall_.norm(), now.ball.norm()) < options_.dribbleDistance;
    const double looking = isNear ? options_.lookUpTime + options_.coveredAfter : 0;
    secondsToBall_ = std::clamp(now.ballAge - looking, 0.0, 5.0);
    // A striker that has reached the ball keeps it: two that change places are in each other's way.
    if (!isNear || roles_.role() != Role::kStriker) secondsToBall_ += skills_.secondsTo(meets_, aim_);
    if (now.ballFromTeam) secondsToBall_ += kHearsayPenalty;
  }
  (void)roles_.decide(now, secondsToBall_);
  isLeftToGoalie_ = isForGoalie();
}

Intention SoccerMind::decide(const GameSituation& now) {
  observe(now);
  intention_ = {};
  target_.reset();
  isAtBall_ = false;
  machine_.advance(now.time);
  return intention_;
}

void SoccerMind::stand(Intention::Head head) {
  intention_ = {};
  intention_.head = head;
}

void SoccerMind::walkToPlace(const Pose2& placeInTeam) {
  if (!now_.pose) {
    stand(Intention::Head::kLookAround);
    return;
  }
  const Pose2 rest = now_.pose->inverse() * placeInTeam;
  target_ = rest.translation();
  std::vector<Vector2> obstacles = now_.robots;
  const Role role = roles_.role();
  const bool leavesBall = now_.knowsBall && (role == Role::kDefender || role == Role::kSupporter);
  if (leavesBall && now_.ball.norm() < options_.skills.clearDistance) {
    intention_ = skills_.makeWay(rest.translation(), now_.ball, now_.robots);
  } else {
    if (leavesBall) obstacles.push_back(now_.ball);
    intention_ = skills_.walkTo(rest.translation(), rest.heading, obstacles);
  }
  // On the way it looks at the ball, and from time to time for beacons and goals.
  if (mustGlance()) glancedAt_ = now_.time;
  const bool glances = now_.time - glancedAt_ < options_.glanceTime || !now_.knowsBall;
  intention_.head = glances ? Intention::Head::kLookAround : Intention::Head::kTrack;
}

void SoccerMind::approachBall() {
  target_ = skills_.placeBehind(meets_, aim_);
  intention_ = skills_.approach(meets_, aim_, now_.robots);
  if (now_.ball.norm() < options_.glanceDistance) {
    lookUp();
    return;
  }
  if (mustGlance() && now_.seesBall()) glancedAt_ = now_.time;
  if (now_.time - glancedAt_ < options_.glanceTime) intention_.head = Intention::Head::kLookAround;
}

const std::string& SoccerMind::motionOf(KickKind kick) const {
  switch (kick) {
    case KickKind::kAhead:
      return options_.kick;
    case KickKind::kFarAhead:
      return options_.farKick;
    case KickKind::kLeft:
      return options_.kickLeft;
    case KickKind::kRight:
      return options_.kickRight;
  }
  return options_.kick;
}

void SoccerMind::kickBall() {
  isAtBall_ = true;
  if (now_.playsMotion) kickBegan_ = true;
  // Requested only until it begins: a motion that is still requested when it ends is repeated.
  intention_ = {};
  intention_.motion = kickBegan_ ? Intention::Motion::kStand : Intention::Motion::kKick;
  intention_.kick = motionOf(kick_);
  intention_.head = Intention::Head::kTrack;
}

void SoccerMind::stepBack() {
  intention_ = {};
  intention_.motion = Intention::Motion::kWalk;
  intention_.forward = -options_.skills.backwardSpeed;
  intention_.head = Intention::Head::kTrack;
}

}  // namespace modules
