// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/core/platform/Pace.h"
#include "app/core/platform/PlatformFeed.h"
#include "app/core/platform/PublishGate.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/snapshots/SnapshotShelf.h"
#include "app/platforms/simulated/world/WorldPorts.h"
#include "app/platforms/simulated/world/control/ExternalControllers.h"

namespace robotcontrol {
class SimulationStatus;
}

namespace app {

/// A SimulatedRun in the workbench: stepped at the speed that the user chose, it publishes to a session what
/// happens in the world and what the programs send. The run itself passes to the recorder what a log may
/// contain. Session and recorder must outlive it.
class SimulationFeed final : public PlatformFeed {
 public:
  /// The name of its PlatformAdapter.
  static constexpr const char* kAdapter = "simulation";

  /// Called in the platform's thread with the options of the run (SimulatedRun::optionsToKeep()), at the
  /// start and whenever they change.
  using Choices = std::function<void(const RunOptions& options)>;
  /// Returns the opening of a scene for PlatformThread.
  static PlatformOpening opening(const RunOptions& options);
  /// The same for the options that `adapt` makes of those of the last simulation, so that another scene is
  /// opened with its settings; layouts and solutions are those that were chosen in the scene itself. Called
  /// once, in the platform's thread.
  static PlatformOpening opening(const std::filesystem::path& scene,
                                 std::function<void(RunOptions& options)> adapt);
  /// Makes the run, paused. Fails with all reasons if that is impossible.
  static tl::expected<std::unique_ptr<SimulationFeed>, robotlink::Errors> create(
      RunOptions options, robotlink::Session& session, logplayer::Recorder& recorder, Choices choices = {});

  /// Whether there is a handler for requests of this kind, other than those to robots.
  static bool fulfills(const robotcontrol::Request& request);

  /// Closes the ports, since another simulation may need them before it is known that it can be run.
  void makeWay() override;
  /// Opens the ports again. Fails if another program has opened one meanwhile.
  robotlink::Errors restoreAfterMakeWay() override;
  Going going() const override { return {running_, pace_.speed()}; }
  void inheritPlayback(const Going& before) override;

  /// Publishes scene, map, transforms, status, notes of the map, and the addresses of the ports.
  void begin() override;
  std::optional<robotlink::PacedThread::Clock::time_point> due() override;
  /// Makes one step; publishes transforms and status at their rates, or at once after a single step.
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  robotlink::Errors setLayoutOf(const std::string& name, const std::filesystem::path& file) override;
  /// Also publishes the scene, and which models could not keep their state.
  tl::expected<bool, robotlink::Errors> reload(FileTexts texts, bool mustFit) override;
  PlatformOpening reopening(FileTexts texts) const override;
  bool takeDescriptionChange() override { return std::exchange(descriptionChanged_, false); }
  LoadedPlatform describe() const override;
  void publishStatus() override;
  void setDemand(const Demand& demand) override;
  std::vector<std::string> end() override;
  bool hasEnded() const override { return !run_ || run_->hasEnded(); }
  std::shared_ptr<StopSwitch> stopSwitch() const override { return run_->stopSwitch(); }

 protected:
  /// Fulfilled even while the simulation is paused: STOP acts, and requests to programs are answered.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  /// Controls the simulation and its snapshots, or changes its world.
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;

 private:
  using Clock = robotlink::PacedThread::Clock;

  SimulationFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : gate_(session), recorder_(recorder) {}
  /// Listeners that publish.
  SimulatedRun::Listeners listeners();
  /// Publishes a text about the ports of programs in the log of the first robot.
  void publishPortText(const std::string& text, int level);
  /// Publishes a text about the game in the log of the first robot.
  void publishGame(const std::string& text);
  /// The simulation's time.
  robotlink::Instant now() const { return run_->world().clock().now(); }
  /// Makes the present instant due now.
  void restartPace() { pace_.restart(Clock::now(), now()); }
  // The handlers of requests.
  /// Starts, pauses, steps or resets the simulation, or sets its speed.
  robotlink::Result<void> controlSimulation(const robotcontrol::Request& request);
  robotlink::Result<void> changeWorld(const robotcontrol::Request& request);
  robotlink::Result<void> editScene(const robotcontrol::Request& request);
  robotlink::Result<void> hostProgram(const robotcontrol::Request& request);
  robotlink::Result<void> readPorts(const robotcontrol::Request& request);
  robotlink::Result<void> readForces(const robotcontrol::Request& request);
  robotlink::Result<void> controlSnapshots(const robotcontrol::Request& request);
  robotlink::Result<void> sendEvent(const robotcontrol::Request& request);
  robotlink::Result<void> attachController(const robotcontrol::Request& request);
  robotlink::Result<void> setPorts(const robotcontrol::Request& request);
  robotlink::Result<void> controlGame(const robotcontrol::Request& request);
  struct Handlers;

  /// Resets the run with the same seed, and publishes the scene again.
  robotlink::Result<void> reset();
  /// Keeps what was chosen for the next opening of the scene.
  void keepChoices() const;
  /// While the simulation is paused, publishes results that the programs would give in their next frames.
  /// Keeps solutions that were chosen.
  void publishAnswers();
  /// Publishes the overrides that the present programs cannot fulfill as warnings, where describe() is not
  /// asked.
  void publishLostOverrides();
  /// Publishes map, scene, transforms and status.
  void publishScene();
  /// Publishes a sentence about the simulation in the log of the first robot.
  void say(const std::string& text);
  /// Keeps layouts that were chosen, and publishes what the programs answer in them.
  void afterLayout();
  /// The game, if there is a referee.
  void publishGameStatus();
  /// The same at its rate, and when something has happened.
  void stepGame(Clock::time_point real);
  /// Unless nobody reads them.
  void publishTransforms();
  /// Publishes what is read or held of ports, if there is something.
  void publishPorts();
  /// Unless nobody reads them.
  void publishForces();
  /// Has contacts measured while a client reads their forces.
  void chooseForces();
  /// Publishes forces at their rate, until the requested time is over.
  void stepForces(Clock::time_point real);
  // Operations on snapshots.
  robotlink::Result<void> takeSnapshot(const robotcontrol::Request& request);
  robotlink::Result<void> restoreSnapshot(const robotcontrol::Request& request);
  robotlink::Result<void> rewind(double seconds);
  /// Publishes what there is now, since the world has jumped, and why.
  void publishJump(const std::string& text);
  void addSnapshots(robotcontrol::SimulationStatus& status) const;
  /// Publishes a text in the log of the first robot.
  void say(const std::string& text, int level);
  /// Fails while programs are run again, which the request would disturb.
  robotlink::Result<void> whetherFree(const robotcontrol::Request& request);
  /// Runs programs again for a moment.
  void runAgain();
  /// Connects ports and remote controllers with the world of the run, which may have been exchanged.
  void useWorld();
  /// A step's part that concerns controllers, before it and after it.
  void beforeControl(Clock::time_point real);
  void afterControl(Clock::time_point real);
  /// Publishes the inputs of remote controllers for the next step; `newOnly`: those that have just begun.
  void publishInputs(bool newOnly);
  /// Publishes the state of the controllers, if there are any, and the scene's objects, which name them.
  void publishControllers();
  /// Publishes the drawings of controllers.
  void publishDrawings();
  /// Publishes that at its rate, with the images that are due, and lets go what must not move.
  void stepPorts(Clock::time_point real);

  /// Publishes to the session from begin() on.
  PublishGate gate_;
  Demand demand_;
  logplayer::Recorder& recorder_;
  Choices choices_;
  std::unique_ptr<SimulatedRun> run_;
  /// Null before the run is made.
  std::unique_ptr<WorldPorts> ports_;
  /// Whether there are other robots since takeDescriptionChange().
  bool descriptionChanged_ = false;
  ExternalControllers external_;
  /// Whether controllers are to be published: one has begun, ended, or fallen behind.
  bool controllersChanged_ = false;
  /// Whether there was a controller since the simulation was opened.
  bool hadControllers_ = false;
  Clock::time_point lastDrawings_;
  bool running_ = false;
  /// Single steps that were requested and not made yet.
  int stepsWanted_ = 0;
  Pace pace_;
  /// The times of the last publications.
  Clock::time_point lastTransforms_, lastStatus_, lastPorts_, lastForces_, lastGame_;
  /// Referee::changes() at lastGame_.
  std::uint64_t gameChanges_ = 0;
  /// The end of the request for forces, and whether they are measured.
  Clock::time_point forcesUntil_;
  bool readsForces_ = false;
  SnapshotShelf snapshots_;
  /// The simulation's time at lastStatus_, for measuring the speed.
  robotlink::Instant lastStatusTime_;
  /// Times real time, since the status before.
  double measuredSpeed_ = 0;
};

}  // namespace app
