// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>

#include "modules/BehaviorReport.h"
#include "modules/driving/Outline.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

// Inline, so that it is defined in every file that registers a solution of the task.
inline const robotlink::PlotKey kDrivingSpeedKey{"driving/speed",
                                                 "The speed and rotation that the behavior desires (plots)"};
inline const robotlink::RobotDrawingKey kDrivingArcKey{
    "driving/arc", "Where the desired speed and rotation lead within a second (drawn around the robot)"};

/// The base of solutions of the task "driving": sends the requested velocity before obstacle avoidance, and
/// plots it; derived classes send their state by report_. Obstacle avoidance treats a request older than a
/// second as 0. Used by its process's thread; the context must outlive it.
class DrivingSolution : public robotlink::Solution {
 public:
  /// `solution` is its name.
  DrivingSolution(robotlink::SolutionContext& context, const char* solution)
      : debug_(context.debug()),
        clock_(context.clock()),
        report_(context, solution),
        desired_(context.output(robotlink::kBehaviorDrive)) {}

 protected:
  /// Sends a request; call it in every frame, because requests expire.
  void want(const DriveVelocity& velocity) {
    auto desired = std::make_shared<robotcontrol::DriveRequest>();
    robotlink::assign(*desired->mutable_timestamp(), clock_.now());
    desired->mutable_velocity()->set_x(velocity.forward);
    desired->mutable_velocity()->set_rotation(velocity.rotation);
    desired_.send(std::move(desired));
    if (debug_.on(kDrivingArcKey)) {
      const double turned = 0.5 * velocity.rotation;
      const robotlink::Vector2 end =
          velocity.forward * robotlink::Vector2(std::cos(turned), std::sin(turned));
      debug_.robotDrawing(kDrivingArcKey).line(robotlink::Vector2(0, 0), end, robotlink::colors::kOrange, 3);
    }
    if (!debug_.on(kDrivingSpeedKey)) return;
    debug_.plot(kDrivingSpeedKey, "speed", velocity.forward, "m/s");
    debug_.plot(kDrivingSpeedKey, "rotation", velocity.rotation, "rad/s");
  }

  // For the derived classes.
  robotlink::DebugContext& debug_;
  const robotlink::Clock& clock_;
  BehaviorReport report_;

 private:
  robotlink::Output<robotcontrol::DriveRequest> desired_;
};

}  // namespace modules
