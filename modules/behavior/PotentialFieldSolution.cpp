// SPDX-License-Identifier: GPL-3.0-or-later
// The solution "potential-field" of the task "behavior": a reactive player.
#include <cmath>

#include "BehaviorParameters.pb.h"
#include "modules/BehaviorReport.h"
#include "modules/behavior/BehaviorRequests.h"
#include "modules/behavior/PotentialField.h"
#include "modules/behavior/SituationReader.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

const robotlink::RobotDrawingKey kForcesKey{"behavior/forces",
                                            "The forces on a robot and around it: ball orange, robots red, "
                                            "walls gray, their sum black (drawn "
                                            "around the robot)"};
const robotlink::PlotKey kForceKey{"behavior/force", "The sum of the forces on the robot (plots x, y, m/s)"};

struct FieldChoices {
  PotentialField::Options field;
  SituationReader::Options situation;
};

using ReactiveFields = robotcontrol::PotentialFieldParameters;
using ReactiveReading = robotcontrol::SituationParameters;
constexpr int kReactiveReading = ReactiveFields::kSituationFieldNumber;

template <auto Member>
double& fieldChoice(FieldChoices& o) {
  return o.field.*Member;
}
template <auto Member>
double& readingChoice(FieldChoices& o) {
  return o.situation.*Member;
}

using Forces = PotentialField::Options;
using Reader = SituationReader::Options;
const robotlink::ParameterTable<FieldChoices> kPotentialFieldTable{
    {{kReactiveReading, ReactiveReading::kPositionDeviationFieldNumber},
     readingChoice<&Reader::positionDeviation>,
     robotlink::kAboveZero},
    {{kReactiveReading, ReactiveReading::kHeadingDeviationFieldNumber},
     readingChoice<&Reader::headingDeviation>,
     robotlink::kAboveZero},
    {{kReactiveReading, ReactiveReading::kMinimumColoredFieldNumber},
     readingChoice<&Reader::minimumColored>,
     robotlink::kShare},
    {{kReactiveReading, ReactiveReading::kTeamBallAfterFieldNumber},
     readingChoice<&Reader::teamBallAfter>,
     robotlink::kAtLeastZero},
    {{kReactiveReading, ReactiveReading::kMateTimeoutFieldNumber},
     readingChoice<&Reader::mateTimeout>,
     robotlink::kAtLeastZero},
    {{kReactiveReading, ReactiveReading::kRobotConfidenceFieldNumber},
     readingChoice<&Reader::robotConfidence>,
     robotlink::kShare},
    {ReactiveFields::kForwardSpeedFieldNumber, fieldChoice<&Forces::forwardSpeed>, robotlink::kAboveZero},
    {ReactiveFields::kSidewardSpeedFieldNumber, fieldChoice<&Forces::sidewardSpeed>, robotlink::kAboveZero},
    {ReactiveFields::kTurnSpeedFieldNumber, fieldChoice<&Forces::turnSpeed>, robotlink::kAboveZero},
    {ReactiveFields::kTurnGainFieldNumber, fieldChoice<&Forces::turnGain>, robotlink::kAboveZero},
    {ReactiveFields::kAttractionFieldNumber, fieldChoice<&Forces::attraction>, robotlink::kAtLeastZero},
    {ReactiveFields::kSlowingFieldNumber, fieldChoice<&Forces::slowing>, robotlink::kAtLeastZero},
    {ReactiveFields::kSwirlFieldNumber, fieldChoice<&Forces::swirl>, robotlink::kAtLeastZero},
    {ReactiveFields::kSwirlRadiusFieldNumber, fieldChoice<&Forces::swirlRadius>, robotlink::kAboveZero},
    {ReactiveFields::kRepulsionFieldNumber, fieldChoice<&Forces::repulsion>, robotlink::kAtLeastZero},
    {ReactiveFields::kRepulsionRadiusFieldNumber, fieldChoice<&Forces::repulsionRadius>,
     robotlink::kAtLeastZero},
    {ReactiveFields::kWallRepulsionFieldNumber, fieldChoice<&Forces::wallRepulsion>, robotlink::kAtLeastZero},
    {ReactiveFields::kWallRadiusFieldNumber, fieldChoice<&Forces::wallRadius>, robotlink::kAtLeastZero},
    {ReactiveFields::kKickXFieldNumber, fieldChoice<&Forces::kickX>, robotlink::kAtLeastZero},
    {ReactiveFields::kKickToleranceXFieldNumber, fieldChoice<&Forces::kickToleranceX>,
     robotlink::kAtLeastZero},
    {ReactiveFields::kKickToleranceYFieldNumber, fieldChoice<&Forces::kickToleranceY>,
     robotlink::kAtLeastZero},
    {ReactiveFields::kKickAngleFieldNumber, fieldChoice<&Forces::kickAngle>, robotlink::kAtLeastZero},
    {ReactiveFields::kTurnAboutFieldNumber, fieldChoice<&Forces::turnAbout>, robotlink::kAtLeastZero}};

class ReactivePlayer final : public robotlink::Solution {
 public:
  explicit ReactivePlayer(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        parameters_(context.parameters<robotcontrol::PotentialFieldParameters>()),
        requests_(context),
        report_(context, "potential-field"),
        reader_(context),
        field_(*context.robot().field) {}

  void execute() override {
    FieldChoices chosen = kPotentialFieldTable.read(parameters_);
    if (!parameters_.kick().empty()) chosen.field.kick = parameters_.kick();
    field_.setOptions(chosen.field);
    const GameSituation now = reader_.read(chosen.situation);
    requests_.send(field_.decide(now));
    report_.send(field_.state(), field_.reason());
    publish(now);
  }

 private:
  void publish(const GameSituation& now) {
    const robotlink::Vector2 here = robotlink::Vector2::Zero();
    if (debug_.on(kForceKey)) {
      const robotlink::Vector2 sum = field_.force(now, here);
      debug_.plot(kForceKey, "x", sum.x(), "m/s");
      debug_.plot(kForceKey, "y", sum.y(), "m/s");
    }
    if (!debug_.on(kForcesKey)) return;
    auto drawing = debug_.robotDrawing(kForcesKey);
    drawing.arrow(here, field_.ballForce(now, here), robotlink::colors::kOrange, 2);
    drawing.arrow(here, field_.robotForce(now, here), robotlink::colors::kRed, 2);
    drawing.arrow(here, field_.wallForce(now, here), robotlink::colors::kGray, 2);
    for (int x = -4; x <= 4; ++x) {
      for (int y = -4; y <= 4; ++y) {
        const robotlink::Vector2 place(0.2 * x, 0.2 * y);
        drawing.arrow(place, place + 0.6 * field_.force(now, place), robotlink::colors::kBlack, 1);
      }
    }
  }

  robotlink::DebugContext& debug_;
  const robotcontrol::PotentialFieldParameters& parameters_;
  BehaviorRequests requests_;
  BehaviorReport report_;
  SituationReader reader_;
  PotentialField field_;
};

const robotlink::SolutionRegistration kPotentialField =
    SituationReader::declareInputs(
        robotlink::SolutionBuilder<ReactivePlayer>(
            "behavior", "potential-field",
            "Walks along the sum of the forces of ball, robots and walls, and kicks whenever the ball is in "
            "front of its chest and the goal ahead; has neither roles nor states.")
            .source(
                "O. Khatib: Real-time obstacle avoidance for manipulators and mobile robots, 1986; T. Laue, "
                "T. R\u00f6fer: A behavior architecture for autonomous mobile robots based on potential "
                "fields, RoboCup 2004."))
        .yields(robotlink::kMotionRequest)
        .yields(robotlink::kHeadMode)
        .yields(robotlink::kBehaviorState)
        .keys({&kForcesKey, &kForceKey, &kBehaviorSpeedKey, &kBehaviorWalkKey})
        .parameters<robotcontrol::PotentialFieldParameters>(
            kPotentialFieldTable.rules<robotcontrol::PotentialFieldParameters>());

}  // namespace
}  // namespace modules
