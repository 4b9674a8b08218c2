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

void ProcessReporter::execute() {
  auto table = std::make_shared<robotcontrol::ProcessTable>();
  for (const Process* process : watched_) describe(*process, *table->add_processes());
  table_.send(std::move(table));
}

}  // namespace robotlink
