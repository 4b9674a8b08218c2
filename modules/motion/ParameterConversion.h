// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/motion/GaitParameters.h"
#include "modules/motion/HeadController.h"
#include "modules/motion/MotionEngine.h"

namespace robotcontrol {
class GaitMotionParameters;
class HeadControlParameters;
}  // namespace robotcontrol

namespace modules {

// From parameter messages to the values that the engines calculate with. Fields that are not set, and those
// that would break a gait (a cycle without frames, phases that do not fit into it), keep their built-in
// values.

GaitParameters gaitParameters(const robotcontrol::GaitMotionParameters& from, FootMode mode);
MotionEngine::Options motionOptions(const robotcontrol::GaitMotionParameters& from);
HeadParameters headParameters(const robotcontrol::HeadControlParameters& from);

}  // namespace modules
