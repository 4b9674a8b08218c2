// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/process/Link.h"

namespace robotlink {
class Session;
}

namespace widgets {

/// Asks a simulation to publish the readings of ports that a view shows: of sensors on the stream "ports", of
/// cameras as images, of actuators the outcome of their last command. A port is requested once, as soon as
/// the world's objects name it, and again after another platform was opened. Others are never requested. GUI
/// thread.
class PortSubscription {
 public:
  /// Called in each tick with the paths of the ports that are shown now. Costs next to nothing while nothing
  /// changes.
  void want(robotlink::Session& session, const std::vector<std::string>& ports);

 private:
  /// The store's generation that the members below belong to; another one clears them.
  std::uint64_t generation_ = ~std::uint64_t{0};
  /// The message with the world's objects in which `unknown_` are missing.
  robotlink::PackagePtr objects_;
  std::set<std::string> asked_, unknown_;
};

/// The ports that an expression or the field of a curve names: those in port="...".
std::vector<std::string> portsNamedIn(std::string_view text);
/// The path of a value of a port in the messages of the stream "ports", as curves and expressions take it.
std::string portField(const std::string& port, int value);

}  // namespace widgets
