// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/motions/LegKinematics.h"

namespace modules {

// The legs of the ERS-210, their dimensions and kinematics.
using robotlink::kLegs;
using robotlink::Leg;
using robotlink::LegAngles;
using robotlink::LegKinematics;
using robotlink::RobotDimensions;

}  // namespace modules
