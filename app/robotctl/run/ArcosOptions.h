// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/platforms/simulated/ArcosSimulation.h"
#include "app/platforms/simulated/SimulatedRun.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// The options of `robotctl sim` that add robots to a world and make simulated Pioneers available to other
/// programs by ARCOS. Filled by the command line parser.
struct ArcosOptions {
  /// Model of the robots to add; empty: see simcore::RobotsToAdd.
  std::string robot;
  /// The teams whose robots are added: "both", "red" or "blue".
  std::string teams = "both";
  /// Number of robots to add; see robotsFor() for the default.
  int robots = 0;
  /// Whether robots on wheels are moved by their odometry instead of by forces.
  bool kinematic = false;
  /// Whether all sonars report with each information packet, instead of in turns.
  bool allSonars = false;
  /// TCP port of the first robot; the following robots use the following ports.
  std::uint16_t port = 8101;
  /// Local address on which the ports are opened.
  std::string address = "127.0.0.1";

  /// Adds the options to a command; this object must outlive the command.
  void addTo(CLI::App& command);
  /// Fails if a kind or teams are named, but no robots are added.
  robotlink::Result<void> check(const std::filesystem::path& scene) const;
  /// Whether --arcos was given.
  bool given() const;
  /// The robots to add to a scene. Without --robots one robot is added to a map, none to any other scene.
  simcore::RobotsToAdd robotsFor(const std::filesystem::path& scene, std::uint64_t seed) const;
  /// Sets the robots and their motion in the options of a run whose robots have programs of their own.
  void applyTo(RunOptions& run) const;

 private:
  /// Owned by the command; null before addTo().
  CLI::Option* arcos_ = nullptr;
  CLI::Option* robots_ = nullptr;
  CLI::Option* teams_ = nullptr;
};

/// The other arguments of `robotctl sim --arcos`.
struct ArcosRun {
  std::filesystem::path scene;
  SimulatedWorld::Options world;
  /// Simulated seconds; empty: until interrupted.
  std::optional<double> seconds;
  /// Times real time; 0 is as fast as possible.
  double speed = 1;
  /// Whether the figures are printed as JSON.
  bool asJson = false;
  /// Folders in which model://NAME is searched first.
  std::vector<std::filesystem::path> models = {};
};

/// Simulates until the time is over, a client ends the simulation, or the user interrupts it; prints figures.
/// Returns an ExitStatus.
int runArcos(const ArcosOptions& options, const ArcosRun& run);

}  // namespace app
