// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <set>
#include <string>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Solution.h"

namespace modules {

/// The context of a single solution, what a process is in a program: the test sets its inputs and reads its
/// outputs.
class OneSolution : public robotlink::SolutionContext {
 public:
  /// Time between two frames, s.
  static constexpr double kFrame = 0.1;

  /// The robot whose program it is a part of.
  struct Robot {
    std::shared_ptr<const robotlink::GroundMap> map;
    std::string name = "p3at1";
    /// In resources/robots.
    std::string description = "p3at.yaml";
    /// Whether all debug keys of the solution are on.
    bool keys = true;
    /// In resources/fields; empty: it is on no field.
    std::string field = {};
  };

  OneSolution(const std::string& task, const std::string& name) : OneSolution(task, name, Robot()) {}
  /// `setUp` sets the parameters before the solution is created.
  OneSolution(const std::string& task, const std::string& name, Robot robot,
              const std::function<void(google::protobuf::Message&)>& setUp = {})
      : debug_("process", clock_, {}), description_(robotlink::SolutionRegistry::find(task, name)) {
    setenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources", 1);
    setup_.name = robot.name;
    setup_.description =
        *robotlink::readRobotDescription(ROBOTCONTROL_SOURCE_DIR "/resources/robots/" + robot.description);
    setup_.map = std::move(robot.map);
    if (!robot.field.empty()) {
      setup_.field = std::make_shared<const robotlink::FieldDescription>(
          *robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/" + robot.field));
      // "blue2" plays in the blue team.
      setup_.team = robot.name.substr(0, robot.name.find_first_of("0123456789"));
    }
    if (description_->parameters != nullptr) parameters_.reset(description_->parameters->New());
    if (setUp) setUp(*parameters_);
    for (const auto* names : {&description_->required, &description_->optional})
      for (const std::string& package : *names) slots_[package];
    if (robot.keys) switchOnKeys();
    // Messages of its constructor belong to the first frame.
    solution_ = description_->create(*this);
  }

  /// Switches on all debug keys of the solution, or those of a name.
  void switchOnKeys(const std::string& name = {}) {
    robotcontrol::KeyMode mode;
    mode.set_kind(robotcontrol::KeyMode::ALWAYS);
    for (const int key : description_->keys) {
      const std::string& known = robotlink::DebugKey::all()[static_cast<std::size_t>(key)].name;
      if (name.empty() || known == name) debug_.setMode(key, mode);
    }
  }
  /// Sets an input for the next frame.
  template <typename T>
  void set(robotlink::Package<T> package, T value) {
    slots_.at(package.name) = {std::make_shared<const T>(std::move(value)), true};
  }
  /// The last value of an output; null if it has not been sent.
  template <typename T>
  const T* sent(robotlink::Package<T> package) const {
    const auto found = outputs_.find(package.name);
    return found == outputs_.end() ? nullptr : static_cast<const T*>(found->second.get());
  }
  template <typename P>
  P& parametersAs() {
    return static_cast<P&>(*parameters_);
  }
  /// Executes one frame; inputs that were set before are new only in this frame.
  void execute() {
    debug_.beginFrame(clock_.now(), static_cast<std::uint64_t>(++frame_));
    solution_->execute();
    debug_.endFrame();
    for (auto& [package, slot] : slots_) slot.isNew = false;
    remember();
  }
  /// Advances the clock.
  void pass(double seconds = kFrame) { clock_.advance(robotlink::fromSeconds(seconds)); }

  /// The paths and texts of all debug messages since the last call.
  std::set<std::string> takeReported() { return std::exchange(reported_, {}); }
  /// Number of occurrences of each text.
  const std::map<std::string, int>& texts() const { return texts_; }
  /// Whether a text contains a part.
  bool said(const std::string& part) const {
    return std::ranges::any_of(texts_,
                               [&](const auto& text) { return text.first.find(part) != std::string::npos; });
  }
  /// The debug keys that have not produced any message yet.
  std::set<std::string> silentKeys() const {
    std::set<std::string> silent;
    for (const int key : description_->keys) {
      const std::string& name = robotlink::DebugKey::all()[static_cast<std::size_t>(key)].name;
      if (std::ranges::none_of(paths_,
                               [&](const std::string& path) { return path.find(name) != std::string::npos; }))
        silent.insert(name);
    }
    return silent;
  }

  const robotlink::RobotSetup& robot() const override { return setup_; }
  const robotlink::ManualClock& clock() const override { return clock_; }
  robotlink::DebugContext& debug() override { return debug_; }

 protected:
  const robotlink::PackageSlot& inputSlot(const char* package) override { return slots_.at(package); }
  std::function<void(robotlink::PackagePtr)> outputSend(const char* package) override {
    return [this, name = std::string(package)](robotlink::PackagePtr value) {
      outputs_[name] = std::move(value);
    };
  }
  const google::protobuf::Message& parameterMessage() override { return *parameters_; }

 private:
  /// Collects texts and paths of the debug messages.
  void remember() {
    while (debug_.hasQueue()) {
      const auto queue = debug_.takeQueue();
      for (const auto& message : queue->messages) {
        paths_.insert(message.path);
        reported_.insert(message.path);
        const auto* text = message.as<foxglove::Log>();
        if (text == nullptr) continue;
        ++texts_[text->message()];
        reported_.insert(text->message());
      }
    }
  }

  robotlink::ManualClock clock_;
  robotlink::DebugContext debug_;
  const robotlink::SolutionDescription* description_;
  robotlink::RobotSetup setup_;
  std::unique_ptr<google::protobuf::Message> parameters_;
  std::map<std::string, robotlink::PackageSlot> slots_;
  std::map<std::string, robotlink::PackagePtr> outputs_;
  std::unique_ptr<robotlink::Solution> solution_;
  std::map<std::string, int> texts_;
  std::set<std::string> paths_, reported_;
  int frame_ = 0;
};

}  // namespace modules
