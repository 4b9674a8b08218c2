// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a soccer player. Their helps are what the Behavior view shows.
#include "modules/behavior/SoccerOptions.h"

#include <cmath>

namespace modules {

using robotlink::Vector2;
using Phase = GameSituation::Phase;

OptionMachine::Action SoccerOptions::stands(Head head) const {
  return [&player = player_, head] { player.stand(head); };
}

OptionMachine::Condition SoccerOptions::after(double SoccerMind::Options::*limit) const {
  return [&player = player_, limit] { return player.machine_.stateTime() > player.options_.*limit; };
}

OptionMachine::Condition SoccerOptions::isLost() const {
  return [&player = player_] {
    return !player.now_.knowsBall ||
           (player.now_.ballFromTeam ? false : player.now_.ballAge > player.options_.lostAfter);
  };
}

void SoccerOptions::build() {
  Option& game = machine_.option("game", "Acts according to the phase of the game.");
  Option& playing = machine_.option("playing", "Acts according to its role in the team.");
  Option& strike = machine_.option("strike", "Gets behind the ball, and plays it into the goal.");
  Option& keepGoal =
      machine_.option("keep goal", "Stays between ball and goal, and clears balls that come near.");
  Option& place = machine_.option("take place", "Walks to a position on the field, and stays there.");
  Option& search = machine_.option("search", "Finds the ball.");
  buildGame(game, playing, place);
  buildPlaying(playing, strike, keepGoal, place);
  buildStrike(strike, search);
  buildAtBall(strike);
  buildKeepGoal(keepGoal, strike, place);
  buildPlace(place);
  buildSearch(search);
}

void SoccerOptions::buildGame(Option& game, Option& playing, Option& place) const {
  SoccerMind& p = player_;
  const auto phase = [&p](Phase wanted) { return [&p, wanted] { return p.now_.phase == wanted; }; };
  game.state("play", "The game is on, or there is no referee.").activates(playing);
  game.state("initial", "Before the game.").does(stands(Head::kAhead));
  game.state("ready", "Walks to its position for the kick-off.")
      .does([&p] { p.place_ = p.places_.kickOff(p.now_.number, p.role() == Role::kGoalie); })
      .activates(place);
  game.state("set", "Waits for the kick-off and looks for the ball.").does(stands(Head::kSearch));
  game.state("penalized", "Stands until the penalty is over.").does(stands(Head::kAhead));
  game.state("finished", "After the game.").does(stands(Head::kAhead));
  game.state("picked up", "The robot is being carried.").does(stands(Head::kAhead));
  game.state("get up", "Gets up after a fall.").does([&p] {
    p.stand(Head::kAhead);
    p.intention_.motion = Intention::Motion::kGetUp;
  });
  game.always("picked up", "it was picked up", [&p] { return p.now_.pickedUp; })
      .always("get up", "it has fallen", [&p] { return !p.now_.pickedUp && p.now_.fallen; })
      .always("penalized", "the referee has penalized it",
              [&p] { return !p.now_.pickedUp && !p.now_.fallen && p.now_.penalized; });
  const auto isFree = [&p] { return !p.now_.pickedUp && !p.now_.fallen && !p.now_.penalized; };
  const auto add = [&](const char* state, const char* reason, Phase wanted) {
    game.always(state, reason, [isFree, is = phase(wanted)] { return isFree() && is(); });
  };
  add("initial", "the game has not begun", Phase::kInitial);
  add("ready", "the teams go to their positions", Phase::kReady);
  add("set", "the kick-off is next", Phase::kSet);
  add("finished", "the game is over", Phase::kFinished);
  add("play", "the game is on", Phase::kPlaying);
}

void SoccerOptions::buildPlaying(Option& playing, Option& strike, Option& keepGoal, Option& place) const {
  SoccerMind& p = player_;
  playing.state("decide", "Has no role yet.").does(stands(Head::kSearch));
  playing.state("wait", "Leaves the ball to the other team, which has the kick-off.")
      .does(stands(Head::kSearch));
  playing.state("return", "Walks back onto the field.").does([&p] {
    if (!p.now_.pose) return;
    const Vector2 inside = p.places_.inside(p.now_.pose->translation());
    p.walkToPlace({inside.x(), inside.y(), std::atan2(-inside.y(), -inside.x())});
  });
  playing.state("goalie", "Keeps the goal.").activates(keepGoal);
  playing.state("defender", "Stands between ball and goal.")
      .does([&p] { p.place_ = p.places_.defender(p.now_.ballInTeam().value_or(Vector2::Zero())); })
      .activates(place);
  playing.state("supporter", "Supports the striker from nearby, to recover lost balls.")
      .does([&p] { p.place_ = p.places_.supporter(p.now_.ballInTeam().value_or(Vector2::Zero())); })
      .activates(place);
  playing.state("striker", "Plays the ball.").activates(strike);
  playing.state("leave", "Leaves a ball in its own penalty area to the goalie, and waits outside.")
      .does([&p] { p.place_ = p.places_.beforeArea(p.now_.ballInTeam().value_or(Vector2::Zero())); })
      .activates(place);
  playing.state("uncover", "Steps back from a ball that may lie under its body.")
      .begins([&p] { p.uncoveringSince_ = p.now_.time; })
      .does([&p] { p.stepBack(); });
  // A kick is played to its end.
  const auto isFree = [&p] { return p.now_.stable && !p.now_.playsMotion; };
  const auto isOut = [&p] { return p.now_.pose && p.places_.isOutside(p.now_.pose->translation()); };
  const auto isWaiting = [&p] {
    return !p.now_.ownKickOff && !p.ballMoved_ && p.role() != Role::kGoalie &&
           p.now_.time - p.playingSince_ < p.options_.kickOffWait;
  };
  playing.always("return", "it has left the field", [=] { return isFree() && isOut(); })
      .always("wait", "the other team has the kick-off", [=] { return isFree() && !isOut() && isWaiting(); });
  const auto uncovers = [&p] { return p.uncoversBall() || p.coversBall(); };
  playing.always("uncover", "the ball vanished in front of its paws, or the team sees it there",
                 [=] { return isFree() && !isOut() && !isWaiting() && uncovers(); });
  const auto leaves = [&p] { return p.role() == Role::kStriker && p.isForGoalie(); };
  playing.always("leave", "the ball is where only the goalie may play it",
                 [=] { return isFree() && !isOut() && !isWaiting() && !uncovers() && leaves(); });
  const auto add = [&](const char* state, const char* reason, Role role) {
    playing.always(state, reason, [=, &p] {
      return isFree() && !isOut() && !isWaiting() && !uncovers() && !leaves() && p.role() == role;
    });
  };
  add("goalie", "it keeps the goal", Role::kGoalie);
  add("defender", "it is the closest one to its own goal", Role::kDefender);
  add("supporter", "others reach the ball sooner", Role::kSupporter);
  add("striker", "it reaches the ball first", Role::kStriker);
}

void SoccerOptions::buildKeepGoal(Option& keepGoal, Option& strike, Option& place) const {
  SoccerMind& p = player_;
  const auto ballNear = [&p](double margin) {
    const auto ball = p.now_.ballInTeam();
    return ball && p.now_.ballAge < p.options_.lostAfter && p.places_.isGoaliesBall(*ball, margin);
  };
  keepGoal.state("guard", "Stays on the line between the ball and the center of the goal.")
      .does([&p] { p.place_ = p.places_.goalie(p.now_.ballInTeam().value_or(Vector2::Zero())); })
      .activates(place)
      .to("turn to ball", "the ball vanished next to it", [&p] { return p.hidesBall(); })
      .to("clear", "the ball is near the goal", [&p, ballNear] { return ballNear(p.options_.goalieMargin); });
  // No camera sees a ball next to the body.
  keepGoal.state("turn to ball", "Turns to where a nearby ball vanished.")
      .does([&p] {
        p.intention_ = p.skills_.turnTo(std::atan2(p.lastBall_.y(), p.lastBall_.x()));
        p.intention_.head = Head::kSearch;
      })
      .to("clear", "there is the ball", [&p, ballNear] { return p.now_.seesBall() && ballNear(0); })
      .to("guard", "it is not there", after(&SoccerMind::Options::stepBackTime));
  keepGoal.state("clear", "Plays the ball away from the goal.")
      .activates(strike)
      .to("guard", "the ball is away", [&p, ballNear] {
        return p.now_.stable && !p.now_.playsMotion && !ballNear(p.options_.goalieMargin + 0.2);
      });
}

void SoccerOptions::buildStrike(Option& strike, Option& search) const {
  SoccerMind& p = player_;
  strike.state("search", "Does not know where the ball is.")
      .activates(search)
      .to("approach", "the ball is seen", [&p] { return p.now_.seesBall(); })
      .to("approach", "the team knows the ball", [&p] { return p.now_.ballFromTeam && p.now_.knowsBall; });
  const auto isNear = [&p](double factor) {
    return p.now_.ball.norm() < factor * p.options_.dribbleDistance && p.now_.seesBall();
  };
  const auto isBehind = [&p] {
    return std::abs(BallSkills::offset(p.now_.ball, p.aim_)) < p.options_.alignTolerance &&
           std::abs(p.aim_) < 1.3 * p.options_.alignTolerance;
  };
  strike.state("approach", "Walks to the position behind the ball, around the ball if necessary.")
      .does([&p] { p.approachBall(); })
      .to("search", "the ball is lost", isLost())
      .to("glance", "near the ball, but where is the goal?",
          [&p, isNear] { return isNear(1.2) && !p.now_.pose && p.mustGlance(); })
      .to("position", "behind the ball, and the goal or an opponent is near",
          [&p, isNear, isBehind] { return isNear(1) && isBehind() && p.shouldKick(); })
      .to("dribble", "behind the ball", [isNear, isBehind] { return isNear(1) && isBehind(); });
  strike.state("glance", "Stands and looks for beacons and goals.")
      .begins([&p] { p.glancedAt_ = p.now_.time; })
      .does(stands(Head::kLookAround))
      .to("approach", "there is the goal", [&p] { return p.now_.pose && p.machine_.stateTime() > 0.3; })
      .to("approach", "nothing shows where the goal is",
          [&p] { return p.machine_.stateTime() > 2 * p.options_.glanceTime; });
}

void SoccerOptions::buildAtBall(Option& strike) const {
  SoccerMind& p = player_;
  const auto isAway = [&p] { return p.now_.ball.norm() > p.options_.dribbleLost; };
  const auto isBeside = [&p] {
    return std::abs(BallSkills::offset(p.now_.ball, p.aim_)) > p.options_.alignLost ||
           std::abs(p.aim_) > p.options_.alignLost;
  };
  strike.state("dribble", "Pushes the ball with the chest.")
      .does([&p] { p.intention_ = p.skills_.dribble(p.now_.ball, p.aim_); })
      .to("search", "the ball is lost", isLost())
      .to("approach", "the ball is away", isAway)
      .to("approach", "the goal is elsewhere", isBeside)
      .to("kick", "the ball is in front of the paws, and the goal or an opponent is near", [&p] {
        return p.shouldKick() && p.skills_.canKick(p.now_.ball, p.kick_) && p.now_.seesBall() &&
               std::abs(p.aim_) < p.options_.kickTolerance;
      });
  strike.state("position", "Walks the last centimeters to the position for the kick.")
      .does([&p] {
        p.intention_ = p.skills_.position(p.ballAtKick(), p.now_.ballVelocity, p.aim_, p.kick_);
        p.isAtBall_ = true;
        p.lookUp();
      })
      .to("search", "the ball is lost", isLost())
      .to("approach", "the ball is away", isAway)
      .to("approach", "the goal is elsewhere", isBeside)
      .to("kick", "the ball is in front of the paws",
          [&p] {
            return p.skills_.canKick(p.ballAtKick(), p.kick_) && p.now_.seesBall() &&
                   std::abs(p.aim_) < p.options_.kickTolerance;
          })
      .to("approach", "positioning takes too long", after(&SoccerMind::Options::positionTime));
  strike.state("kick", "Kicks with chest and head.")
      .begins([&p] { p.kickBegan_ = false; })
      .does([&p] { p.kickBall(); })
      .to("approach", "kicked", [&p] { return p.kickBegan_ && !p.now_.playsMotion && p.now_.stable; })
      .to("approach", "the kick did not end", after(&SoccerMind::Options::kickTimeout));
}

void SoccerOptions::buildPlace(Option& place) const {
  SoccerMind& p = player_;
  place.state("walk", "Walks there.")
      .does([&p] { p.walkToPlace(p.place_); })
      .to("stand", "it is there", [&p] { return p.isAtPlace(); });
  place.state("stand", "Stays there and watches the ball.")
      .does([&p] {
        p.stand(p.now_.knowsBall && !p.now_.ballFromTeam ? Head::kTrack : Head::kSearch);
        if (p.mustGlance()) p.glancedAt_ = p.now_.time;
        if (p.now_.time - p.glancedAt_ < p.options_.glanceTime) p.intention_.head = Head::kLookAround;
      })
      .to("walk", "the position has moved", [&p] {
        if (!p.now_.pose) return true;
        const auto rest = p.now_.pose->inverse() * p.place_;
        return rest.translation().norm() > 2 * p.options_.placeTolerance ||
               std::abs(rest.heading) > 2 * p.options_.placeAngle;
      });
}

void SoccerOptions::buildSearch(Option& search) const {
  SoccerMind& p = player_;
  const auto isBlind = [&p] { return p.now_.time - p.fieldSeenAt_ > p.options_.blindAfter; };
  search.state("look about", "Stands and moves its head.")
      .begins([&p] { p.turnDirection_ = p.now_.ball.y() < 0 ? -1 : 1; })
      .does(stands(Head::kSearch))
      .to("turn", "the head cannot point at the ball", after(&SoccerMind::Options::lookAboutTime));
  search.state("turn", "Turns on the spot.")
      .does([&p] {
        p.intention_ = p.skills_.turnTo(p.turnDirection_);
        // Sweeps of the head would leave out what the turn passes meanwhile.
        p.intention_.head = Head::kAhead;
      })
      .to("wander", "no ball in any direction", after(&SoccerMind::Options::turnTime));
  search.state("wander", "Walks to the center of the field, or ahead, to look from elsewhere.")
      .does([&p] {
        const Vector2 way = p.now_.pose ? p.now_.pose->inverse() * Vector2(0, 0) : Vector2(1, 0);
        p.intention_ = p.skills_.walkTo(way, std::atan2(way.y(), way.x()), p.now_.robots);
        p.intention_.head = Head::kSearch;
      })
      .to("look about", "look from here", after(&SoccerMind::Options::wanderTime));
  search.state("blind", "Nothing of the field is seen: stands still.")
      .does(stands(Head::kSearch))
      .to("look about", "the field is seen again", [isBlind] { return !isBlind(); });
  search.always("blind", "nothing of the field is seen", isBlind);
}

}  // namespace modules
