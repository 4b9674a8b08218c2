// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/robotctl/compare/RunPlan.h"

namespace app {

/// A line that says on what the result of a run depends in addition to its arguments: this program with its
/// libraries, its resources, and the files that the arguments name, each by size and time of its last change.
/// If one of them changes, the line does. Files that those files name are not followed. Any thread.
std::string inputsOf(const PlannedRun& run);

}  // namespace app
