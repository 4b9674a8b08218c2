// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/motions/MotionFile.h"

namespace robotlink {

/// Returns the text of a motion. Reading it yields an equal object, except for line numbers.
std::string writeMotion(const MotionFile& motion);

// Parts of the text of `motion`, in its units.
std::string writeStatement(const MotionFile& motion, const MotionStatement& statement);
std::string writeValue(const MotionFile& motion, const JointValue& value);
std::string writeDuration(const MotionFile& motion, Duration duration);

}  // namespace robotlink
