// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/ParameterConversion.h"

#include <cmath>

#include "MotionParameters.pb.h"

namespace modules {
namespace {

bool isShare(double value) {
  return value > 0 && value < 1;
}

void readPhases(GaitParameters& to, std::size_t pair, const robotcontrol::GaitParameters::LegPair& from) {
  const double ground = from.has_ground_phase() ? from.ground_phase() : to.groundPhase[pair];
  const double lift = from.has_lift_phase() ? from.lift_phase() : to.liftPhase[pair];
  const double lowering = from.has_lowering_phase() ? from.lowering_phase() : to.loweringPhase[pair];
  if (!isShare(ground) || !isShare(lift) || !isShare(lowering) || ground + lift + lowering >= 1) return;
  to.groundPhase[pair] = ground;
  to.liftPhase[pair] = lift;
  to.loweringPhase[pair] = lowering;
}

void readLegs(GaitParameters& to, const robotcontrol::GaitParameters& from) {
  const auto& fore = from.fore();
  if (fore.has_height()) to.foreHeight = fore.height();
  if (fore.has_width()) to.foreWidth = fore.width();
  if (fore.has_center_x()) to.foreCenterX = fore.center_x();
  if (fore.has_lift()) to.foreLift = fore.lift();
  if (fore.has_tilt()) to.foreTilt = fore.tilt();
  const auto& hind = from.hind();
  if (hind.has_height()) to.hindHeight = hind.height();
  if (hind.has_width()) to.hindWidth = hind.width();
  if (hind.has_center_x()) to.hindCenterX = hind.center_x();
  if (hind.has_lift()) to.hindLift = hind.lift();
  if (hind.has_tilt()) to.hindTilt = hind.tilt();
  readPhases(to, 0, fore);
  readPhases(to, 1, hind);
  for (int i = 0; i < 4 && from.leg_phases_size() == 4; ++i) {
    to.legPhase[static_cast<std::size_t>(i)] = from.leg_phases(i) - std::floor(from.leg_phases(i));
  }
}

void readSpeeds(GaitParameters& to, const robotcontrol::GaitParameters& from) {
  if (from.has_factor_x()) to.factorX = from.factor_x();
  if (from.has_factor_backward()) to.factorBackward = from.factor_backward();
  if (from.has_factor_y()) to.factorY = from.factor_y();
  if (from.has_factor_rotation()) to.factorRotation = from.factor_rotation();
  if (from.has_counter_rotation_x()) to.counterRotationX = from.counter_rotation_x();
  if (from.has_counter_rotation_y()) to.counterRotationY = from.counter_rotation_y();
  if (from.has_counter_forward_rotation()) to.counterForwardRotation = from.counter_forward_rotation();
  if (from.has_counter_forward_sideways()) to.counterForwardSideways = from.counter_forward_sideways();
  if (from.has_counter_forward_until() && from.counter_forward_until() >= 0)
    to.counterForwardUntil = from.counter_forward_until();
  if (from.maximum_x() > 0) to.maximumX = from.maximum_x();
  if (from.maximum_backward() > 0) to.maximumBackward = from.maximum_backward();
  if (from.has_hind_shift_backward()) to.hindShiftBackward = from.hind_shift_backward();
  if (from.maximum_y() > 0) to.maximumY = from.maximum_y();
  if (from.maximum_rotation() > 0) to.maximumRotation = from.maximum_rotation();
  if (from.maximum_change_x() > 0) to.maximumChangeX = from.maximum_change_x();
  if (from.maximum_change_y() > 0) to.maximumChangeY = from.maximum_change_y();
  if (from.maximum_change_rotation() > 0) to.maximumChangeRotation = from.maximum_change_rotation();
}

}  // namespace

GaitParameters gaitParameters(const robotcontrol::GaitMotionParameters& message, FootMode mode) {
  const robotcontrol::GaitParameters& from = message.gait();
  GaitParameters to;
  to.footMode = mode;
  readLegs(to, from);
  readSpeeds(to, from);
  if (from.step_frames() >= 4) to.stepFrames = static_cast<int>(std::min(from.step_frames(), 1000U));
  if (from.maximum_step_x() > 0) to.maximumStepX = from.maximum_step_x();
  if (from.maximum_step_y() > 0) to.maximumStepY = from.maximum_step_y();
  if (from.has_body_shift_x()) to.bodyShiftX = from.body_shift_x();
  if (from.has_body_shift_y()) to.bodyShiftY = from.body_shift_y();
  if (from.has_body_shift_offset()) to.bodyShiftOffset = from.body_shift_offset();
  return to;
}

MotionEngine::Options motionOptions(const robotcontrol::GaitMotionParameters& from) {
  MotionEngine::Options to;
  if (from.has_get_up_by_itself()) to.getUpByItself = from.get_up_by_itself();
  if (from.has_blend_time() && from.blend_time() >= 0) to.blendTime = from.blend_time();
  if (from.has_head_speed_share() && from.head_speed_share() >= 0 && from.head_speed_share() <= 1)
    to.headSpeedShare = from.head_speed_share();
  return to;
}

HeadParameters headParameters(const robotcontrol::HeadControlParameters& from) {
  HeadParameters to;
  if (from.has_body_height()) to.bodyHeight = from.body_height();
  if (from.has_body_pitch()) to.bodyPitch = from.body_pitch();
  if (from.has_ball_radius()) to.ballRadius = from.ball_radius();
  if (from.has_ahead_tilt()) to.aheadTilt = from.ahead_tilt();
  if (from.has_search_far_tilt()) to.searchFarTilt = from.search_far_tilt();
  if (from.has_search_near_tilt()) to.searchNearTilt = from.search_near_tilt();
  if (from.has_search_far_pan()) to.searchFarPan = from.search_far_pan();
  if (from.has_search_near_pan()) to.searchNearPan = from.search_near_pan();
  if (from.has_around_tilt()) to.aroundTilt = from.around_tilt();
  if (from.has_around_pan()) to.aroundPan = from.around_pan();
  if (from.has_sweep_speed() && from.sweep_speed() >= 0) to.sweepSpeed = from.sweep_speed();
  if (from.has_lost_after() && from.lost_after() >= 0) to.lostAfter = from.lost_after();
  if (from.has_ball_low() && from.ball_low() >= 0) to.ballLow = from.ball_low();
  return to;
}

robotlink::ParameterRules gaitRules() {
  using Gait = robotcontrol::GaitParameters;
  using Motion = robotcontrol::GaitMotionParameters;
  constexpr robotlink::ParameterRange kAboveZero{.above = true};
  robotlink::ParameterRules rules;
  for (const int field :
       {Gait::kMaximumXFieldNumber, Gait::kMaximumBackwardFieldNumber, Gait::kMaximumYFieldNumber,
        Gait::kMaximumRotationFieldNumber, Gait::kMaximumChangeXFieldNumber, Gait::kMaximumChangeYFieldNumber,
        Gait::kMaximumChangeRotationFieldNumber, Gait::kMaximumStepXFieldNumber,
        Gait::kMaximumStepYFieldNumber})
    rules.ranges[{Motion::kGaitFieldNumber, field}] = kAboveZero;
  rules.ranges[{Motion::kGaitFieldNumber, Gait::kCounterForwardUntilFieldNumber}] = {};
  rules.ranges[{Motion::kGaitFieldNumber, Gait::kStepFramesFieldNumber}] = {.minimum = 4, .maximum = 1000};
  for (const int pair : {Gait::kForeFieldNumber, Gait::kHindFieldNumber}) {
    for (const int phase : {Gait::LegPair::kGroundPhaseFieldNumber, Gait::LegPair::kLiftPhaseFieldNumber,
                            Gait::LegPair::kLoweringPhaseFieldNumber})
      rules.ranges[{Motion::kGaitFieldNumber, pair, phase}] = {.maximum = 1, .above = true};
  }
  rules.ranges[Motion::kBlendTimeFieldNumber] = {};
  rules.ranges[Motion::kHeadSpeedShareFieldNumber] = {.maximum = 1};
  return rules;
}

robotlink::ParameterRules headRules() {
  robotlink::ParameterRules rules;
  rules.ranges[robotcontrol::HeadControlParameters::kSweepSpeedFieldNumber] = {};
  rules.ranges[robotcontrol::HeadControlParameters::kLostAfterFieldNumber] = {};
  rules.ranges[robotcontrol::HeadControlParameters::kBallLowFieldNumber] = {};
  return rules;
}

}  // namespace modules
