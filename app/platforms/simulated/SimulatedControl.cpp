// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: controllers of the scene.
#include "app/core/platform/PublishGate.h"
#include "app/core/program/ProgramExecutor.h"
#include "app/core/program/RecordingTap.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "foxglove/Robot.pb.h"
#include "simcore/control/Controllers.h"

namespace app {

void SimulatedRun::watchControllers() {
  for (const simcore::ControllerStatus& each : world_->simulation().controllers()) {
    if (each.isOn() || !endedControllers_.insert(each.path).second) continue;
    const std::string text = "Controller " + each.path + " " + kStoppedText + each.trouble;
    if (listeners_.control) listeners_.control(each.path, world_->clock().now(), text);
    // Texts in a log belong to a robot; the first one stands for the scene.
    if (tap_ && !robots_.empty()) {
      tap_->world(textMessage(robots_.front()->name(), "controllers", world_->clock().now(),
                              foxglove::Log::ERROR, text));
    }
  }
}

}  // namespace app
