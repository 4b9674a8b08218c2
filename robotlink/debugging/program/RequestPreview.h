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
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/SolutionParameters.h"

namespace robotlink {

class RobotProgram;
class TaskProcess;

/// The results of requests that a program will process in its next frames, found without running or changing
/// it: a paused simulation runs no frames, and the user should not have to wait until it continues. When the
/// frames run, the requests are processed as if there had been no preview, so a run is the same with and
/// without one.
///
/// Construct a new one whenever the program has run. Add requests in the order in which the program got them;
/// each sees the changes of those before it. Only while no process of the program runs; the program must
/// outlive it.
class RequestPreview {
 public:
  explicit RequestPreview(RobotProgram& program) : program_(program) {}

  /// Whether there is a handler for requests of this kind. Those that a program always accepts, without
  /// anything but an answer, need none.
  static bool handles(const robotcontrol::Request& request);

  /// The reason why the program will refuse a request; empty if it will not.
  std::string add(const robotcontrol::Request& request);
  /// The same, with the result in the queue; returns whether the program will do it.
  bool answer(const robotcontrol::Request& request);
  /// The results, the requested parameters, and the tables if they have changed; null if there is nothing.
  std::shared_ptr<const SharedDebugQueue> takeQueue(Instant now);

 private:
  using TaskSolution = std::pair<std::string, std::string>;
  /// The task process that a request goes to; null if the debug process handles it.
  const TaskProcess* processOf(const robotcontrol::Request& request) const;
  // The handlers of requests, called if the debug process does not refuse them. They return the reason of a
  // refusal.
  std::string setKey(const robotcontrol::Request& request);
  std::string selectSolution(const robotcontrol::Request& request);
  std::string getParameters(const robotcontrol::Request& request);
  std::string setParameters(const robotcontrol::Request& request);
  std::string setColorTable(const robotcontrol::Request& request);
  std::string setMotion(const robotcontrol::Request& request);
  std::string setPackage(const robotcontrol::Request& request);
  struct Handlers;
  /// The solution that a request means: `solution`, or the task's active one if it is empty.
  std::string solutionOf(const TaskProcess& process, const std::string& task,
                         const std::string& solution) const;
  /// The parameters that a request means, as the program has them; fails if there are none.
  Result<const SolutionParameters*> parametersOf(const TaskProcess& process, const std::string& task,
                                                 const std::string& solution) const;
  // Publish the results of accepted requests.
  void describeGotten(const robotcontrol::Request& request);
  void describeSet(const robotcontrol::Request& request);
  void describeParameters(const TaskProcess& process, const std::string& task, const std::string& asked);
  void describeMotion(const robotcontrol::Request& request);
  /// Publishes the newest value of a package whose key was switched on, since no frame runs that would.
  void describePackage(const robotcontrol::Request& request);
  void describeHeld(robotcontrol::ProcessTable::Process& process) const;
  void describeTables();
  void describeColorTable();
  SharedDebugQueue& queue();

  RobotProgram& program_;
  /// Selected by requests so far: task to solution.
  std::map<std::string, std::string> solutions_;
  /// Set by requests so far.
  std::map<TaskSolution, SolutionParameters> parameters_;
  // Modes set by requests so far, by name.
  std::map<std::string, robotcontrol::KeyMode> keys_;
  std::optional<robotcontrol::ColorTable> colorTable_;  // given by a request, without its cells
  std::vector<robotcontrol::MotionText> motions_;       // sent by requests
  std::map<std::string, bool> held_;                    // packages that were held or released
  bool tablesAsked_ = false;
  std::shared_ptr<SharedDebugQueue> queue_;
};

}  // namespace robotlink
