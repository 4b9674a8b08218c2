// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "app/core/own/CrashReport.h"
#include "app/core/own/ProgramLink.h"
#include "robotlink/base/Error.h"

namespace app {

/// A process of the operating system in which the program of one robot runs: the same executable, started
/// with a hidden argument (OwnProgramMain.h). It ends when its host does, however that ends. One thread at a
/// time.
class ProgramChild {
 public:
  /// Starts it. The name is that of the robot, for lists of processes.
  static robotlink::Result<ProgramChild> start(const std::filesystem::path& executable,
                                               const std::string& name);
  ProgramChild(ProgramChild&& other) noexcept;
  ProgramChild& operator=(ProgramChild&&) = delete;
  /// Ends it: in an orderly way if it still listens, otherwise by force.
  ~ProgramChild();

  pid_t pid() const { return pid_; }
  ProgramLink& link() { return link_; }
  /// Whether a debugger holds it.
  bool isDebugged() const;
  /// Asks a program that does not answer what it does; waits a moment for the report.
  CrashReport ask();
  /// Whether it has ended.
  bool hasEnded() { return endsWithin(std::chrono::milliseconds(0)).has_value(); }
  /// Ends it by force.
  void kill();
  /// Waits until it has ended by itself, and kills it if that takes long. Returns its status.
  int wait();
  /// The report that it wrote at its end.
  CrashReport report();

 private:
  ProgramChild(pid_t pid, int socket, int reports);
  /// Its status, if it ends within a time.
  std::optional<int> endsWithin(std::chrono::milliseconds limit);
  /// Reads what it has written to its reports so far.
  void readReports();

  pid_t pid_;  // 0: moved away
  ProgramLink link_;
  int reports_;
  std::string written_;
  std::optional<int> status_;
};

}  // namespace app
