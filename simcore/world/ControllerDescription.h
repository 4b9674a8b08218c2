// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace simcore {

/// A parameter that a scene gives to a controller. A plain value.
struct ControllerArgument {
  std::string name, value;
  robotlink::FilePosition where;
};

/// A controller that a scene's files choose for a model or for the world. A plain value.
struct ControllerDescription {
  /// The name under which it is registered: "elevator".
  std::string kind;
  /// Unique in its model, or among those of the world; that of the kind unless the file says another one.
  std::string name;
  /// The prefix of the names of parts of its model: "arm::" if it is that of a nested model.
  std::string prefix = {};
  std::vector<ControllerArgument> arguments = {};
  robotlink::FilePosition where = {};
};

}  // namespace simcore
