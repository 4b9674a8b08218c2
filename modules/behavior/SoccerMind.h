// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "modules/RollingBall.h"
#include "modules/behavior/BallSkills.h"
#include "modules/behavior/GameSituation.h"
#include "modules/behavior/KickPlanner.h"
#include "modules/behavior/OptionMachine.h"
#include "modules/behavior/RoleAssignment.h"
#include "modules/behavior/TeamPlaces.h"

namespace modules {

/// The knowledge and skills of a soccer player: the conditions and actions of its options, on plain
/// values. SoccerOptions builds the options, SoccerPlayer runs them. Not thread-safe; it must not be moved,
/// because the options refer to it.
class SoccerMind {
 public:
  struct Options {
    BallSkills::Options skills;
    TeamPlaces::Options places;
    RoleAssignment::Options roles;
    KickPlanner::Options kicks;
    RollingBall roll;
    /// For how long it predicts at most where it meets a rolling ball, s.
    double interceptTime = 2;
    /// From the decision to kick until the ball is hit, and the same of the far kick, s.
    double kickDelay = 0.25, farDelay = 0.5;
    /// Search: time for which it looks about before it turns, of a turn, and of the walk after it, s.
    double lookAboutTime = 2.0, turnTime = 7, wanderTime = 5;
    /// Time without colors of the field after which it stands still, s.
    double blindAfter = 1;
    /// Time without seeing the ball after which it is searched, s.
    double lostAfter = 3;
    /// A ball that was nearer than this when it vanished may lie under the body, m; then the robot steps back
    /// after, and for some time, s.
    double coveredDistance = 0.17, coveredAfter = 0.6, stepBackTime = 1.6;
    /// The time for which it looks for beacons and goals, and the least time between two looks, s.
    double glanceTime = 1.2, glanceAgain = 6;
    /// Distance of the ball from which on it does so while it walks, m.
    double glanceDistance = 0.8;
    /// Next to the ball, where others turn it, it looks up for landmarks if it has seen none for this long,
    /// for at most this time, s.
    double lookUpAfter = 1.5, lookUpTime = 0.9;
    /// Angle between ball and aim up to which it pushes the ball, and from which on it goes behind it again,
    /// rad.
    double alignTolerance = 0.3, alignLost = 0.9;
    /// Distance of the ball up to which it pushes it, and from which on it approaches it again, m.
    double dribbleDistance = 0.36, dribbleLost = 0.55;
    /// The robot kicks instead of pushing when the goal is no farther than this, or an opponent this near, m.
    /// Always by default: the ERS-210 steps over a ball that it pushes.
    double kickRange = 9, kickPressure = 0.45;
    /// The maximum times for positioning the ball before the chest, and for trying a kick, s.
    double positionTime = 4, kickTimeout = 5;
    /// Angle up to which it kicks, rad.
    double kickTolerance = 0.3;
    /// Margin around the penalty area in which the goalie goes for the ball, m.
    double goalieMargin = 0.15;
    /// Margin around it in which the others leave the ball to the goalie, m: there they may not be.
    double ownAreaMargin = 0.05;
    /// The tolerance with which a player stands at its place, m and rad.
    double placeTolerance = 0.12, placeAngle = 0.3;
    /// The time that it waits for the other team's kick-off, s.
    double kickOffWait = 6;
    /// The key-frame motion of a kick straight ahead.
    std::string kick = "kick-forward";
    /// The key-frame motion of the far kick straight ahead, for which `kicks` has a clearance.
    std::string farKick;
    /// The key-frame motions of kicks to the left and to the right.
    std::string kickLeft = "kick-to-left", kickRight = "kick-to-right";
  };

  /// `field` is that of the places.
  SoccerMind(const robotlink::FieldDescription& field, const Options& options);
  SoccerMind(const SoccerMind&) = delete;
  SoccerMind& operator=(const SoccerMind&) = delete;

  /// Takes effect with the next decide(); the places stay those of the constructor.
  void setOptions(const Options& options);
  void setControl(OptionMachine::Control control) { machine_.setControl(std::move(control)); }

  /// Brings everything up to date that conditions and actions read, runs the options, and returns what the
  /// action of the last one wants. Call it once a frame.
  Intention decide(const GameSituation& now);

  const OptionMachine& machine() const { return machine_; }
  Role role() const { return roles_.role(); }
  /// The estimate that the team receives, s.
  double secondsToBall() const { return secondsToBall_; }
  // For drawings: where it walks to, in the robot's frame, and the direction in which it plays the ball.
  const std::optional<robotlink::Vector2>& target() const { return target_; }
  std::optional<double> aim() const;

 private:
  friend class SoccerOptions;

  /// Brings everything up to date that conditions and actions read.
  void observe(const GameSituation& now);
  /// Chooses the kick, and returns the direction to which the robot turns for it, in the robot's frame; the
  /// direction to the ball while the robot does not know where it is.
  double playDirection();
  /// The ball's position after that time, in the present frame of the robot.
  robotlink::Vector2 ballAfter(double seconds) const;
  /// The ball's position when the present kick hits it.
  robotlink::Vector2 ballAtKick() const;
  /// The point where the robot meets the ball if it walks there.
  robotlink::Vector2 meetingPoint() const;
  /// The angle up to which a ball that is played now goes into the goal; unset if the pose is unknown.
  double distanceToGoal() const;
  bool isUnderPressure() const;
  std::vector<robotlink::Vector2> matesInTeam() const;
  bool shouldKick() const;
  /// The ball is where only the goalie may play it, and there is one.
  bool isForGoalie() const;
  bool isAtPlace() const;
  bool mustGlance() const;
  /// Turns the head to beacons and goals if none was seen for long; call it next to the ball.
  void lookUp();
  /// Whether the ball, last seen at the paws, may now lie hidden under the robot's body.
  bool coversBall() const;
  /// Whether the robot is stepping back from a ball under its body that has not become visible yet.
  bool uncoversBall() const;
  /// Whether the robot stands still and has lost sight of a ball that was next to it.
  bool hidesBall() const;

  // Actions.
  void stand(Intention::Head head);
  void walkToPlace(const robotlink::Pose2& placeInTeam);
  void approachBall();
  void kickBall();
  const std::string& motionOf(KickKind kick) const;
  void stepBack();

  Options options_;
  TeamPlaces places_;
  BallSkills skills_;
  KickPlanner kicks_;
  RoleAssignment roles_;
  OptionMachine machine_;
  GameSituation now_;
  Intention intention_;
  std::optional<robotlink::Vector2> target_;
  /// The point where it meets the ball, in the robot's frame.
  robotlink::Vector2 meets_ = robotlink::Vector2::Zero();
  /// In the robot's frame, rad.
  double aim_ = 0;
  /// The kick for which it turns there.
  KickKind kick_ = KickKind::kAhead;
  /// The last action was one at the ball, where the choice of a kick is kept.
  bool isAtBall_ = false;
  bool isLeftToGoalie_ = false;
  double secondsToBall_ = 1e3;
  /// The place of the player of the present option, in the team's frame.
  robotlink::Pose2 place_;
  /// The position where it last saw the ball, in the robot's frame at that time.
  robotlink::Vector2 lastBall_ = robotlink::Vector2::UnitX();
  /// 1 to the left, -1 to the right.
  double turnDirection_ = 1;
  double ballSeenAt_ = -1e9, ballKnownAt_ = -1e9, fieldSeenAt_ = 0, glancedAt_ = -1e9, lookedUpAt_ = -1e9,
         uncoveringSince_ = -1e9, playingSince_ = 0;
  bool started_ = false;
  /// The motion task confirmed that the kick is being played.
  bool kickBegan_ = false;
  /// Whether the ball has left its place since the other team's kick-off.
  bool ballMoved_ = true;
  std::optional<robotlink::Vector2> ballAtKickOff_;
};

}  // namespace modules
