// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/ProgramTroubles.h"

#include <ostream>
#include <utility>

#include "app/core/program/ProgramExecutor.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/Printable.h"

namespace app {

using robotcontrol::HostingStatus;

void ProgramTroubles::note(const std::string& robot, const HostingStatus& status) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(printed_[robot], status.text()) == status.text() || status.text().empty()) return;
  out_ << robotlink::printable(robot + ": " + status.text()) << "\n"
       << robotlink::printableLines(status.stack()) << std::flush;
  if (status.state() != HostingStatus::RUNNING) keep(robot, status.text());
}

void ProgramTroubles::note(const std::string& robot, const std::string& text) {
  const std::lock_guard lock(mutex_);
  out_ << robotlink::printable(robot + ": " + text) << "\n" << std::flush;
  if (text.find(kStoppedText) != std::string::npos) keep(robot, text);
}

void ProgramTroubles::keep(const std::string& robot, const std::string& text) {
  if (all_.size() < kMaxTroubles) all_.push_back({robot, robotlink::printable(text)});
}

std::vector<ProgramTroubles::Trouble> ProgramTroubles::all() const {
  const std::lock_guard lock(mutex_);
  return all_;
}

}  // namespace app
