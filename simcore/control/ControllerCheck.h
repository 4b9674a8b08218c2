// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/control/ControllerKind.h"
#include "simcore/world/ControllerDescription.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Reports the problems of a description by itself: a kind that is not registered, unknown, repeated or
/// missing parameters, values of a wrong type or out of range. `object` is the path of its owner, for
/// users; empty for the world.
void checkController(const ControllerDescription& description, const std::string& object,
                     robotlink::Errors& errors);

/// Reports what controllers of a world name and is not there, ports and models, and names that two of them
/// have in one place.
void checkControllers(const WorldDescription& world, const std::vector<Port>& ports,
                      robotlink::Errors& errors);

/// The path of a port that a controller names: of its own model if that has it, otherwise as it is. Empty if
/// there is no such port.
std::string portPath(const ControllerDescription& description, const std::string& model,
                     const std::string& named, const std::vector<Port>& ports);

/// The words of a text, which blanks separate.
std::vector<std::string> wordsOf(const std::string& text);
/// The numbers of a text, separated by blanks; unset if it is anything else, or one is not finite.
std::optional<std::vector<double>> numbersOf(const std::string& text);

}  // namespace simcore
