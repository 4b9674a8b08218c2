// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/core/ArcosSimulation.h"
#include "app/core/SimulatedRun.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// The options of `robotctl sim` that put robots into a world and open Pioneers to programs by ARCOS.
struct ArcosOptions {
  std::string robot;  ///< empty: see simcore::RobotsToAdd
  std::string teams = "both";
  int robots = 0;
  bool kinematic = false;
  bool allSonars = false;
  std::uint16_t port = 8101;
  std::string address = "127.0.0.1";

  void addTo(CLI::App& command);
  /// Whether robots are to be opened: --arcos.
  bool given() const;
  /// Robots to add as the options say; one for a map if they do not.
  simcore::RobotsToAdd robotsFor(const std::filesystem::path& scene, std::uint64_t seed) const;
  /// The same for robots with programs of their own.
  void applyTo(RunOptions& run) const;

 private:
  CLI::Option* arcos_ = nullptr;
  CLI::Option* robots_ = nullptr;
};

/// What `robotctl sim --arcos` is told beside that.
struct ArcosRun {
  std::filesystem::path scene;
  SimulatedWorld::Options world;
  std::optional<double> seconds;  ///< simulated ones; none: until it is interrupted
  double speed = 1;
  bool asJson = false;
};

/// Simulates until the time is over, a client ends it or the user interrupts it; prints figures. An
/// ExitStatus.
int runArcos(const ArcosOptions& options, const ArcosRun& run);

}  // namespace app
