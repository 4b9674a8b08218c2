// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/ProcessReporter.h"

#include "robotlink/debugging/program/ProcessTable.h"

namespace robotlink {
namespace {

constexpr Duration kReportPeriod = std::chrono::milliseconds(500);

}  // namespace

ProcessReporter::ProcessReporter(const std::string& program, const Clock& clock)
    : Process("report/" + program, clock), table_(*this, "debug/processes/" + program, Blocking::kNo) {
  setPeriod(kReportPeriod);
}

ProcessReporter::~ProcessReporter() {
  stop();
}

void ProcessReporter::noteStuck(const std::string& process, const std::string& task) {
  const std::lock_guard lock(mutex_);
  if (task.empty()) {
    stuck_.erase(process);
  } else {
    stuck_[process] = task;
  }
}

void ProcessReporter::execute() {
  auto table = std::make_shared<robotcontrol::ProcessTable>();
  for (const Process* process : watched_) {
    auto& row = *table->add_processes();
    describe(*process, row);
    const std::lock_guard lock(mutex_);
    const auto stuck = stuck_.find(process->name());
    if (stuck != stuck_.end()) row.set_state(kDoesNotReturn + stuck->second);
  }
  table_.send(std::move(table));
}

}  // namespace robotlink
