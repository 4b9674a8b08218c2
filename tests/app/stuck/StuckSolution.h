// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>

#include "foxglove/Robot.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"

namespace app::test {

/// A module that never returns from its first frame, unless it is let go. To be included in one source of a
/// program.
class StuckSolution final : public robotlink::Solution {
 public:
  /// Whether there is one that does not return, and whether it may.
  static inline std::atomic<bool> isStuck{false}, isLetGo{false};

  explicit StuckSolution(robotlink::SolutionContext& context)
      : joints_(context.input(robotlink::kJointStates)) {}
  void execute() override {
    isStuck = true;
    isStuck.notify_all();
    isLetGo.wait(false);
    isStuck = false;
  }

  /// Writes a layout that has it; returns the file.
  static std::filesystem::path writeLayout(const std::filesystem::path& folder) {
    const auto file = folder / "stuck.yaml";
    std::ofstream(file) << "version: 1\nname: stuck\nhelp: A process that hangs.\n"
                           "processes:\n"
                           "  - {name: stuck, blocking: [joints/states], tasks: [stuck-window-test: hang]}\n"
                           "  - {name: debug, debug: true, period_ms: 16}\n";
    return file;
  }

 private:
  robotlink::Input<foxglove::JointStates> joints_;
};

const robotlink::SolutionRegistration kStuckSolution =
    robotlink::SolutionBuilder<StuckSolution>("stuck-window-test", "hang", "Never returns.")
        .needs(robotlink::kJointStates);

}  // namespace app::test
