// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"
#include "modules/motion/HeadController.h"
#include "modules/motion/MotionEngine.h"
#include "robotlink/debugging/ParameterRules.h"

namespace robotcontrol {
class GaitMotionParameters;
class HeadControlParameters;
}  // namespace robotcontrol

namespace modules {

// Converts parameter messages to the parameters of the engines. Unset fields, and values that would break a
// gait (a cycle without frames, phases that do not fit into it), keep their built-in values.

GaitParameters gaitParameters(const robotcontrol::GaitMotionParameters& from, FootMode mode);
MotionEngine::Options motionOptions(const robotcontrol::GaitMotionParameters& from);
HeadParameters headParameters(const robotcontrol::HeadControlParameters& from);

// The ranges outside of which a value would be refused.

robotlink::ParameterRules gaitRules();
robotlink::ParameterRules headRules();

}  // namespace modules
