// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "robotlink/process/Layout.h"
#include "robotlink/process/Link.h"

namespace robotcontrol {
class Request;
}
namespace robotlink {
class Platform;
class Process;
class RobotProgram;
struct RobotSetup;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

struct HostedRobot;

/// The results of requests that a program will process in its next frames, found without running or changing
/// it; see robotlink::RequestPreview.
class ProgramPreview {
 public:
  virtual ~ProgramPreview() = default;
  /// The reason why the program will refuse a request; empty if it will not.
  virtual std::string add(const robotcontrol::Request& request) = 0;
  /// The same, with the result in the queue; returns whether the program will do it.
  virtual bool answer(const robotcontrol::Request& request) = 0;
  /// The results and what follows from them; null if there is nothing.
  virtual std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(robotlink::Instant now) = 0;
};

/// The program of a robot as its host sees it, wherever it runs: in this process of the operating system
/// (InsideProgram) or in one of its own (OwnProgram). The platform that it was made for must outlive it. One
/// thread at a time; listeners are called in the threads of its processes.
class HostedProgram {
 public:
  /// Functions that are called with what the program does; none may be empty.
  struct Listeners {
    /// Called with each debug queue.
    std::function<void(std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called if a process that its own executor runs was stopped or starves, with the rest of a sentence.
    std::function<void(const robotlink::Process& process, const std::string& text)> trouble;
    /// Called when hosting() has changed.
    std::function<void()> hosting;
  };
  /// The parts from which a program is made.
  struct Parts {
    const HostedRobot& robot;
    robotlink::Platform& platform;
    /// The file of the layout; empty if it is from another source.
    const std::filesystem::path& file;
    robotlink::Layout layout;
    robotlink::ParameterSource parameters;
  };
  using Made = tl::expected<std::unique_ptr<HostedProgram>, robotlink::Errors>;
  /// Makes a program, or says why that is impossible.
  using Maker = std::function<Made(Parts parts)>;

  virtual ~HostedProgram() = default;

  // Before it runs:
  virtual void setListeners(Listeners listeners) = 0;
  /// The parameters of all solutions of all tasks.
  virtual std::vector<robotcontrol::ParameterValues> parameters() const = 0;
  /// See the functions of the same names in RobotProgram.
  virtual void recordPackages(const std::set<std::string>& packages) = 0;
  virtual void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) = 0;

  virtual const robotlink::Layout& layout() const = 0;
  /// All packages that its tasks yield; sorted.
  virtual std::vector<std::string> yieldedPackages() const = 0;
  /// The processes that the host executes together with the platform, in this order.
  virtual const std::vector<robotlink::Process*>& processes() const = 0;
  /// The debug process, or its stand-in: its name, its senders, and its number of frames.
  virtual const robotlink::Process& debugProcess() const = 0;
  /// The program, if it is in this process of the operating system, otherwise null.
  virtual robotlink::RobotProgram* inside() { return nullptr; }

  // For logs:
  /// Has the debug process send a package, such as a color table, without a request: in its next frame.
  virtual void offer(const robotlink::PackagePtr&) {}
  /// Called with packages that tasks have sent, by name.
  using PackageTap = std::function<void(const std::string& package, const robotlink::PackagePtr& value)>;
  /// Calls a function with these packages, in the threads of the program; in lockstep, during the steps.
  /// Before it runs.
  virtual void tap(const std::set<std::string>&, PackageTap) {}

  /// Enqueues a request. Returns false if it takes none now.
  virtual bool request(const robotcontrol::Request& request) = 0;
  /// The reason why it takes no requests, as a sentence; empty if it does.
  virtual std::string refusal() const { return {}; }
  /// Only in lockstep, between steps.
  virtual std::unique_ptr<ProgramPreview> preview() = 0;
  /// A remote program begins to compute. Call this in lockstep before a step, when no more requests
  /// come, and with threads after a step.
  virtual void startStep() {}
  /// The name of one of its processes that decides what the robot does and has stopped, or cannot be reached,
  /// so that the robot has to stop; empty: all run.
  virtual std::string missingProcess() const { return {}; }
  /// The program's hosting: where it runs, and whether it does.
  virtual robotcontrol::HostingStatus hosting() const = 0;
  /// Ends it. Its processes must no longer be in an executor. Idempotent.
  virtual void stop() = 0;
};

}  // namespace app
