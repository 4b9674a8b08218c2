// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/core/program/Pace.h"
#include "app/core/program/PlatformFeed.h"
#include "app/core/program/PublishGate.h"
#include "app/core/simulated/SimulatedRun.h"

namespace robotcontrol {
class ControlSimulation;
}

namespace app {

/// A SimulatedRun in the workbench: stepped at a chosen speed, it tells a session what happens in the world
/// and what the programs say, and a recorder. Both must outlive it.
class SimulationFeed final : public PlatformFeed {
 public:
  static constexpr const char* kAdapter = "simulation";

  /// `choices` is given the options with which it runs, whenever they change, in the platform's thread.
  using Choices = std::function<void(const RunOptions& options)>;
  static PlatformOpening opening(RunOptions options, Choices choices = {});
  static tl::expected<std::unique_ptr<SimulationFeed>, robotlink::Errors> create(
      RunOptions options, robotlink::Session& session, logplayer::Recorder& recorder, Choices choices = {});

  // Another simulation may want the same ports before it is known that it can be run.
  bool makeWay() override;
  robotlink::Errors goOn() override;
  Going going() const override { return {running_, pace_.speed()}; }
  void inheritPlayback(const Going& before) override;

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override;
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;

 protected:
  /// STOP acts even while the simulation is paused, and requests to programs are answered then, too.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;

 private:
  using Clock = PacedThread::Clock;

  SimulationFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : outlet_(session), recorder_(recorder) {}
  SimulatedRun::Listeners listeners();
  void publishPorts(const std::string& text, int level);
  void publishGame(const std::string& text);
  robotlink::Instant now() const { return run_->world().clock().now(); }
  void restartPace() { pace_.restart(Clock::now(), now()); }
  robotlink::Result<void> control(const robotcontrol::ControlSimulation& control);
  robotlink::Result<void> reset();
  void publishAnswers();
  void publishLostOverrides();
  void publishScene();
  void publishTransforms();

  PublishGate outlet_;
  logplayer::Recorder& recorder_;
  Choices choices_;
  std::unique_ptr<SimulatedRun> run_;
  bool running_ = false;
  int stepsWanted_ = 0;
  Pace pace_;
  Clock::time_point lastTransforms_, lastStatus_;
  robotlink::Instant lastStatusTime_;
  double measuredSpeed_ = 0;
};

}  // namespace app
