// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/Controllers.h"

#include <algorithm>
#include <bit>
#include <exception>
#include <stdexcept>

#include "robotlink/base/Random.h"
#include "simcore/control/ControllerSetup.h"

namespace simcore {
namespace {

bool isSameOutput(const ControllerOutput& a, const ControllerOutput& b) {
  return a.info.path == b.info.path && a.info.type == b.info.type && a.info.shape == b.info.shape &&
         a.kind == b.kind;
}

/// Clears the contents of an output.
void clearOutput(ControllerOutput& output) {
  output.shapes.clear();
  std::ranges::fill(output.values, 0.0);
  std::ranges::fill(output.image.data, std::uint8_t{0});
}

std::uint64_t hashOfOutput(const ControllerOutput& output) {
  std::uint64_t hash = output.values.size();
  const auto mix = [&hash](std::uint64_t value) { hash = robotlink::mixBits(hash ^ value); };
  for (const double value : output.values) mix(std::bit_cast<std::uint64_t>(value));
  for (const std::uint8_t value : output.image.data) hash = (hash ^ value) * 0x100000001B3ULL;
  for (const DrawnShape& shape : output.shapes) {
    mix(static_cast<std::uint64_t>(shape.kind));
    for (const auto& point : shape.points) {
      for (int k = 0; k < 3; ++k) mix(std::bit_cast<std::uint64_t>(point[k]));
    }
    for (const char c : shape.text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 0x100000001B3ULL;
  }
  return robotlink::mixBits(hash);
}

}  // namespace

struct Controllers::Running {
  const ControllerDescription& description;
  std::string model;
  std::deque<ControllerOutput> outputs = {};
  /// After the outputs, to which it may refer; null while it is off.
  std::unique_ptr<Controller> controller = nullptr;
};

Controllers::Controllers(const WorldDescription& world) {
  const auto add = [this](const std::vector<ControllerDescription>& described, const std::string& model) {
    for (const ControllerDescription& each : described) {
      all_.push_back(std::make_unique<Running>(Running{each, model}));
      status_.push_back({(model.empty() ? "" : model + "/") + each.name, model, each.kind});
    }
  };
  add(world.controllers, {});
  for (const ModelInstance& model : world.models) add(model.type->controllers, model.name);
}

Controllers::~Controllers() = default;

void Controllers::switchOff(std::size_t index, std::uint64_t step, const std::string& why) {
  status_[index].trouble = why.empty() ? "it failed without a reason" : why;
  status_[index].troubleStep = step;
  all_[index]->controller.reset();
}

template <typename Call>
void Controllers::guard(std::size_t index, std::uint64_t step, Call call) {
  try {
    call();
  } catch (const std::exception& error) {
    switchOff(index, step, error.what());
  } catch (...) {
    switchOff(index, step, "it threw something that is not a std::exception");
  }
}

void Controllers::make(std::size_t index, ControlledWorld& world) {
  Running& running = *all_[index];
  running.controller.reset();
  status_[index].trouble.clear();
  std::deque<ControllerOutput> before = std::move(running.outputs);
  running.outputs.clear();
  const ControllerKind* kind = controllerKind(running.description.kind);
  if (kind == nullptr) return switchOff(index, world.step(), "there is no such controller");
  guard(index, world.step(), [&] {
    ControllerSetup setup(*kind, running.description, running.model, world, running.outputs);
    running.controller = kind->make(setup);
    if (!running.controller) throw std::runtime_error("it could not be made");
    if (hasStarted_ && !std::ranges::equal(before, running.outputs, isSameOutput))
      throw std::runtime_error("its outputs differ from those before the reset");
  });
  if (!hasStarted_ || running.controller) return;
  // Views continue to read the previous outputs.
  for (ControllerOutput& output : before) clearOutput(output);
  running.outputs = std::move(before);
}

void Controllers::start(ControlledWorld& world) {
  outputs_.clear();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    make(i, world);
    for (const ControllerOutput& output : all_[i]->outputs) outputs_.push_back(&output);
  }
  hasStarted_ = true;
}

void Controllers::checkOutputs(std::size_t index, std::uint64_t step) {
  for (ControllerOutput& output : all_[index]->outputs) {
    const std::string wrong = output.problem();
    if (wrong.empty()) continue;
    const auto count = output.info.shape;
    std::size_t size = 1;
    for (const int each : count) size *= static_cast<std::size_t>(each);
    if (output.kind == ControllerOutput::Kind::kValues) output.values.assign(size, 0);
    if (output.kind == ControllerOutput::Kind::kImage) {
      output.image.height = count[0];
      output.image.width = count[1];
      output.image.format = count[2] == 1 ? robotlink::PixelFormat::kMono8 : robotlink::PixelFormat::kRgb8;
      output.image.data.assign(size, 0);
    }
    output.shapes.clear();
    switchOff(index, step, "its output " + output.info.path + " is wrong: " + wrong);
  }
}

void Controllers::step(ControlledWorld& world) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    if (!all_[i]->controller) continue;
    guard(i, world.step(), [&] { all_[i]->controller->step(world); });
    checkOutputs(i, world.step());
  }
}

std::vector<std::string> Controllers::states() const {
  std::vector<std::string> states;
  for (const auto& running : all_) {
    std::string state;
    // A state that cannot be determined is dropped.
    try {
      if (running->controller) state = running->controller->state();
    } catch (...) {
      state.clear();
    }
    states.push_back(std::move(state));
  }
  return states;
}

Controllers::Memory Controllers::memory() const {
  Memory memory{.states = states()};
  for (const ControllerOutput* output : outputs_) memory.shown.push_back(*output);
  for (const ControllerStatus& each : status_) memory.troubles.emplace_back(each.trouble, each.troubleStep);
  return memory;
}

void Controllers::restore(const Memory& memory, std::uint64_t step) {
  for (std::size_t i = 0; i < std::min(memory.states.size(), all_.size()); ++i) {
    if (!all_[i]->controller) continue;
    guard(i, step, [&] { all_[i]->controller->restore(memory.states[i]); });
  }
  // The outputs now show the state after the start or after being restored.
  std::size_t next = 0;
  for (const auto& running : all_) {
    for (ControllerOutput& output : running->outputs) {
      if (next < memory.shown.size() && isSameOutput(output, memory.shown[next])) output = memory.shown[next];
      ++next;
    }
  }
  for (std::size_t i = 0; i < std::min(memory.troubles.size(), all_.size()); ++i) {
    const auto& [why, since] = memory.troubles[i];
    if (!why.empty()) switchOff(i, since, why);
  }
}

void Controllers::adopt(const Controllers& before) {
  const std::vector<std::string> states = before.states();
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const auto same = std::ranges::find_if(before.status_, [&](const ControllerStatus& each) {
      return each.path == status_[i].path && each.kind == status_[i].kind;
    });
    if (same == before.status_.end() || !same->isOn() || !all_[i]->controller) continue;
    const auto& state = states[static_cast<std::size_t>(same - before.status_.begin())];
    if (!state.empty()) guard(i, same->troubleStep, [&] { all_[i]->controller->restore(state); });
  }
}

std::uint64_t Controllers::digest() const {
  std::uint64_t hash = 0;
  for (const ControllerOutput* output : outputs_) hash = robotlink::mixBits(hash ^ hashOfOutput(*output));
  for (const ControllerStatus& each : status_) {
    if (!each.isOn()) hash = robotlink::mixBits(hash ^ each.troubleStep);
  }
  return hash;
}

}  // namespace simcore
