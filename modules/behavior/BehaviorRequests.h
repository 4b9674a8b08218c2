// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "modules/behavior/Intention.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/debugging/Solution.h"

namespace modules {

// Inline, so that it is defined in every file that registers a solution of the task.
inline const robotlink::PlotKey kBehaviorSpeedKey{"behavior/speed", "The requested walking speeds"};
inline const robotlink::RobotDrawingKey kBehaviorWalkKey{
    "behavior/walk", "Where the requested speed leads within a second (drawn around the robot)"};

/// Sends the requests of a behavior for body and head, plots the speeds and draws them. Used by its process's
/// thread; the context must outlive it.
class BehaviorRequests {
 public:
  explicit BehaviorRequests(robotlink::SolutionContext& context);
  void send(const Intention& intention);
  /// Sends requests that are not intentions, with the present time.
  void send(std::shared_ptr<robotcontrol::MotionRequest> motion,
            std::shared_ptr<robotcontrol::HeadMode> head);

 private:
  robotlink::DebugContext& debug_;
  const robotlink::Clock& clock_;
  robotlink::Output<robotcontrol::MotionRequest> motion_;
  robotlink::Output<robotcontrol::HeadMode> head_;
};

}  // namespace modules
