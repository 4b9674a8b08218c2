// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "logplayer/base/RecordedStreams.h"
#include "logplayer/record/Recorder.h"
#include "tests/logplayer/RecordedMessages.h"

namespace logplayer::tests {

using robotcontrol::ControlRecording;

/// A recorder whose files are in a temporary folder and whose warnings are kept.
class RecorderTest : public ::testing::Test {
 protected:
  Recorder::Options options() {
    Recorder::Options given;
    given.folder = folder / "documents";
    given.warn = [this](const std::string& text) {
      const std::lock_guard lock(mutex_);
      warnings_.push_back(text);
    };
    return given;
  }
  void make(Recorder::Options given) { recorder = std::make_unique<Recorder>(std::move(given)); }
  void SetUp() override { make(options()); }

  robotlink::Result<void> act(ControlRecording::Action action, const std::string& path = {}) {
    ControlRecording control;
    control.set_action(action);
    control.set_path(path);
    return recorder->control(control);
  }
  void start(const std::string& name = "a.mcap") {
    const auto started = act(ControlRecording::START, folder / name);
    ASSERT_TRUE(started.has_value()) << started.error().text;
  }
  void stop() {
    ASSERT_TRUE(act(ControlRecording::STOP).has_value());
    recorder->finish();
  }
  void set(const std::function<void(ControlRecording&)>& change) {
    ControlRecording control;
    change(control);
    ASSERT_TRUE(recorder->control(control).has_value());
  }
  void choose(const std::string& streams) {
    set([&](ControlRecording& control) { *control.mutable_selection() = *readSelection(streams); });
  }
  void keep(double seconds) {
    set([&](ControlRecording& control) { control.set_keep_last(seconds); });
  }
  /// Frame i of cognition, at 8 ms each: a plot and its FrameInfo.
  void addFrame(int i) {
    const auto number = static_cast<std::uint64_t>(i);
    recorder->add({plot("red1/plots/x", 8 * i, i, "cognition", number), frameInfo(8 * i, number)});
  }
  ReadLog log(const std::string& name = "a.mcap") const { return readLog(folder / name); }
  std::vector<std::string> warnings() {
    const std::lock_guard lock(mutex_);
    return warnings_;
  }

  TestFolder folder;
  std::unique_ptr<Recorder> recorder;

 private:
  std::mutex mutex_;  // protects warnings_
  std::vector<std::string> warnings_;
};

}  // namespace logplayer::tests
