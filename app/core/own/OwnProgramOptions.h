// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/program/ModulePatience.h"

namespace robotcontrol {
class ProgramSetup;
}

namespace app {

class SpareChild;

/// The options of running a robot's program in a process of the operating system of its own. A plain value.
struct OwnProgramOptions {
  /// The executable to start; its main() begins with ownProgramMain().
  std::filesystem::path executable = "/proc/self/exe";
  /// The time that a step, or the answer to a question, may take before the program counts as not answering,
  /// from when it was sent.
  std::chrono::milliseconds patience{2000};
  /// Ends that time early, such as for STOP; null: nothing does.
  std::shared_ptr<const ModulePatience> cut = nullptr;
  /// The time in which it must be made.
  std::chrono::milliseconds startLimit{20'000};
  /// The memory that it may allocate, bytes; 0: as much as there is.
  std::uint64_t memoryLimit = std::uint64_t{2} << 30U;
  /// Whether each process of the layout has a thread there, and nothing waits for it: a step sends what the
  /// platform has sent, and takes what has arrived from the program. Otherwise a step is one in lockstep.
  bool threads = false;
  /// With threads: whether the clock continues as real time does; otherwise only the steps advance it.
  bool inRealTime = false;
  /// The texts of description and field, for robots of logs and remote bodies; null: those of the files.
  std::shared_ptr<const robotcontrol::ProgramSetup> texts = nullptr;
  /// The source of the process; null: it is started when the program is made. Not for several robots.
  std::shared_ptr<SpareChild> spare = nullptr;
  /// The processes of a log, in whose order the program's are executed, and by package the one in whose
  /// turn the platform sends it; empty for platforms that send all at once.
  std::vector<std::string> order = {};
  std::map<std::string, std::string> turns = {};
};

}  // namespace app
