// SPDX-License-Identifier: GPL-3.0-or-later
// The solution "soccer" of the task "behavior": a player of a team.
#include <algorithm>
#include <array>
#include <cmath>

#include "BehaviorParameters.pb.h"
#include "modules/behavior/BehaviorRequests.h"
#include "modules/behavior/OptionReport.h"
#include "modules/behavior/SituationReader.h"
#include "modules/behavior/SoccerPlayer.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::kAboveZero;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::Pose2;
using robotlink::Vector2;

const robotlink::RobotDrawingKey kSoccerStateKey{
    "behavior/option",
    "Role, option and state of a soccer player, next to the robot (drawn around the robot)"};
const robotlink::FieldDrawingKey kSoccerPlanKey{
    "behavior/plan",
    "Where a soccer player walks to, where it plays the ball to, and its position (drawn on the field)"};
const robotlink::FieldDrawingKey kSoccerTeamKey{
    "behavior/team", "What a soccer player knows about its team from messages (drawn on the field)"};
const robotlink::PlotKey kSoccerBidKey{"behavior/seconds-to-ball",
                                       "Estimated time to reach the ball, its own and its team's (plots, s)"};
const robotlink::PlotKey kSoccerRoleKey{"behavior/role",
                                        "1 goalie, 2 defender, 3 supporter, 4 striker (plot)"};

struct SoccerChoices {
  SoccerPlayer::Options player;
  SituationReader::Options situation;
  double messagePeriod = 0.2;
};

using Skills = robotcontrol::BallSkillParameters;
using Reading = robotcontrol::SituationParameters;
using Fields = robotcontrol::SoccerParameters;

template <auto Member>
double& skill(SoccerChoices& o) {
  return o.player.skills.*Member;
}
template <auto Member>
double& reading(SoccerChoices& o) {
  return o.situation.*Member;
}
template <auto Member>
double& playing(SoccerChoices& o) {
  return o.player.*Member;
}
template <auto Member>
double& rolling(SoccerChoices& o) {
  return o.player.roll.*Member;
}
template <auto Member>
double& placing(SoccerChoices& o) {
  return o.player.places.*Member;
}
template <auto Member>
double& kicking(SoccerChoices& o) {
  return o.player.kicks.*Member;
}
template <auto Member>
double& role(SoccerChoices& o) {
  return o.player.roles.*Member;
}

constexpr int kSkills = Fields::kSkillsFieldNumber;
constexpr int kReading = Fields::kSituationFieldNumber;
using B = BallSkills::Options;
using S = SituationReader::Options;
using P = SoccerMind::Options;
using T = TeamPlaces::Options;
using R = RoleAssignment::Options;
using K = KickPlanner::Options;

const robotlink::ParameterTable<SoccerChoices> kSoccerTable{
    {{kSkills, Skills::kForwardSpeedFieldNumber}, skill<&B::forwardSpeed>, kAboveZero},
    {{kSkills, Skills::kBackwardSpeedFieldNumber}, skill<&B::backwardSpeed>, kAboveZero},
    {{kSkills, Skills::kSidewardSpeedFieldNumber}, skill<&B::sidewardSpeed>, kAboveZero},
    {{kSkills, Skills::kTurnSpeedFieldNumber}, skill<&B::turnSpeed>, kAboveZero},
    {{kSkills, Skills::kTurnGainFieldNumber}, skill<&B::turnGain>, kAboveZero},
    {{kSkills, Skills::kWalkGainFieldNumber}, skill<&B::walkGain>, kAboveZero},
    {{kSkills, Skills::kNearbyFieldNumber}, skill<&B::nearby>, kAtLeastZero},
    {{kSkills, Skills::kRobotRadiusFieldNumber}, skill<&B::robotRadius>, kAtLeastZero},
    {{kSkills, Skills::kDuelRadiusFieldNumber}, skill<&B::duelRadius>, kAtLeastZero},
    {{kSkills, Skills::kClearDistanceFieldNumber}, skill<&B::clearDistance>, kAtLeastZero},
    {{kSkills, Skills::kRobotRangeFieldNumber}, skill<&B::robotRange>, kAtLeastZero},
    {{kSkills, Skills::kStandOffFieldNumber}, skill<&B::standOff>, kAboveZero},
    {{kSkills, Skills::kPassingFieldNumber}, skill<&B::passing>, kAboveZero},
    {{kSkills, Skills::kKickXFieldNumber}, skill<&B::kickX>, kAtLeastZero},
    {{kSkills, Skills::kKickToleranceXFieldNumber}, skill<&B::kickToleranceX>, kAtLeastZero},
    {{kSkills, Skills::kKickToleranceYFieldNumber}, skill<&B::kickToleranceY>, kAtLeastZero},
    {{kSkills, Skills::kFarXFieldNumber}, skill<&B::farX>, kAtLeastZero},
    {{kSkills, Skills::kFarToleranceXFieldNumber}, skill<&B::farToleranceX>, kAtLeastZero},
    {{kSkills, Skills::kFarToleranceYFieldNumber}, skill<&B::farToleranceY>, kAtLeastZero},
    {{kSkills, Skills::kSideXFieldNumber}, skill<&B::sideX>, kAtLeastZero},
    {{kSkills, Skills::kSideYFieldNumber}, skill<&B::sideY>},
    {{kSkills, Skills::kSideToleranceXFieldNumber}, skill<&B::sideToleranceX>, kAtLeastZero},
    {{kSkills, Skills::kSideToleranceYFieldNumber}, skill<&B::sideToleranceY>, kAtLeastZero},
    {{kSkills, Skills::kDribbleGainFieldNumber}, skill<&B::dribbleGain>, kAtLeastZero},
    {{kSkills, Skills::kDribbleWidthFieldNumber}, skill<&B::dribbleWidth>, kAboveZero},
    {{kSkills, Skills::kPositionGainFieldNumber}, skill<&B::positionGain>, kAboveZero},
    {{kSkills, Skills::kPositionSpeedFieldNumber}, skill<&B::positionSpeed>, kAboveZero},
    {{kSkills, Skills::kPositionTurnFieldNumber}, skill<&B::positionTurn>, kAboveZero},
    {{kReading, Reading::kPositionDeviationFieldNumber}, reading<&S::positionDeviation>, kAboveZero},
    {{kReading, Reading::kHeadingDeviationFieldNumber}, reading<&S::headingDeviation>, kAboveZero},
    {{kReading, Reading::kMinimumColoredFieldNumber}, reading<&S::minimumColored>, kShare},
    {{kReading, Reading::kTeamBallAfterFieldNumber}, reading<&S::teamBallAfter>, kAtLeastZero},
    {{kReading, Reading::kMateTimeoutFieldNumber}, reading<&S::mateTimeout>, kAtLeastZero},
    {{kReading, Reading::kRobotConfidenceFieldNumber}, reading<&S::robotConfidence>, kShare},
    {Fields::kBallDecelerationFieldNumber, rolling<&RollingBall::deceleration>, kAtLeastZero},
    {Fields::kBallDampingFieldNumber, rolling<&RollingBall::damping>, kAtLeastZero},
    {Fields::kInterceptTimeFieldNumber, playing<&P::interceptTime>, kAtLeastZero},
    {Fields::kKickDelayFieldNumber, playing<&P::kickDelay>, kAtLeastZero},
    {Fields::kLookAboutTimeFieldNumber, playing<&P::lookAboutTime>, kAtLeastZero},
    {Fields::kTurnTimeFieldNumber, playing<&P::turnTime>, kAtLeastZero},
    {Fields::kWanderTimeFieldNumber, playing<&P::wanderTime>, kAtLeastZero},
    {Fields::kBlindAfterFieldNumber, playing<&P::blindAfter>, kAtLeastZero},
    {Fields::kLostAfterFieldNumber, playing<&P::lostAfter>, kAtLeastZero},
    {Fields::kGlanceTimeFieldNumber, playing<&P::glanceTime>, kAtLeastZero},
    {Fields::kGlanceAgainFieldNumber, playing<&P::glanceAgain>, kAtLeastZero},
    {Fields::kGlanceDistanceFieldNumber, playing<&P::glanceDistance>, kAtLeastZero},
    {Fields::kLookUpAfterFieldNumber, playing<&P::lookUpAfter>, kAtLeastZero},
    {Fields::kLookUpTimeFieldNumber, playing<&P::lookUpTime>, kAtLeastZero},
    {Fields::kAlignToleranceFieldNumber, playing<&P::alignTolerance>, kAboveZero},
    {Fields::kAlignLostFieldNumber, playing<&P::alignLost>, kAboveZero},
    {Fields::kDribbleDistanceFieldNumber, playing<&P::dribbleDistance>, kAboveZero},
    {Fields::kDribbleLostFieldNumber, playing<&P::dribbleLost>, kAboveZero},
    {Fields::kKickRangeFieldNumber, playing<&P::kickRange>, kAtLeastZero},
    {Fields::kKickPressureFieldNumber, playing<&P::kickPressure>, kAtLeastZero},
    {Fields::kKickToleranceFieldNumber, playing<&P::kickTolerance>, kAboveZero},
    {Fields::kPositionTimeFieldNumber, playing<&P::positionTime>, kAtLeastZero},
    {Fields::kKickTimeoutFieldNumber, playing<&P::kickTimeout>, kAboveZero},
    {Fields::kGoalieDistanceFieldNumber, placing<&T::goalieDistance>, kAboveZero},
    {Fields::kGoalieMarginFieldNumber, playing<&P::goalieMargin>, kAtLeastZero},
    {Fields::kOwnAreaMarginFieldNumber, playing<&P::ownAreaMargin>},
    {Fields::kDefenderDistanceFieldNumber, placing<&T::defenderDistance>, kAtLeastZero},
    {Fields::kSupporterBackFieldNumber, placing<&T::supporterBack>, kAtLeastZero},
    {Fields::kSupporterAsideFieldNumber, placing<&T::supporterAside>, kAtLeastZero},
    {Fields::kBeforeGoalFieldNumber, placing<&T::beforeGoal>, kAtLeastZero},
    {Fields::kWallDistanceFieldNumber, placing<&T::wallDistance>, kAtLeastZero},
    {Fields::kPlaceToleranceFieldNumber, playing<&P::placeTolerance>, kAboveZero},
    {Fields::kPlaceAngleFieldNumber, playing<&P::placeAngle>, kAboveZero},
    {Fields::kKickOffWaitFieldNumber, playing<&P::kickOffWait>, kAtLeastZero},
    {Fields::kStrikerAdvantageFieldNumber, role<&R::strikerAdvantage>, kAtLeastZero},
    {Fields::kDefenderAdvantageFieldNumber, role<&R::defenderAdvantage>, kAtLeastZero},
    {Fields::kLonelyAfterFieldNumber, role<&R::lonelyAfter>, kAtLeastZero},
    {Fields::kKickLengthFieldNumber, kicking<&K::kickLength>, kAboveZero},
    {Fields::kFarLengthFieldNumber, kicking<&K::farLength>, kAboveZero},
    {Fields::kFarSpreadFieldNumber, kicking<&K::farSpread>, kAtLeastZero},
    {Fields::kFarClearanceFieldNumber, kicking<&K::farClearance>, kAtLeastZero},
    {Fields::kFarSecondsFieldNumber, kicking<&K::farSeconds>, kAtLeastZero},
    {Fields::kHasteFieldNumber, kicking<&K::haste>, kAtLeastZero},
    {Fields::kHasteDistanceFieldNumber, kicking<&K::hasteDistance>, kAtLeastZero},
    {Fields::kFarDelayFieldNumber, playing<&P::farDelay>, kAtLeastZero},
    {Fields::kKickSpreadFieldNumber, kicking<&K::kickSpread>, kAtLeastZero},
    {Fields::kSideLengthFieldNumber, kicking<&K::sideLength>, kAboveZero},
    {Fields::kSideSpreadFieldNumber, kicking<&K::sideSpread>, kAtLeastZero},
    {Fields::kSecondsPerKickFieldNumber, kicking<&K::secondsPerKick>, kAtLeastZero},
    {Fields::kSecondsPerMeterFieldNumber, kicking<&K::secondsPerMeter>, kAtLeastZero},
    {Fields::kWallSecondsFieldNumber, kicking<&K::wallSeconds>, kAtLeastZero},
    {Fields::kOccupiedSecondsFieldNumber, kicking<&K::occupiedSeconds>, kAtLeastZero},
    {Fields::kStoppedSecondsFieldNumber, kicking<&K::stoppedSeconds>, kAtLeastZero},
    {Fields::kKeepSecondsFieldNumber, kicking<&K::keepSeconds>, kAtLeastZero},
    {Fields::kCoveredDistanceFieldNumber, playing<&P::coveredDistance>, kAtLeastZero},
    {Fields::kCoveredAfterFieldNumber, playing<&P::coveredAfter>, kAtLeastZero},
    {Fields::kStepBackTimeFieldNumber, playing<&P::stepBackTime>, kAtLeastZero},
    {Fields::kMessagePeriodFieldNumber, &SoccerChoices::messagePeriod, kAboveZero}};

SoccerChoices choices(const robotcontrol::SoccerParameters& parameters) {
  SoccerChoices chosen = kSoccerTable.read(parameters);
  if (!parameters.kick().empty()) chosen.player.kick = parameters.kick();
  chosen.player.farKick = parameters.far_kick();
  if (chosen.player.farKick.empty()) chosen.player.kicks.farClearance = 0;
  if (!parameters.kick_left().empty()) chosen.player.kickLeft = parameters.kick_left();
  if (!parameters.kick_right().empty()) chosen.player.kickRight = parameters.kick_right();
  return chosen;
}

class Soccer final : public robotlink::Solution {
 public:
  explicit Soccer(robotlink::SolutionContext& context)
      : context_(context),
        parameters_(context.parameters<robotcontrol::SoccerParameters>()),
        requests_(context),
        report_(context, "soccer"),
        reader_(context),
        message_(context.output(robotlink::kTeamMessage)),
        pose_(context.input(robotlink::kRobotPose)),
        ball_(context.input(robotlink::kBallModel)),
        player_(*context.robot().field, choices(parameters_).player) {}

  void execute() override {
    const SoccerChoices chosen = choices(parameters_);
    player_.setOptions(chosen.player);
    player_.setControl(optionControl(parameters_.control()));
    checkForced();
    now_ = reader_.read(chosen.situation);
    requests_.send(player_.decide(now_));
    report_.send(player_.machine());
    if (now_.time - sentAt_ >= chosen.messagePeriod) sendToTeam();
    publish();
  }

 private:
  /// Says once what of the states that a file or a log forces does not exist.
  void checkForced() {
    const std::string& forced = parameters_.control().forced();
    if (forced == forced_) return;
    forced_ = forced;
    const std::string wrong = player_.machine().wrongWith(forced);
    if (wrong.empty()) return;
    context_.debug().text(robotlink::Level::kError, "behavior",
                          "a part of control.forced = \"" + forced + "\" has no effect: " + wrong);
  }

  void sendToTeam() {
    sentAt_ = now_.time;
    auto message = std::make_shared<robotcontrol::TeamMessage>();
    robotlink::assign(*message->mutable_timestamp(), context_.clock().now());
    message->set_sender(context_.robot().name);
    message->set_team(reader_.team());
    message->set_number(static_cast<std::uint32_t>(std::max(0, now_.number)));
    if (pose_) {
      *message->mutable_pose_in_field() = pose_->robot_in_field();
      message->set_position_deviation(pose_->position_deviation());
      message->set_heading_deviation(pose_->heading_deviation());
    }
    if (pose_ && ball_ && ball_->known()) {
      const Pose2 robotInField = robotlink::pose2(pose_->robot_in_field());
      message->set_ball_known(true);
      robotlink::assign(*message->mutable_ball_in_field(),
                        robotInField * robotlink::vector2(ball_->position_in_robot()));
      robotlink::assign(
          *message->mutable_ball_velocity_in_field(),
          Vector2(Eigen::Rotation2Dd(robotInField.heading) * robotlink::vector2(ball_->velocity_in_robot())));
      message->set_ball_deviation(ball_->standard_deviation());
      message->set_seconds_since_ball_seen(now_.ballFromTeam ? ball_->seconds_since_seen() : now_.ballAge);
    }
    message->set_role(name(player_.role()));
    message->set_seconds_to_ball(player_.secondsToBall());
    const auto& active = player_.machine().active();
    if (!active.empty()) message->set_state(active.back().state->name());
    message_.send(std::move(message));
  }

  void publish() {
    robotlink::DebugContext& debug = context_.debug();
    if (debug.on(kSoccerRoleKey)) debug.plot(kSoccerRoleKey, static_cast<double>(player_.role()));
    if (debug.on(kSoccerBidKey)) {
      debug.plot(kSoccerBidKey, "own", player_.secondsToBall(), "s");
      for (const Mate& mate : now_.mates)
        debug.plot(kSoccerBidKey, ("mate-" + std::to_string(mate.number)).c_str(), mate.secondsToBall, "s");
    }
    if (debug.on(kSoccerStateKey)) {
      const auto& active = player_.machine().active();
      const std::string text =
          std::string(name(player_.role())) + ", " +
          (active.empty() ? "" : active.back().option->name() + ": " + active.back().state->name());
      debug.robotDrawing(kSoccerStateKey).text(Vector2(-0.2, 0.2), text, robotlink::colors::kBlack);
    }
    if (debug.on(kSoccerPlanKey)) drawPlan();
    if (debug.on(kSoccerTeamKey)) drawTeam();
  }

  void drawPlan() {
    auto drawing = context_.debug().fieldDrawing(kSoccerPlanKey);
    if (!pose_) return;
    const Pose2 robot = robotlink::pose2(pose_->robot_in_field());
    if (player_.target()) {
      const Vector2 target = robot * *player_.target();
      drawing.line(robot.translation(), target, robotlink::colors::kRed);
      drawing.dot(target, robotlink::colors::kRed);
    }
    if (const auto aim = player_.aim()) {
      const Vector2 ball = robot * now_.ball;
      const Vector2 way(std::cos(robot.heading + *aim), std::sin(robot.heading + *aim));
      drawing.arrow(ball, ball + 0.4 * way, robotlink::colors::kYellow, 2);
    }
  }

  void drawTeam() {
    auto drawing = context_.debug().fieldDrawing(kSoccerTeamKey);
    const Pose2 team = reader_.teamInField();
    for (const Mate& mate : now_.mates) {
      const Vector2 place = team * mate.pose.translation();
      drawing.circle(place, 0.15, robotlink::colors::kSkyBlue, 2);
      drawing.text(place + Vector2(0.15, 0.15), std::to_string(mate.number) + " " + name(mate.role),
                   robotlink::colors::kBlack);
    }
  }

  robotlink::SolutionContext& context_;
  const robotcontrol::SoccerParameters& parameters_;
  BehaviorRequests requests_;
  OptionReport report_;
  SituationReader reader_;
  robotlink::Output<robotcontrol::TeamMessage> message_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Input<robotcontrol::BallModel> ball_;
  SoccerPlayer player_;
  /// BehaviorControl::forced in the last frame.
  std::string forced_;
  GameSituation now_;
  double sentAt_ = -1e9;
};

robotlink::ParameterRules soccerRules() {
  auto rules = kSoccerTable.rules<Fields>();
  rules.check = [](const google::protobuf::Message& wanted) -> std::string {
    const std::string& forced = dynamic_cast<const Fields&>(wanted).control().forced();
    const std::string wrong = SoccerPlayer({}, {}).machine().wrongWith(forced);
    return wrong.empty() ? "" : "'control.forced' cannot be \"" + forced + "\": " + wrong;
  };
  return rules;
}

const robotlink::SolutionRegistration kSoccer =
    SituationReader::declareInputs(
        robotlink::SolutionBuilder<Soccer>(
            "behavior", "soccer",
            "Plays in a team as goalie, defender, supporter or striker, using a hierarchy of state machines: "
            "the phase of the game, the role agreed with its team by messages, and ball skills.")
            .source(
                "M. L\u00f6tzsch, J. Bach, H.-D. Burkhard, M. J\u00fcngel: Designing agent behavior with the "
                "extensible agent behavior specification language XABSL, RoboCup 2003; D. Vail, M. Veloso: "
                "Dynamic multi-robot coordination, 2003."))
        .yields(robotlink::kMotionRequest)
        .yields(robotlink::kHeadMode)
        .yields(robotlink::kBehaviorState)
        .yields(robotlink::kBehaviorGraph)
        .yields(robotlink::kTeamMessage)
        .keys({&kSoccerStateKey, &kSoccerPlanKey, &kSoccerTeamKey, &kSoccerBidKey, &kSoccerRoleKey,
               &kBehaviorSpeedKey, &kBehaviorWalkKey})
        .parameters<Fields>(soccerRules());

}  // namespace
}  // namespace modules
