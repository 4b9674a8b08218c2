// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>

#include "app/core/program/LeftOverPrograms.h"
#include "logplayer/search/Computation.h"

namespace app {

/// The options of computing what a log lacks by programs. A plain value.
struct ComputationOptions {
  /// The layout of the programs; empty: as in ReplayOptions.
  std::filesystem::path layout = {};
  /// Maps tasks to solutions, instead of the layout's.
  std::map<std::string, std::string> solutions = {};
  /// The time that a module may take, in real time, before the computation fails; 0: forever.
  std::chrono::milliseconds patience = kModulePatience;
};

/// Has the packages that a log lacks computed by its robots' programs, as a replay of the log does. The
/// programs are others than those that a window shows. Each log gets its own; any thread.
logplayer::MakeComputation computationByReplay(ComputationOptions options = {});

}  // namespace app
