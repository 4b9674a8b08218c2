// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/platforms/simulated/SimulatedRun.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

/// The options of `robotctl sim` about what the robots' programs are, for all robots and for single robots
/// and teams, and about the game that they play. A plain value.
struct TeamOptions {
  std::vector<std::string> layouts, solutions, presets, shadows, colorTables;
  /// See RunOptions::game.
  std::string game;

  /// Adds the options to a command; this object must outlive it.
  void addTo(CLI::App& command);
  /// Whether layouts, solutions, shadows, presets or color tables were chosen.
  bool given() const {
    return !layouts.empty() || !solutions.empty() || !presets.empty() || !shadows.empty() ||
           !colorTables.empty();
  }
  /// Fails if something was chosen for a robot, team or kind of robots that a run does not have.
  static robotlink::Result<void> check(const SimulatedRun& run);
  /// Sets what was chosen. Fails with all reasons.
  tl::expected<void, robotlink::Errors> applyTo(RunOptions& run) const;
};

}  // namespace app
