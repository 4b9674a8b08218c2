// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "app/core/SimulatedRun.h"

namespace robotcontrol {
class ControlSimulation;
class Request;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace app {

/// Runs a SimulatedRun in a thread of its own, at a chosen speed, and tells a session what happens: never on the GUI's
/// thread, and no view slows it.
///
/// All functions may be called from any thread and return at once; what they ask for is done between two steps. The session
/// must outlive it.
class SimulationThread {
 public:
  /// What a run is about, when it starts: for the GUI.
  struct Loaded {
    RunOptions options;
    std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> robots;
    std::shared_ptr<const robotlink::FieldDescription> field;
  };
  /// Called in the simulation's thread: the new run, or why the old one goes on.
  using LoadHandler = std::function<void(const tl::expected<Loaded, robotlink::Errors>&)>;

  explicit SimulationThread(robotlink::Session& session);
  ~SimulationThread();
  SimulationThread(const SimulationThread&) = delete;
  SimulationThread& operator=(const SimulationThread&) = delete;

  void load(RunOptions options, LoadHandler handler);
  void setLayout(std::filesystem::path file, LoadHandler handler);
  /// Requests for robots and for the simulation; the answer goes to the session. STOP acts even while it is paused.
  void request(const robotcontrol::Request& request);

 private:
  using Clock = std::chrono::steady_clock;

  void post(std::function<void()> job);
  void runLoop();
  bool runJobs(std::unique_lock<std::mutex>& lock);
  void stepOnce();
  Clock::time_point nextStepAt() const;
  void restartPacing();

  void fulfil(const robotcontrol::Request& request);
  robotlink::Result<void> fulfilRequest(const robotcontrol::Request& request);
  robotlink::Result<void> control(const robotcontrol::ControlSimulation& control);
  robotlink::Result<void> resetRun();
  SimulatedRun::Listeners listeners();
  Loaded describe() const;

  void publishScene();
  void publishTransforms();
  void publishStatus();
  void publishTrouble(const std::string& robot, const robotlink::Process& process, const std::string& text);

  robotlink::Session& session_;

  // The simulation's thread only.
  std::unique_ptr<SimulatedRun> run_;
  bool running_ = false;
  int stepsWanted_ = 0;
  double speed_ = 1;  // times real time; 0 is as fast as possible
  Clock::time_point paceStart_;
  robotlink::Instant paceStartTime_;
  Clock::time_point lastTransforms_, lastStatus_;
  robotlink::Instant lastStatusTime_;
  double measuredSpeed_ = 0;

  std::mutex mutex_;  // protects jobs_ and quit_
  std::condition_variable wakeUp_;
  std::deque<std::function<void()>> jobs_;
  bool quit_ = false;
  std::thread thread_;
};

}  // namespace app
