// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "app/core/own/MirrorPlatform.h"
#include "app/core/own/ProgramLink.h"
#include "app/core/own/StepClock.h"
#include "app/core/program/ProgramExecutor.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/program/RequestPreview.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/process/LockstepExecutor.h"

namespace app {

/// The program of one robot in a process of its own, with all that runs it: makes it as its host says, and
/// fulfills the orders of the host until that has ended (OWN_PROCESS.md). Its processes are executed in turn,
/// each step being one order, or have a thread each; then their news go to the host whenever there are some.
class OwnProgramServer {
 public:
  /// `socket` is that of `link`, to be waited for.
  OwnProgramServer(ProgramLink link, int socket, const robotcontrol::WireSetup& setup);
  ~OwnProgramServer();
  OwnProgramServer(const OwnProgramServer&) = delete;
  OwnProgramServer& operator=(const OwnProgramServer&) = delete;

  /// Makes the program; what is wrong goes into the answer.
  void make(const robotcontrol::WireSetup& setup);
  /// Fulfills orders until the host has ended. There may be threads that never end then.
  void serve();

 private:
  void addEvent(const std::function<void(robotcontrol::WireResult::Event& event)>& fill);
  void addTrouble(const robotlink::Process& process, const std::string& text);
  /// A frame does not return, or has returned.
  void noteStuck(const std::string& what);
  void describe(robotcontrol::WireProgram& to);
  /// Adds the processes to the executor; those of a log between the platform's turns.
  void addInOrder(const robotcontrol::WireSetup& setup);
  void tapPackages(const robotcontrol::RecordPackages& wanted);
  void tapDebugProcess();
  ProgramExecutor::Options threadOptions(const robotcontrol::WireSetup& setup);

  void serveThreads();
  void fulfill(const robotcontrol::WireOrder& order);
  void step(const robotcontrol::WireStep& step);
  void takeRequests(const robotcontrol::WireStep& step);
  void stepThreads(const robotcontrol::WireStep& step);
  /// Moves what has happened since the last call to the result.
  void takeResult(robotcontrol::WireResult& result);
  /// Says to serveThreads() that there is news. Any thread.
  void wakeUp() const;
  void sendNews();
  void preview(const robotcontrol::WireOrder::Preview& order);
  void takePreview(robotlink::Instant now);
  void send();

  ProgramLink link_;
  const int socket_;
  StepClock clock_;
  MirrorPlatform platform_;
  std::unique_ptr<robotlink::RobotProgram> program_;
  robotlink::LockstepExecutor lockstep_;
  /// Null in lockstep; not started before the first step.
  std::unique_ptr<ProgramExecutor> threads_;
  bool isStarted_ = false;
  int news_ = -1;  // an eventfd
  std::unique_ptr<robotlink::RequestPreview> preview_;
  std::mutex mutex_;  // protects events_
  robotcontrol::WireResult events_;
  robotcontrol::WireAnswer answer_;
};

}  // namespace app
