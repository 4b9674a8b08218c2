// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simcore/control/Controller.h"

namespace simcore {

class ControllerSetup;

/// A parameter that a kind of controller has. A plain value.
struct ControllerParameter {
  enum class Type : std::uint8_t {
    kNumber,
    /// Several numbers, separated by blanks.
    kNumbers,
    kText,
    /// The path of a port, or its part behind the name of the controller's own model.
    kSensor,
    /// Several of them, separated by blanks.
    kSensors,
    kActuator,
    /// The name of a model.
    kModel,
  };
  std::string name;
  Type type = Type::kNumber;
  /// A sentence for users.
  std::string help = {};
  /// The value if a scene does not specify the parameter; if empty, a scene must.
  std::string initial = {};
  bool required = false;
  /// The range of its numbers; there is none if maximum <= minimum.
  double minimum = 0, maximum = 0;
};

/// A kind of controller that scenes can name. A plain value.
struct ControllerKind {
  /// "elevator"
  std::string name;
  /// A sentence for users.
  std::string help = {};
  std::vector<ControllerParameter> parameters = {};
  /// Makes one; exceptions are reported, and then there is none.
  std::function<std::unique_ptr<Controller>(ControllerSetup& setup)> make = {};
};

/// All registered kinds of controllers, sorted by name. Null if no kind has the name.
const std::vector<ControllerKind>& controllerKinds();
const ControllerKind* controllerKind(const std::string& name);

/// Registers a kind of controller when it is constructed: at namespace scope, or while a plug-in is loaded
/// (robotlink/base/PLUGINS.md). A name that another one has is refused.
class [[maybe_unused]] ControllerRegistration {
 public:
  explicit ControllerRegistration(ControllerKind kind);
};

}  // namespace simcore
