// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/core/own/StandInProcess.h"
#include "app/core/program/HostedProgram.h"
#include "app/core/program/HostedRobot.h"
#include "app/core/program/RobotFiles.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/process/Platform.h"

namespace app::test {

/// Refuses requests about these debug keys and solutions.
class FakePreview final : public ProgramPreview {
 public:
  explicit FakePreview(std::set<std::string> refused) : refused_(std::move(refused)) {}
  std::string add(const robotcontrol::Request& request) override {
    const std::string& name =
        request.has_set_key() ? request.set_key().name() : request.select_solution().solution();
    return refused_.contains(name) ? "there is no " + name : "";
  }
  bool answer(const robotcontrol::Request& request) override { return add(request).empty(); }
  std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(robotlink::Instant) override {
    return nullptr;
  }

 private:
  const std::set<std::string> refused_;
};

/// A program without processes: notes what its host asks of it.
class FakeProgram final : public HostedProgram {
 public:
  explicit FakeProgram(const robotlink::Clock& clock) : debug_("debug", clock) {}
  ~FakeProgram() override {
    if (onEnd) onEnd();
  }

  void setListeners(Listeners listeners) override { this->listeners = std::move(listeners); }
  std::vector<robotcontrol::ParameterValues> parameters() const override { return {}; }
  void recordPackages(const std::set<std::string>& packages) override { recorded = packages; }
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) override { keys = modes; }
  const robotlink::Layout& layout() const override { return layout_; }
  std::vector<std::string> yieldedPackages() const override { return yielded; }
  const std::vector<robotlink::Process*>& processes() const override { return processes_; }
  const robotlink::Process& debugProcess() const override { return debug_; }
  StandInProcess& debug() { return debug_; }
  bool request(const robotcontrol::Request& request) override {
    if (isFull) return false;
    requests.push_back(request);
    return true;
  }
  std::string refusal() const override { return why; }
  std::string missingProcess() const override { return missing; }
  std::unique_ptr<ProgramPreview> preview() override { return std::make_unique<FakePreview>(unknown); }
  robotcontrol::HostingStatus hosting() const override { return status; }
  void stop() override { ++stops; }

  Listeners listeners;
  std::set<std::string> recorded;
  std::map<std::string, robotcontrol::KeyMode> keys;
  std::vector<std::string> yielded;
  /// The keys and solutions that it does not have.
  std::set<std::string> unknown;
  std::vector<robotcontrol::Request> requests;
  /// Whether it takes no requests now.
  bool isFull = false;
  /// Why it takes none.
  std::string why;
  std::string missing;
  robotcontrol::HostingStatus status;
  int stops = 0;
  std::function<void()> onEnd;

 private:
  robotlink::Layout layout_;
  StandInProcess debug_;
  std::vector<robotlink::Process*> processes_;
};

/// A platform of which a test sees what it was asked.
class FakePlatform final : public robotlink::Platform {
 public:
  explicit FakePlatform(const robotlink::Clock& clock) : Platform("body", clock) {}
  ~FakePlatform() override {
    if (onEnd) onEnd();
  }

  void initialize() override {
    ++initialized;
    report("The legs are warm.");
  }
  void shutDown() override {
    ++shut;
    report("The legs are cold.");
  }
  void actuate() override { ++actuated; }
  void engageStop(bool engaged) override { stopped = engaged; }
  bool stopEngaged() const override { return stopped; }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override {
    controls.push_back(details);
    return {};
  }
  std::string refusal() const override { return why; }

  int initialized = 0, shut = 0, actuated = 0;
  bool stopped = false;
  std::vector<robotcontrol::ControlDrive> controls;
  std::string why;
  std::function<void()> onEnd;
  /// Called in each frame, to send something.
  std::function<void()> frame;

 protected:
  void execute() override {
    if (frame) frame();
  }
};

inline HostedRobot fakeRobot() {
  return {.name = "red1",
          .team = "red",
          .description = readRobot("p3at").value(),
          .field = readField({}).value()};
}

}  // namespace app::test
