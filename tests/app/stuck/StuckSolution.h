// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <fstream>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"

namespace app::test {

/// A module that does not return from a frame, once it is told to hang, until all that hang are released. It
/// yields a package that no log has, so that it runs on logs, too.
class StuckSolution final : public robotlink::Solution {
 public:
  /// Whether the next one that is executed is to hang.
  static inline std::atomic<bool> shallHang{true};
  /// How many hang; who waits for it is notified.
  static inline std::atomic<int> hanging{0};

  explicit StuckSolution(robotlink::SolutionContext& context)
      : joints_(context.input(robotlink::kJointStates)) {}
  void execute() override {
    if (!shallHang.exchange(false)) return;
    ++hanging;
    hanging.notify_all();
    isReleased_.wait(false);
    --hanging;
  }

  /// Prepares for a test, in which none hangs.
  static void prepare(bool nextShallHang) {
    shallHang = nextShallHang;
    isReleased_ = false;
  }
  static void release() {
    isReleased_ = true;
    isReleased_.notify_all();
  }

  /// Writes a layout that has it; returns the file.
  static std::filesystem::path writeLayout(const std::filesystem::path& folder) {
    const auto file = folder / "stuck.yaml";
    std::ofstream(file) << "version: 1\nname: stuck\nhelp: A process that hangs.\n"
                           "processes:\n"
                           "  - {name: stuck, blocking: [joints/states], tasks: [stuck-test: hang]}\n"
                           "  - {name: debug, debug: true, period_ms: 16}\n";
    return file;
  }

 private:
  static inline std::atomic<bool> isReleased_{false};

  robotlink::Input<foxglove::JointStates> joints_;
};

inline const robotlink::SolutionRegistration kStuckSolution =
    robotlink::SolutionBuilder<StuckSolution>("stuck-test", "hang", "Never returns.")
        .needs(robotlink::kJointStates)
        .yields(robotlink::kDrivePath);

}  // namespace app::test
