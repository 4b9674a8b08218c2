// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/platforms/replay/ReplayRun.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/session/QueueMessages.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"

namespace app::test {

using robotlink::Instant;
using robotlink::StreamMessage;

inline Instant at(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

/// Records a simulation from its start, in steps of 8 ms; `before` is called before each step.
inline void recordSimulation(const std::filesystem::path& file, const RunOptions& options, int steps,
                             const std::function<void(SimulatedRun&, int step)>& before = {}) {
  logplayer::Recorder recorder({});
  robotcontrol::ControlRecording control;
  control.set_action(robotcontrol::ControlRecording::START);
  control.set_path(file.string());
  ASSERT_TRUE(recorder.control(control).has_value());
  auto run = SimulatedRun::create(options, {}, &recorder);
  ASSERT_TRUE(run.has_value()) << robotlink::describe(run.error());
  for (int i = 0; i < steps; ++i) {
    if (before) before(**run, i);
    (*run)->step();
  }
  run->reset();
  control.set_action(robotcontrol::ControlRecording::STOP);
  ASSERT_TRUE(recorder.control(control).has_value());
  recorder.finish();
}

/// The same for the robot of the shipped scene with a layout.
inline void recordSimulation(const std::filesystem::path& file, const std::string& layout, int steps,
                             const std::function<void(SimulatedRun&, int step)>& before = {}) {
  RunOptions options = defaultSimulation();
  options.layout = robotlink::resource("layouts/" + layout + ".yaml");
  recordSimulation(file, options, steps, before);
}

inline ReplayOptions replayOf(std::vector<ReplayLog> logs) {
  ReplayOptions options;
  options.logs = std::move(logs);
  return options;
}

/// A replay that collects everything it publishes.
struct Replay {
  explicit Replay(ReplayOptions options) {
    ReplayRun::Listeners listeners;
    listeners.logged = [this](std::vector<StreamMessage> messages) {
      reported.insert(reported.end(), messages.begin(), messages.end());
    };
    listeners.queue = [this](const std::string& robot, const auto& queue) {
      auto taken = robotlink::messagesOf(robot, *queue, {}, robotlink::QueueReader::kRecorder);
      reported.insert(reported.end(), taken.messages.begin(), taken.messages.end());
      for (const auto& result : taken.results) results.push_back(*result);
    };
    listeners.trouble = [this](const std::string& robot, const robotlink::Process&, const std::string& text) {
      troubles.push_back(robot + ": " + text);
    };
    auto made = ReplayRun::create(std::move(options), std::move(listeners));
    if (made) {
      run = std::move(*made);
    } else {
      errors = made.error();
    }
  }
  explicit Replay(const std::filesystem::path& file) : Replay(replayOf({{file}})) {}

  void playToEnd() {
    while (run->step()) {
    }
  }
  robotcontrol::ReplayStatus status() const {
    robotcontrol::ReplayStatus status;
    run->describe(status);
    return status;
  }
  /// A hash of all messages on a path; empty if there are none.
  std::string digestOn(const std::string& path) const {
    std::string bytes;
    for (const auto& message : reported) {
      if (message.path == path) bytes += message.value->SerializeAsString() + "\n";
    }
    return bytes.empty() ? "" : std::to_string(std::hash<std::string>{}(bytes));
  }
  std::size_t countOn(const std::string& path) const {
    std::size_t count = 0;
    for (const auto& message : reported) count += message.path == path ? 1 : 0;
    return count;
  }
  /// The last message on a path; null if there is none.
  const StreamMessage* lastOn(const std::string& path) const {
    const StreamMessage* last = nullptr;
    for (const auto& message : reported) {
      if (message.path == path) last = &message;
    }
    return last;
  }

  std::unique_ptr<ReplayRun> run;
  /// Why `run` is null.
  robotlink::Errors errors;
  std::vector<StreamMessage> reported;
  std::vector<robotcontrol::RequestResult> results;
  std::vector<std::string> troubles;
};

/// Options that recompute every package for which that is possible.
inline ReplayOptions recomputingAll(const std::filesystem::path& file) {
  ReplayOptions options = replayOf({{file}});
  const Replay asLogged(options);
  if (!asLogged.run) return options;
  const auto status = asLogged.status();
  for (const auto& package : status.packages()) {
    if (package.can_recompute())
      options.packages[package.package()] = robotcontrol::ControlReplay::RECOMPUTED;
  }
  return options;
}

/// The packages that are recomputed although the log may hold them.
inline std::vector<std::string> recomputedPackages(const robotcontrol::ReplayStatus& status) {
  std::vector<std::string> names;
  for (const auto& package : status.packages()) {
    if (package.source() == robotcontrol::ControlReplay::RECOMPUTED && package.can_recompute())
      names.push_back(package.package());
  }
  return names;
}

}  // namespace app::test
