// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "modules/modeling/PoseEstimate.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

// Debug keys shared by all solutions of the task. Inline, so that they are defined in every file that
// registers a solution.
inline const robotlink::FieldDrawingKey kLocatorPoseKey{
    "self-localisation/pose", "The robot's estimated pose with its uncertainty (drawn on the field)"};
inline const robotlink::FieldDrawingKey kLocatorParticlesKey{
    "self-localisation/particles", "The particles or hypotheses of the filter (drawn on the field)"};
inline const robotlink::PlotKey kLocatorPlotKey{"self-localisation/plot",
                                                "Position, heading and deviation of the robot"};

/// The base of solutions of the task "self-localisation": sends the pose estimate, and draws and plots it. A
/// derived class computes an estimate in execute() and passes it to publish(). Used by its process's thread;
/// the context must outlive it.
class SelfLocalization : public robotlink::Solution {
 public:
  explicit SelfLocalization(robotlink::SolutionContext& context)
      : debug_(context.debug()), pose_(context.output(robotlink::kRobotPose)) {}

 protected:
  /// Sends an estimate that is valid at `time`; call it once a frame. Costs little unless a key is on.
  void publish(const PoseEstimate& estimate, const google::protobuf::Timestamp& time) {
    auto package = std::make_shared<robotcontrol::RobotPose>();
    *package->mutable_timestamp() = time;
    robotlink::assign(*package->mutable_robot_in_field(), estimate.robotInField);
    package->set_position_deviation(estimate.positionDeviation);
    package->set_heading_deviation(estimate.headingDeviation);
    pose_.send(std::move(package));
    // The robot, and a circle of two standard deviations of its position.
    if (debug_.on(kLocatorPoseKey)) {
      auto drawing = debug_.fieldDrawing(kLocatorPoseKey);
      drawing.pose(estimate.robotInField, robotlink::colors::kBlack);
      drawing.circle(estimate.robotInField.translation(), 2 * estimate.positionDeviation,
                     robotlink::colors::kGray);
    }
    if (debug_.on(kLocatorPlotKey)) {
      debug_.plot(kLocatorPlotKey, "x", estimate.robotInField.x, "m");
      debug_.plot(kLocatorPlotKey, "y", estimate.robotInField.y, "m");
      debug_.plot(kLocatorPlotKey, "heading", estimate.robotInField.heading, "rad");
      debug_.plot(kLocatorPlotKey, "deviation", estimate.positionDeviation, "m");
    }
  }

  /// For drawings and texts of the derived classes.
  robotlink::DebugContext& debug_;

 private:
  robotlink::Output<robotcontrol::RobotPose> pose_;
};

}  // namespace modules
