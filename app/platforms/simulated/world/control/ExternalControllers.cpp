// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/control/ExternalControllers.h"

#include <algorithm>
#include <set>
#include <span>

#include "app/platforms/simulated/world/control/ControlMessages.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/Simulation.h"
#include "simcore/control/Controllers.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;
using simcore::Port;

/// The maximum number of events that wait for a controller that gets inputs rarely.
constexpr std::size_t kMaxUntoldEvents = 1000;
constexpr std::size_t kMaxName = 60;

bool isControllerName(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= kMaxName && std::ranges::all_of(name, fits);
}

Result<void> checkReadable(const simcore::Simulation& simulation, const std::string& path) {
  if (simulation.port(path) != nullptr || simulation.portOfTruth(path) != nullptr) return {};
  return failure(
      "simulation.port",
      "there is no sensor or actuator " + path + robotlink::suggestion(path, simulation.readablePaths()), {},
      {path});
}

/// Unset if its size is impossible.
std::optional<ExternalControllers::Output> outputOf(const std::string& controller,
                                                    const robotcontrol::WorldPort& port) {
  ExternalControllers::Output output;
  output.info = {controller + "/" + port.path(), controller, port.type(), {}, port.unit()};
  output.info.minimum = port.minimum();
  output.info.maximum = port.maximum();
  std::size_t count = 1;
  for (const int size : port.shape()) {
    if (size < 1 || static_cast<std::size_t>(size) > ExternalControllers::kMaxValues) return std::nullopt;
    count *= static_cast<std::size_t>(size);
    if (count > ExternalControllers::kMaxValues) return std::nullopt;
    output.info.shape.push_back(size);
  }
  output.values.assign(count, 0);
  return output;
}

}  // namespace

Result<ExternalControllers::Attached> ExternalControllers::read(const robotcontrol::AttachController& request,
                                                                const simcore::Simulation& simulation) {
  Attached attached;
  for (const std::string& path : request.sensors()) {
    if (auto known = checkReadable(simulation, path); !known) return tl::unexpected(known.error());
    attached.sensors.push_back(path);
  }
  std::set<std::string> paths;
  for (const auto& port : request.outputs()) {
    auto output = outputOf(request.name(), port);
    const bool isNew = output && !port.path().empty() && port.path().size() <= kMaxName &&
                       simulation.port(output->info.path) == nullptr && paths.insert(port.path()).second;
    if (!isNew)
      return failure("simulation.controller",
                     "the output '" + port.path() + "' needs a path of its own and 1 to 10000 values", {},
                     {port.path()});
    attached.outputs.push_back(*std::move(output));
  }
  attached.lockstep = request.lockstep();
  if (request.patience() > 0) attached.patience = std::chrono::duration<double>(request.patience());
  attached.every = std::max(1U, request.every());
  return attached;
}

Result<void> ExternalControllers::attach(const robotcontrol::AttachController& request,
                                         simcore::Simulation& simulation) {
  const std::string& name = request.name();
  if (request.ended()) {
    commands_.release(simulation, name);
    if (all_.erase(name) > 0) return {};
    return failure("simulation.controller", "there is no controller " + name, {}, {name});
  }
  if (!isControllerName(name))
    return failure("simulation.controller", "the name of a controller has letters, digits, _ and - only", {},
                   {name});
  const auto own = simulation.controllers();
  const bool isTaken =
      std::ranges::any_of(own, [&](const auto& status) { return status.path == name; }) ||
      std::ranges::any_of(simulation.ports(), [&](const Port& port) { return port.info.robot == name; });
  if (isTaken)
    return failure("simulation.controller", name + " is the name of a model or controller of the scene", {},
                   {name});
  if (all_.size() >= kMaxControllers && !all_.contains(name))
    return failure("simulation.controller", "there are 20 controllers already");
  auto attached = read(request, simulation);
  if (!attached) return tl::unexpected(attached.error());
  commands_.release(simulation, name);
  all_[name] = *std::move(attached);
  return {};
}

Result<void> ExternalControllers::set(const robotcontrol::SetPorts& request,
                                      const simcore::Simulation& simulation) {
  const std::string& name = request.controller();
  const auto found = all_.find(name);
  if (found == all_.end())
    return failure("simulation.controller", "the controller " + name + " is not attached", {}, {name});
  Attached& attached = found->second;
  // The simulation waits for this controller again. An answer to an earlier step is too late for this one.
  attached.isLate = false;
  if (attached.owes && request.step() >= *attached.owes) attached.owes.reset();
  for (const auto& reading : request.outputs()) {
    const std::string path = name + "/" + reading.port();
    const auto output =
        std::ranges::find(attached.outputs, path, [](const Output& each) { return each.info.path; });
    if (output == attached.outputs.end() ||
        static_cast<std::size_t>(reading.values_size()) != output->values.size())
      return failure("simulation.controller",
                     name + " has no output '" + reading.port() + "' with " +
                         std::to_string(reading.values_size()) + " values",
                     {}, {reading.port()});
    output->values.assign(reading.values().begin(), reading.values().end());
  }
  for (const auto& command : request.commands()) {
    const auto done =
        commands_.set(simulation, name, command.port(), {command.values().begin(), command.values().end()});
    if (!done) return done;
  }
  return {};
}

void ExternalControllers::restart() {
  commands_.forget();
  for (auto& [name, attached] : all_) {
    attached.owes.reset();
    attached.left = 0;
    attached.events.clear();
    for (Output& output : attached.outputs) std::ranges::fill(output.values, 0.0);
  }
}

std::optional<ExternalControllers::RealTime> ExternalControllers::waitsUntil() const {
  std::optional<RealTime> until;
  for (const auto& [name, attached] : all_) {
    if (!attached.lockstep || !attached.owes || attached.isLate) continue;
    until = std::max(until.value_or(attached.deadline), attached.deadline);
  }
  return until;
}

std::vector<std::string> ExternalControllers::beforeStep(RealTime now, simcore::Simulation& simulation) {
  std::vector<std::string> sentences;
  for (auto& [name, attached] : all_) {
    if (!attached.lockstep || !attached.owes || attached.isLate || now < attached.deadline) continue;
    attached.isLate = true;
    ++attached.late;
    commands_.release(simulation, name);
    sentences.push_back("The controller " + name + " has not answered step " +
                        std::to_string(*attached.owes) + " in time; the simulation continues without it.");
  }
  return sentences;
}

void ExternalControllers::noteEvents(std::span<const simcore::ViewEvent> events) {
  for (auto& [name, attached] : all_) {
    for (const simcore::ViewEvent& event : events) {
      if (attached.events.size() >= kMaxUntoldEvents) break;
      attached.events.push_back(event);
    }
  }
}

std::vector<robotlink::StreamMessage> ExternalControllers::inputs(const simcore::Simulation& simulation,
                                                                  robotlink::Instant time, RealTime now,
                                                                  bool newOnly) {
  std::vector<robotlink::StreamMessage> messages;
  for (auto& [name, attached] : all_) {
    const bool isNew = !attached.owes && attached.left == 0;
    if (newOnly && !isNew) continue;
    if (attached.left > 0 && --attached.left > 0) continue;
    attached.left = attached.every;
    auto inputs = std::make_shared<robotcontrol::ControllerInputs>();
    robotlink::assign(*inputs->mutable_timestamp(), time);
    inputs->set_step(simulation.steps());
    const std::string stream = robotlink::streams::kControllerInputs + name;
    for (const std::string& path : attached.sensors) {
      const Port* port = simulation.port(path);
      if (port != nullptr && port->kind == Port::Kind::kCamera) {
        auto image = std::make_shared<foxglove::RawImage>();
        robotlink::assign(*image, simulation.cameraImage(port->index).view(), time, path);
        messages.push_back({stream + "/" + path, time, std::move(image)});
        continue;
      }
      if (auto reading = readingOf(simulation, path)) *inputs->add_readings() = *std::move(reading);
    }
    for (const simcore::ViewEvent& event : attached.events) assign(*inputs->add_events(), event);
    attached.events.clear();
    attached.owes = simulation.steps();
    attached.deadline =
        now + std::chrono::duration_cast<std::chrono::steady_clock::duration>(attached.patience);
    messages.push_back({stream, time, std::move(inputs)});
  }
  return messages;
}

bool ExternalControllers::anyIsLate() const {
  return std::ranges::any_of(all_, [](const auto& each) { return each.second.isLate; });
}

std::vector<std::string> ExternalControllers::names() const {
  std::vector<std::string> names;
  for (const auto& [name, attached] : all_) names.push_back(name);
  return names;
}

std::vector<const ExternalControllers::Output*> ExternalControllers::outputs() const {
  std::vector<const Output*> outputs;
  for (const auto& [name, attached] : all_)
    for (const Output& output : attached.outputs) outputs.push_back(&output);
  return outputs;
}

void ExternalControllers::addStates(robotcontrol::ControllerStates& to) const {
  for (const auto& [name, attached] : all_) {
    auto& state = *to.add_controllers();
    state.set_path(name);
    state.set_is_on(!attached.isLate);
    state.set_is_external(true);
    state.set_lockstep(attached.lockstep);
    state.set_late(attached.late);
    if (attached.isLate) state.set_trouble("it does not answer in time");
  }
}

}  // namespace app
