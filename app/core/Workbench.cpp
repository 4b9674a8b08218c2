// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/Workbench.h"

#include <utility>

#include "app/core/GameCommands.h"
#include "app/core/LogCommands.h"
#include "app/core/PlatformCommands.h"
#include "app/core/RecordingCommands.h"
#include "app/core/RemoteCommands.h"
#include "app/core/RobotCommands.h"
#include "app/core/TimelineCommands.h"
#include "app/core/platform/PlatformAdapter.h"
#include "robotlink/commands/CommandRegistration.h"

namespace app {

Workbench::Workbench(std::filesystem::path userFolder)
    : OpenPlatform(std::move(userFolder)), commands_(allCommands()) {
  addPlatformCommands(commands_, *this);
  addGameCommands(commands_, *this);
  addRobotCommands(commands_, *this);
  addRemoteCommands(commands_, *this);
  addLogCommands(commands_, *this);
  addLogWriting(commands_, *this, logWriting_);
  addJob([this] { return logWriting_.working(); });
  addRecordingCommands(commands_, *this);
  addTimelineCommands(commands_, *this, changeSteps_);
  addJob([this] { return changeSteps_.working(); });
  for (const PlatformAdapter& adapter : platformAdapters()) {
    if (adapter.commands != nullptr) adapter.commands(*this);
  }
  robotlink::attachRegisteredCommands(commands_, session());
}

void Workbench::tick() {
  OpenPlatform::tick();
  changeSteps_.tick();
}

robotlink::Result<bool> Workbench::working() const {
  bool some = false;
  for (const auto& job : jobs_) {
    const auto isRunning = job();
    if (!isRunning) return isRunning;
    some = some || *isRunning;
  }
  return some;
}

}  // namespace app
