// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "app/core/platform/RecordOptions.h"
#include "app/robotctl/run/ArcosOptions.h"
#include "app/robotctl/run/ListenOptions.h"
#include "app/robotctl/run/SimulatedCameraOptions.h"
#include "app/robotctl/run/SnapshotOptions.h"
#include "app/robotctl/run/TeamOptions.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

/// The arguments of `robotctl sim`. Filled by the command line parser.
struct SimArguments {
  RunOptions run = defaultSimulation();
  TeamOptions teams;
  std::vector<std::string> models;
  std::string script;
  std::string executor = "lockstep";
  std::vector<std::string> ownProcesses;
  std::uint64_t programMemory = 2048;                                        ///< MiB
  double patience = std::chrono::duration<double>(kModulePatience).count();  ///< s; 0: forever
  double seconds = 10;
  bool noNoise = false;
  bool asJson = false;
  bool digest = false;
  bool texts = false;
  bool errors = false;
  int trials = 0;
  double radius = 1.5;
  bool goals = false;
  std::vector<double> walk;  ///< m/s, m/s, degrees/s; empty: none
  double speed = 0;          ///< times real time; 0: as fast as possible
  bool progress = false;
  bool isPaused = false;
  SnapshotOptions snapshots;
  ArcosOptions arcos;
  ListenOptions listen;
  CameraOptions camera;
  RecordOptions record;

  /// Adds the options to the command; this object must outlive it.
  void addTo(CLI::App& sim);
  /// Fails if an option was given that would have no effect.
  robotlink::Result<void> check(const CLI::App& sim) const;
};

}  // namespace app
