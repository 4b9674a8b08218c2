// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/core/program/Pace.h"
#include "app/core/simulated/ArcosPorts.h"
#include "app/core/simulated/SimulatedWorld.h"
#include "simcore/Scene.h"

namespace app {

/// A world of Pioneers without programs of their own, driven by whoever connects to their ports: what
/// `robotctl sim --arcos` runs. No thread of its own; stepped by one.
class ArcosSimulation {
 public:
  struct Options {
    std::filesystem::path scene;
    simcore::RobotsToAdd robots;
    SimulatedWorld::Options world;
    ArcosPorts::Options ports;
    double speed = 1;                     ///< times real time; 0: as fast as possible
    simcore::LoadProgress progress = {};  ///< of the scene; may give up its loading
  };
  /// How well it kept to real time.
  struct Punctuality {
    robotlink::Duration latest{};  ///< by how much a step was late at most
    robotlink::Duration lost{};    ///< real time that was given up because steps took too long
  };

  static tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> create(
      Options options, ArcosPorts::Log teller = {});

  /// The same of a scene that was loaded before; the options' file and robots do not count then.
  static tl::expected<std::unique_ptr<ArcosSimulation>, robotlink::Errors> create(
      std::shared_ptr<const simcore::Scene> scene, Options options, ArcosPorts::Log teller = {});

  /// Waits until the next step is due, moving packets meanwhile, and makes it.
  void step();
  /// Until that instant of the simulation, or until `stop` says so, which is asked before each step, or a
  /// client ends it.
  void run(robotlink::Instant end, const std::function<bool()>& stop = {});

  SimulatedWorld& world() { return *world_; }
  const SimulatedWorld& world() const { return *world_; }
  ArcosPorts& ports() { return *ports_; }
  const ArcosPorts& ports() const { return *ports_; }
  const Options& options() const { return options_; }
  const Punctuality& punctuality() const { return punctuality_; }

 private:
  explicit ArcosSimulation(Options options) : options_(std::move(options)) {}
  void keepTime(std::chrono::steady_clock::time_point now, robotlink::Instant time);

  Options options_;
  std::unique_ptr<SimulatedWorld> world_;
  std::unique_ptr<ArcosPorts> ports_;  // uses the world
  Pace pace_;
  bool paced_ = false;
  Punctuality punctuality_;
};

}  // namespace app
