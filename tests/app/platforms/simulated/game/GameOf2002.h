// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/core/program/ShippedFiles.h"
#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/app/SimulatedRuns.h"

namespace app::test {

/// A shipped game whose robots stand unless a test moves them, without noise, and what its referee said.
struct GameOf2002 {
  std::vector<std::string> texts;
  std::unique_ptr<SimulatedRun> run;

  static RunOptions options(const std::string& scene = "game2002-2") {
    RunOptions options = simulationOptions();
    options.scene = sceneNamed(scene);
    options.solutions["behavior"] = "stand";
    options.world.blackout = true;
    options.world.noise = false;
    return options;
  }
  explicit GameOf2002(const RunOptions& options = GameOf2002::options()) {
    SimulatedRun::Listeners listeners;
    listeners.game = [this](robotlink::Instant, const std::string& text) { texts.push_back(text); };
    run = makeRun(options, listeners);
  }
  const Referee& referee() const { return *run->referee(); }
  GameMachine::Phase phase() const { return referee().machine().phase(); }
  void play(double seconds) { test::play(*run, seconds); }
  /// Plays until the phase has begun, but no longer than 10 s.
  void playUntil(GameMachine::Phase wanted) {
    for (int i = 0; i < 1250 && phase() != wanted; ++i) run->step();
    EXPECT_EQ(phase(), wanted);
  }
  void place(const std::string& model, const robotlink::Pose2& pose) {
    const auto placed = run->world().simulation().placeModel(model, pose);
    EXPECT_TRUE(placed) << (placed ? "" : placed.error().describe());
  }
  robotlink::Pose2 poseOf(const std::string& model) const {
    return robotlink::groundPose(run->world().simulation().modelPose(model).value());
  }
  robotlink::Result<void> ask(const robotcontrol::ControlGame& control) {
    robotcontrol::Request request;
    *request.mutable_control_game() = control;
    return run->controlGame(request);
  }
  robotlink::Result<void> ask(robotcontrol::ControlGame::Action action, const std::string& whom = {},
                              const std::string& reason = {}) {
    robotcontrol::ControlGame control;
    control.set_action(action);
    control.set_robot(whom);
    control.set_team(whom);
    control.set_reason(reason);
    return ask(control);
  }
  bool said(const std::string& text) const { return std::ranges::find(texts, text) != texts.end(); }
};

}  // namespace app::test
