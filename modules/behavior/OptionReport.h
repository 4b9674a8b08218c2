// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "modules/behavior/OptionMachine.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/GamePackages.h"

namespace robotcontrol {
class BehaviorControl;
}

namespace modules {

/// Sends the active options of a behavior as "behavior/state" in each frame, and all of its options as
/// "behavior/graph" once a second; logs each state that is entered, with the reason. Used by its process's
/// thread; the context must outlive it.
class OptionReport {
 public:
  OptionReport(robotlink::SolutionContext& context, std::string solution);
  /// Call it after each OptionMachine::advance().
  void send(const OptionMachine& machine);

 private:
  void sendGraph(const OptionMachine& machine);

  robotlink::DebugContext& debug_;
  const robotlink::Clock& clock_;
  robotlink::Output<robotcontrol::BehaviorState> state_;
  robotlink::Output<robotcontrol::BehaviorGraph> graph_;
  std::string solution_;
  std::optional<robotlink::Instant> graphSent_;
};

/// Converts a person's control of a behavior to that of an option machine.
OptionMachine::Control optionControl(const robotcontrol::BehaviorControl& from);

}  // namespace modules
