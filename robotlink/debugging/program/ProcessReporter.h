// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/process/Process.h"

namespace robotlink {

/// For programs without the debug process: reports to it twice a second what the processes of this program
/// do, with the package "debug/processes/<program>".
class ProcessReporter final : public Process {
 public:
  ProcessReporter(const std::string& program, const Clock& clock);
  ~ProcessReporter() override;

  /// Adds a process, which must outlive this object. Before it runs.
  void watch(const Process& process) { watched_.push_back(&process); }
  /// Notes the task from which a process does not return, as in "ball-percept (region)"; empty: it has
  /// returned. Any thread.
  void noteStuck(const std::string& process, const std::string& task);

 protected:
  void execute() override;

 private:
  Sender<robotcontrol::ProcessTable> table_;
  std::vector<const Process*> watched_;
  /// Protects stuck_: tasks by process.
  std::mutex mutex_;
  std::map<std::string, std::string> stuck_;
};

}  // namespace robotlink
