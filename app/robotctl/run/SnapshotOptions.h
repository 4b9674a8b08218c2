// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"

namespace CLI {
class App;
}

namespace app {

class SimulatedRun;

/// A snapshot to be written when the simulation reaches a time.
struct WantedSnapshot {
  robotlink::Duration at{};
  std::filesystem::path file;
};

/// The options of `robotctl sim` about snapshots: --snapshot-at, --restore and --programs.
struct SnapshotOptions {
  /// SECONDS=FILE
  std::vector<std::string> at;
  /// The file with which the simulation begins; empty: none.
  std::string restored;
  bool programs = false;

  void addTo(CLI::App& command);
  bool given() const { return !at.empty() || !restored.empty(); }
  /// Returns the snapshots that --snapshot-at requests, in the order of time. Fails if it cannot be read.
  robotlink::Result<std::vector<WantedSnapshot>> wanted() const;
  /// Puts a run that has not been stepped to the snapshot with which it should begin. Shows the progress of
  /// running programs again, which a signal ends.
  robotlink::Result<void> restore(SimulatedRun& run) const;
};

/// Writes the snapshots that are due, and removes them from `wanted`.
robotlink::Result<void> writeDueSnapshots(const SimulatedRun& run, std::vector<WantedSnapshot>& wanted);

}  // namespace app
