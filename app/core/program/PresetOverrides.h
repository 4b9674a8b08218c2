// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/session/Presets.h"

// Presets for programs that start with them: their debug keys, solutions and parameters. Views and settings
// of cameras do not count. Any thread, once all solutions are registered.
namespace app {

/// A preset by the path of its file (with a slash, or the suffix .json), else by its name in the user's
/// folder. Fails if there is none, or with what it has that no program of this kind can have: each unknown
/// key, task, solution or parameter.
tl::expected<robotlink::Preset, robotlink::Errors> presetToStartWith(const std::string& nameOrFile);

/// Adds to a preset the keys that let solutions run in shadow mode; returns the same one if there
/// are none. Null stands for an empty preset.
std::shared_ptr<const robotlink::Preset> withShadows(std::shared_ptr<const robotlink::Preset> preset,
                                                     const std::vector<robotlink::ShadowName>& shadows);

/// The requests that apply a preset to a program which starts with these parameters. Parameters of solutions
/// that the program does not have are left out.
std::vector<robotcontrol::Request> requestsOf(const robotlink::Preset& preset,
                                              const std::vector<robotcontrol::ParameterValues>& parameters);

}  // namespace app
