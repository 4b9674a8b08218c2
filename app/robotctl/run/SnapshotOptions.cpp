// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/SnapshotOptions.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/platforms/simulated/SimulatedRun.h"
#include "app/robotctl/Interrupt.h"
#include "app/robotctl/log/LogSubcommands.h"
#include "robotlink/base/ParsedNumber.h"

namespace app {

using robotlink::Result;

void SnapshotOptions::addTo(CLI::App& command) {
  command
      .add_option("--snapshot-at", at,
                  "SECONDS=FILE: writes a snapshot of the simulation at that time; may be repeated")
      ->type_name("SECONDS=FILE");
  auto* file = command
                   .add_option("--restore", restored,
                               "A snapshot from which the simulation begins; the programs start anew there")
                   ->type_name("FILE");
  command
      .add_flag(
          "--programs", programs,
          "With --restore: replays the programs from their start, so that their state is restored as well")
      ->needs(file);
}

Result<std::vector<WantedSnapshot>> SnapshotOptions::wanted() const {
  std::vector<WantedSnapshot> wanted;
  for (const std::string& option : at) {
    const auto equals = option.find('=');
    const auto seconds = robotlink::parsedNumber<double>(std::string_view(option).substr(0, equals));
    if (equals == std::string::npos || equals + 1 == option.size() || !seconds ||
        !(*seconds >= 0 && *seconds <= 1e6)) {
      return robotlink::failure(
          "sim.snapshot",
          "--snapshot-at takes SECONDS=FILE, such as 2.5=before.snapshot, not '" + option + "'", {},
          {option});
    }
    wanted.push_back({robotlink::fromSeconds(*seconds), option.substr(equals + 1)});
  }
  std::ranges::stable_sort(wanted, {}, &WantedSnapshot::at);
  return wanted;
}

Result<void> SnapshotOptions::restore(SimulatedRun& run) const {
  if (restored.empty()) return {};
  const auto snapshot = simcore::Snapshot::read(restored);
  if (!snapshot) return tl::unexpected(snapshot.error());
  if (!programs) return run.restore(*snapshot).map([](const auto&) {});
  if (auto begun = run.runAgain(*snapshot); !begun) return begun;
  TerminalProgress progress;
  const auto show = progress.function();
  while (const auto share = run.ranAgain()) {
    if (Interrupt::noted() || (show && !show(*share)))
      return robotlink::failure("sim.interrupted", "replaying the programs was interrupted");
    run.step();
  }
  progress.erase();
  const auto outcome = run.takeRunAgainOutcome();
  if (!outcome || outcome->empty()) return {};
  return robotlink::failure("snapshot.programs", *outcome);
}

Result<void> writeDueSnapshots(const SimulatedRun& run, std::vector<WantedSnapshot>& wanted) {
  while (!wanted.empty() && wanted.front().at <= run.world().simulation().time()) {
    if (auto written = run.snapshot().write(wanted.front().file); !written) return written;
    wanted.erase(wanted.begin());
  }
  return {};
}

}  // namespace app
