// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/session/StreamMessage.h"

namespace modules {

/// Image and pose of the camera of a logged robot in one frame.
struct LoggedView {
  robotlink::PackagePtr image;
  robotlink::PackagePtr pose;
  robotlink::Instant time;
};

/// The views of a message queue log in its order; empty if there is no such file.
std::vector<LoggedView> readViews(const std::string& logFile);

/// The perception of the robot program, with the parameters of the NAO on the field of 2009, applied to
/// single views of a log.
class LoggedRobot {
 public:
  /// The arguments are solutions of the tasks segmentation and ball-percept.
  LoggedRobot(const std::string& segmentation, const std::string& ballPercept);
  ~LoggedRobot();

  robotcontrol::BallPercept look(const LoggedView& view);
  /// The regions of the last call of look().
  const robotcontrol::ColorRegions& regions() const { return regions_; }
  /// Sends a request; returns the reason if it was refused, otherwise an empty text.
  std::string ask(robotcontrol::Request request);
  /// Sets a color table; one without cells removes the last one.
  std::string setColorTable(const robotcontrol::ColorTable& table);
  const std::vector<std::string>& failures() const { return failures_; }

 private:
  class Eyes;
  void hear(const robotlink::SharedDebugQueue& queue);

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
