// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/core/Outlet.h"
#include "app/core/Pace.h"
#include "app/core/PlatformFeed.h"

namespace robotcontrol {
class ControlSimulation;
}

namespace app {

/// A SimulatedRun in the workbench: stepped at a chosen speed, it tells a session what happens in the world
/// and what the programs say, and a recorder. Both must outlive it.
class SimulationFeed final : public PlatformFeed {
 public:
  static tl::expected<std::unique_ptr<SimulationFeed>, robotlink::Errors> create(
      RunOptions options, robotlink::Session& session, logplayer::Recorder& recorder);

  /// Runs, and at the speed, as another one did that it takes the place of.
  void goOnLike(const SimulationFeed& before);

  // Another simulation may want the same ports before it is known that it can be run.
  void closePorts() { run_->closePorts(); }
  robotlink::Result<void> openPorts() { return run_->openPorts(); }

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override;
  void step() override;
  /// STOP acts even while the simulation is paused, and requests to programs are answered then, too.
  robotlink::Result<Answer> fulfil(const robotcontrol::Request& request) override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;

 private:
  using Clock = PacedThread::Clock;

  SimulationFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : outlet_(session), recorder_(recorder) {}
  SimulatedRun::Listeners listeners();
  void tellOfPorts(const std::string& text, int level);
  void tellOfGame(const std::string& text);
  robotlink::Instant now() const { return run_->world().clock().now(); }
  void restartPace() { pace_.restart(Clock::now(), now()); }
  robotlink::Result<void> control(const robotcontrol::ControlSimulation& control);
  robotlink::Result<void> reset();
  void tellAnswers();
  void tellLostChoices();
  void publishScene();
  void publishTransforms();

  Outlet outlet_;
  logplayer::Recorder& recorder_;
  std::unique_ptr<SimulatedRun> run_;
  bool running_ = false;
  int stepsWanted_ = 0;
  Pace pace_;
  Clock::time_point lastTransforms_, lastStatus_;
  robotlink::Instant lastStatusTime_;
  double measuredSpeed_ = 0;
};

}  // namespace app
