// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/Platform.h"

namespace robotlink {

Result<void> Platform::control(const robotcontrol::ControlDrive& details) {
  (void)details;
  return robotlink::failure("platform.no-drive", "this robot has no wheels, which this needs");
}

Result<void> Platform::setCamera(const robotcontrol::SetCamera& details) {
  (void)details;
  return robotlink::failure("platform.no-camera", "this robot has no camera whose settings can be changed");
}

void Platform::report(std::string text) {
  const std::lock_guard lock(reportsMutex_);
  reports_.push_back(std::move(text));
}

void Platform::reportProblem(std::string text) {
  const std::lock_guard lock(reportsMutex_);
  problems_.push_back(std::move(text));
}

std::vector<std::string> Platform::takeReports() {
  const std::lock_guard lock(reportsMutex_);
  return std::exchange(reports_, {});
}

std::vector<std::string> Platform::takeProblems() {
  const std::lock_guard lock(reportsMutex_);
  return std::exchange(problems_, {});
}

}  // namespace robotlink
