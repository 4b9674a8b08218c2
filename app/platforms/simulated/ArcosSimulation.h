// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/core/platform/Pace.h"
#include "app/platforms/simulated/ArcosPorts.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "simcore/Scene.h"

namespace app {

/// A world of Pioneers without programs of their own, driven by the programs that connect to their ports.
/// `robotctl sim --arcos` runs it. It has no thread of its own; one thread steps it.
class ArcosSimulation {
 public:
  /// The scene to simulate, and its speed.
  struct Options {
    /// An SDFormat file or a map.
    std::filesystem::path scene;
    /// Robots in addition to those of the scene.
    simcore::RobotsToAdd robots;
    SimulatedWorld::Options world;
    ArcosPorts::Options ports;
    /// Times real time; 0 means as fast as possible.
    double speed = 1;
    /// Called while the scene is loaded; can cancel that.
    simcore::LoadProgress progress = {};
    /// Folders in which model://NAME is searched first.
    std::vector<std::filesystem::path> models = {};
  };
  /// The figures on how well the simulation keeps up with real time.
  struct Punctuality {
    /// The largest delay of a step.
    robotlink::Duration latest{};
    /// Real time that was given up because steps took too long, in all.
    robotlink::Duration lost{};
  };

  /// Loads the scene and opens the ports. Fails with all reasons if that is impossible. `logger` is called
  /// with lines for the user.
  static tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> create(
      Options options, ArcosPorts::Log logger = {});

  /// Makes it of a scene that was loaded before; file and robots of the options are ignored.
  static tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> create(
      std::shared_ptr<const simcore::Scene> scene, Options options, ArcosPorts::Log logger = {});

  /// Waits until the next step is due, moving packets meanwhile, then makes it.
  void step();
  /// Steps until an instant of the simulation, until `stop` returns true (it is called before each step, and
  /// several times a second while that is waited for), or until a client ends the simulation.
  void run(robotlink::Instant end, const std::function<bool()>& stop = {});

  SimulatedWorld& world() { return *world_; }
  const SimulatedWorld& world() const { return *world_; }
  ArcosPorts& ports() { return *ports_; }
  const ArcosPorts& ports() const { return *ports_; }
  const Options& options() const { return options_; }
  const Punctuality& punctuality() const { return punctuality_; }

 private:
  explicit ArcosSimulation(Options options) : options_(std::move(options)) {}
  /// Makes a step as step() does; returns false without it if `stop` returned true meanwhile.
  bool stepUnless(const std::function<bool()>& stop);
  /// Moves packets until the next step is due; returns false if `stop` returned true before.
  bool serveUntilDue(const std::function<bool()>& stop);
  /// Measures how late a step is, and gives up the time that cannot be made up for.
  void keepTime(std::chrono::steady_clock::time_point now, robotlink::Instant time);

  Options options_;
  std::unique_ptr<SimulatedWorld> world_;
  /// Declared after the world, which it uses.
  std::unique_ptr<ArcosPorts> ports_;
  Pace pace_;
  /// Whether pace_ was started, by the first step.
  bool paced_ = false;
  Punctuality punctuality_;
};

}  // namespace app
