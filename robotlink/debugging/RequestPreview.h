// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/debugging/SolutionParameters.h"

namespace robotlink {

class RobotProgram;
class TaskProcess;

/// The answers to requests that wait for a program's next frames, found without running or changing it: a
/// simulation that is paused makes no frames, and who asks it for something need not wait until it goes on.
/// When the frames come, the requests are done, and answered, as if nobody had looked, so that a run is the
/// same with and without a preview.
///
/// Made anew whenever the program has run; requests are added in the order in which the program was given
/// them, and each sees what those before it will have changed. Only while no process of the program runs; the
/// program must outlive it.
class RequestPreview {
 public:
  explicit RequestPreview(RobotProgram& program) : program_(program) {}

  /// Why the program will refuse it; empty if it will not.
  std::string add(const robotcontrol::Request& request);
  /// The same, with the answer in the queue; whether the program will do it.
  bool answer(const robotcontrol::Request& request);
  /// The answers, the parameters that were asked for, and the tables if they are other ones; null: nothing.
  std::shared_ptr<const robotcontrol::DebugQueue> takeQueue(Instant now);

 private:
  using TaskSolution = std::pair<std::string, std::string>;
  const TaskProcess* processOf(const robotcontrol::Request& request) const;
  std::string addTo(const TaskProcess& process, const robotcontrol::Request& request);
  std::string selectSolution(const TaskProcess& process, const robotcontrol::SelectSolution& wish);
  std::string setParameters(const TaskProcess& process, const robotcontrol::SetParameters& wish);
  std::string solutionOf(const TaskProcess& process, const std::string& task,
                         const std::string& solution) const;
  void describeParameters(const robotcontrol::Request& request);
  void describeTables();
  void describeColorTable();
  robotcontrol::DebugMessage& message(const std::string& path);

  RobotProgram& program_;
  std::map<std::string, std::string> solutions_;           // chosen, by task
  std::map<TaskSolution, SolutionParameters> parameters_;  // that were set
  std::map<std::string, robotcontrol::KeyMode> keys_;
  std::optional<robotcontrol::ColorTable> colorTable_;  // that was given, without its cells
  bool tablesAsked_ = false;
  std::shared_ptr<robotcontrol::DebugQueue> queue_;
};

}  // namespace robotlink
