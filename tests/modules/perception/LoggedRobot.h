// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/session/StreamMessage.h"

namespace modules {

/// What the camera of a logged robot told in one frame.
struct LoggedView {
  robotlink::PackagePtr image;
  robotlink::PackagePtr pose;
  robotlink::Instant time;
};

/// The views of a log of a message queue, in its order; none if there is no such file.
std::vector<LoggedView> readViews(const std::string& logFile);

/// The perception of the robot program, with the parameters of the NAO on the field of 2009, on single views
/// of a log.
class LoggedRobot {
 public:
  /// Solutions of the tasks segmentation and ball-percept.
  LoggedRobot(const std::string& segmentation, const std::string& ballPercept);
  ~LoggedRobot();

  robotcontrol::BallPercept look(const LoggedView& view);
  /// Of the last look.
  const robotcontrol::ColorRegions& regions() const { return regions_; }
  /// The reason of a refusal; empty if it was done.
  std::string ask(robotcontrol::Request request);
  /// A table without cells takes the last one back.
  std::string setColorTable(const robotcontrol::ColorTable& table);
  const std::vector<std::string>& failures() const { return failures_; }

 private:
  class Eyes;
  void hear(const robotcontrol::DebugQueue& queue);

  robotlink::ManualClock clock_;
  std::unique_ptr<Eyes> eyes_;
  std::unique_ptr<robotlink::RobotProgram> program_;
  std::unique_ptr<robotlink::LockstepExecutor> executor_;
  robotcontrol::BallPercept percept_;
  robotcontrol::ColorRegions regions_;
  std::vector<std::string> failures_;
  std::vector<robotcontrol::RequestResult> results_;
  std::uint64_t lastId_ = 0;
};

}  // namespace modules
