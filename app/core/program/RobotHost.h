// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/core/program/HostedProgram.h"
#include "app/core/program/HostedRobot.h"
#include "app/core/program/ProgramExecutor.h"
#include "app/core/program/ProgramRequests.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/Error.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/process/Layout.h"

namespace robotlink {
class RobotProgram;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

class RecordingTap;

/// Runs the program of one robot. It holds what the robot is, its platform, the current program, the user's
/// overrides and the recorder's tap. It outlives the programs, which are replaced on each reset and change of
/// layout, and at each jump in a log.
///
/// One thread at a time; listeners are called in the threads of the program. The tap must outlive it.
class RobotHost {
 public:
  /// Functions that are called with what the robot publishes; each may be empty.
  struct Listeners {
    /// Called with each debug queue, in the thread of the debug process.
    std::function<void(const std::string& robot, std::shared_ptr<const robotlink::SharedDebugQueue>)> queue;
    /// Called if a process was stopped, starves, or could not get its priority.
    std::function<void(const std::string& robot, const robotlink::Process& process, const std::string& text)>
        trouble;
    /// Called with sentences about the platform being set up and shut down, in the owner's thread; `time` is
    /// the platform's.
    std::function<void(const std::string& robot, robotlink::Instant time, const std::string& text)> platform =
        {};
    /// Called with each request that became an override of the user; it must not call this object.
    ProgramRequests::OverrideListener overridden = {};
    /// Called when it has changed where the program runs, or whether it does, in the owner's thread.
    std::function<void(const std::string& robot, robotlink::Instant time,
                       const robotcontrol::HostingStatus& status)>
        hosting = {};
    /// Like `platform`, about what does not work; if it is empty, `platform` is called.
    std::function<void(const std::string& robot, robotlink::Instant time, const std::string& text)> problem =
        {};
  };
  /// The parts from which a program is made.
  struct Parts {
    /// Null if the robot keeps its platform.
    std::unique_ptr<robotlink::Platform> platform;
    /// The file of the layout; empty if it is from another source.
    std::filesystem::path file;
    robotlink::Layout layout;
    /// The robot's properties from then on; unset: as they are now.
    std::optional<HostedRobot> robot = std::nullopt;
    /// Parameters that take the place of those in the robot's files.
    std::vector<robotcontrol::ParameterValues> parameters = {};
    /// Whether layout and parameters contain the user's overrides already; otherwise the program is requested
    /// to apply them in its first frames.
    bool overridden = false;
    /// Makes the program; empty: it is one inside.
    HostedProgram::Maker maker = {};
  };
  /// A program that has not run yet, for adopt().
  struct Candidate {
    HostedRobot robot;
    /// Null if the robot keeps its platform.
    std::unique_ptr<robotlink::Platform> platform;
    std::unique_ptr<HostedProgram> program;
    /// The file of its layout.
    std::filesystem::path layout;
    bool overridden = false;
    /// All that is executed with the platform, in this order: the processes of the program, and those of the
    /// platform that stand in for others.
    std::vector<robotlink::Process*> processes;

    Candidate();
    Candidate(Candidate&&) noexcept;
    Candidate& operator=(Candidate&&) noexcept;
    ~Candidate();
  };

  /// `tap` may be null: nothing is recorded. `overrides` are what the user chose for this robot before.
  RobotHost(HostedRobot robot, Listeners listeners, RecordingTap* tap, ProgramOverrides overrides = {});
  /// Ends the program and shuts the platform down, and reports that.
  ~RobotHost();
  RobotHost(const RobotHost&) = delete;
  RobotHost& operator=(const RobotHost&) = delete;

  const HostedRobot& robot() const { return robot_; }
  const std::string& name() const { return robot_.name; }
  const robotlink::RobotDescription& description() const { return *robot_.description; }
  /// Null before the first adopt().
  robotlink::Platform* platform() const { return platform_.get(); }
  /// Null before the first adopt() and after stop().
  HostedProgram* program() const { return program_.get(); }
  /// The program, if it is in this process of the operating system; otherwise null.
  robotlink::RobotProgram* insideProgram() const { return program_ ? program_->inside() : nullptr; }
  /// The file of the layout of the last adopted program.
  const std::filesystem::path& layout() const { return layout_; }

  /// Makes a program. If that is impossible, the program that runs continues.
  tl::expected<Candidate, robotlink::Errors> make(Parts parts);
  /// Replaces program and, if it has one, platform by those of the candidate. The previous program must not
  /// still be in an executor; the previous platform is shut down.
  void adopt(Candidate candidate);
  /// Initializes the platform, if it is new, and adds platform and program to an executor that has not
  /// started. Returns a sentence for each override that this program refuses.
  std::vector<std::string> begin(ProgramExecutor& executor);
  /// Adds platform and program, which have begun, to another executor that has not started, because the
  /// program of another robot is replaced.
  void continueIn(ProgramExecutor& executor);
  /// Ends the program, whose processes must no longer be running in an executor. The platform stays.
  void stop();
  /// Ends a program that has a frame which does not return; it must exist until that has returned.
  std::unique_ptr<HostedProgram> release();
  /// Shuts the platform down, which must exist until a frame that uses it has returned.
  std::unique_ptr<robotlink::Platform> releasePlatform();
  /// Notes the part of the program that does not return, "ball-percept (region) of process cognition"; empty:
  /// it returns. Meanwhile the robot stands still.
  void noteStuck(const std::string& what);
  bool isStuck() const { return !stuck_.empty(); }
  /// Shuts the platform down before this object is destroyed.
  void endPlatform() { shutDown(); }

  /// Whether there is a handler that has the platform fulfill requests of this kind.
  static bool fulfills(const robotcontrol::Request& request);
  /// Enqueues a request for the program, or has the platform fulfill it (STOP, motors, sonars). Fails if the
  /// platform refuses or if too many requests are waiting.
  robotlink::Result<void> request(const robotcontrol::Request& request);
  /// Call this when the robot is put back to its start: its next program does not continue to its goal.
  void startOver() { requests_.startOver(); }
  /// The same, and its next program starts with these overrides instead of what the user chose since.
  void startOverWith(ProgramOverrides overrides) { requests_.startOverWith(std::move(overrides)); }
  /// Call this before each step: passes the requests since the last step to the program.
  void enqueueRequests();
  /// Has a program in a process of its own compute from what the platform has sent. Call this in lockstep
  /// before each step, when no more requests come, and with threads after each step.
  void startStep() { program_->startStep(); }
  /// Whether what the program publishes and what goes wrong with it is kept until deliver(), so that
  /// listeners and recorder hear of several robots in a fixed order and in the owner's thread. Only while no
  /// process runs.
  void keepReports(bool keeps) { keepsReports_ = keeps; }
  /// Passes on what was kept, unless the program does not return.
  void deliver();
  /// Call this after each step: stops the robot while a process that decides what it does is missing,
  /// and passes what the platform reports to the listener.
  void endStep();
  /// The results that the program will give in its next frames, each only once; null if there are none. Only
  /// in lockstep, between steps.
  std::shared_ptr<const robotlink::SharedDebugQueue> answersToCome();
  /// The user's choices for this robot so far.
  ProgramOverrides overrides() const { return requests_.overrides(); }

  /// Whether a process is the platform or belongs to the program.
  bool owns(const robotlink::Process& process) const;
  /// Passes a problem of a process to the listener, as a sentence: "Process <name> <text>".
  void reportTrouble(const robotlink::Process& process, const std::string& text) const;

 private:
  /// Attaches the recorder's tap to the program.
  void record(ExecutorKind executor);
  /// The preset that a program starts with: the one that was given, once, else the robot's file if it is
  /// another than before; null: none. Reports a file that is wrong.
  std::shared_ptr<const robotlink::Preset> presetToBegin();
  /// Initializes the platform once, and reports how long that took.
  void setUp();
  /// Tells the listener where the program runs; a robot without one, or with a part of one, stands still.
  void reportHosting();
  /// Call this when a process that decides what the robot does is missing, or is back.
  void noteMissing();
  /// Passes what the platform reports to the listener.
  void reportPlatform();
  /// Calls a function, or keeps it for deliver(). Any thread.
  void report(std::function<void()> call) const;
  void forgetReports();
  /// Passes a debug queue to recorder and listener.
  void publish(std::shared_ptr<const robotlink::SharedDebugQueue> queue);
  /// Shuts the platform down, if there is one, and reports how long that took if it was set up.
  void shutDown();
  /// Passes a sentence about the platform to the listener.
  void reportPlatform(const std::string& text) const;
  // The handlers of requests that the platform fulfills.
  robotlink::Result<void> engageStop(const robotcontrol::Request& request);
  robotlink::Result<void> controlDrive(const robotcontrol::Request& request);
  robotlink::Result<void> setCamera(const robotcontrol::Request& request);
  /// Fails with the reason if requests cannot change what the robot does.
  robotlink::Result<void> whetherMoved() const;
  struct Handlers;

  HostedRobot robot_;
  const Listeners listeners_;
  RecordingTap* const tap_;
  /// Requests to all its programs, one after the other, and the overrides that follow from them.
  ProgramRequests requests_;
  std::unique_ptr<robotlink::Platform> platform_;
  std::unique_ptr<HostedProgram> program_;
  std::filesystem::path layout_;
  /// The value in the candidate that was adopted last.
  bool overridden_ = false;
  /// The contents of the robot's preset file when a program last began; unset: there was none.
  std::optional<std::string> presetText_;
  bool hasBegun_ = false;
  std::vector<robotlink::Process*> processes_;
  /// Since the last begin().
  ExecutorKind executor_ = ExecutorKind::kLockstep;
  std::string stuck_;
  /// Whether all processes that decide what the robot does run, and a sentence when that has changed.
  bool isComplete_ = true;
  std::string missingText_;
  /// A sentence, when it has changed.
  std::string stuckText_;
  bool keepsReports_ = false;
  /// Protects kept_.
  mutable std::mutex keptMutex_;
  mutable std::vector<std::function<void()>> kept_;
  /// Whether initialize() was called for platform_.
  bool platformIsSetUp_ = false;
};

}  // namespace app
