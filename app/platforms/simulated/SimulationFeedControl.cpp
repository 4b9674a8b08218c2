// SPDX-License-Identifier: GPL-3.0-or-later
// SimulationFeed: local and remote controllers, events of views, and drawings of controllers.
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/platforms/simulated/world/WorldObjects.h"
#include "app/platforms/simulated/world/control/ControlMessages.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/control/Controllers.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kDrawingsPeriod{33};

}  // namespace

void SimulationFeed::useWorld() {
  const auto before = std::move(ports_);
  ports_ = std::make_unique<WorldPorts>(run_->world(), &external_, before.get());
  run_->world().setCommands(&external_.commands());
}

robotlink::Result<void> SimulationFeed::sendEvent(const robotcontrol::Request& request) {
  simcore::Simulation& simulation = run_->world().simulation();
  if (simulation.controllers().empty() && external_.isEmpty())
    return robotlink::failure("simulation.no-controller",
                              "no controller, in the scene or "
                              "external, receives keys and clicks");
  return simulation.addEvent(viewEvent(request.send_event()));
}

robotlink::Result<void> SimulationFeed::attachController(const robotcontrol::Request& request) {
  const auto done = external_.attach(request.attach_controller(), run_->world().simulation());
  if (!done) return done;
  publishControllers();
  publishInputs(true);
  return {};
}

robotlink::Result<void> SimulationFeed::setPorts(const robotcontrol::Request& request) {
  const bool wasLate = external_.anyIsLate();
  const auto done = external_.set(request.set_ports(), run_->world().simulation());
  if (wasLate) controllersChanged_ = true;
  return done;
}

void SimulationFeed::beforeControl(Clock::time_point real) {
  if (external_.isEmpty()) return;
  external_.commands().setStopped(run_->stoppedRobots());
  for (const std::string& text : external_.beforeStep(real, run_->world().simulation())) {
    controllersChanged_ = true;
    if (!run_->robots().empty())
      gate_.publishText(run_->robots().front(), "controllers", now(), foxglove::Log::WARNING, text);
  }
}

void SimulationFeed::afterControl(Clock::time_point real) {
  const SimulatedWorld& world = run_->world();
  if (const auto events = world.events(); !events.empty()) {
    external_.noteEvents(events);
    const robotlink::StreamMessage message{robotlink::streams::kEvents, now(),
                                           viewEvents(events, now(), world.simulation().steps())};
    if (recorder_.active()) recorder_.add({message});
    gate_.publish(message);
  }
  if (!external_.isEmpty()) publishInputs(false);
  if (std::exchange(controllersChanged_, false)) publishControllers();
  if (!running_ || real - lastDrawings_ >= kDrawingsPeriod) {
    lastDrawings_ = real;
    publishDrawings();
  }
}

void SimulationFeed::publishInputs(bool newOnly) {
  auto messages = external_.inputs(run_->world().simulation(), now(), Clock::now(), newOnly);
  for (auto& message : messages) gate_.publish(std::move(message));
}

void SimulationFeed::publishControllers() {
  const simcore::Simulation& simulation = run_->world().simulation();
  const robotlink::StreamMessage objects{robotlink::streams::kObjects, now(),
                                         worldObjects(simulation, &external_, now())};
  recorder_.add({objects});
  gate_.publish(objects);
  hadControllers_ |= !external_.isEmpty() || !simulation.controllers().empty();
  if (!hadControllers_) return;
  auto states = std::make_shared<robotcontrol::ControllerStates>();
  robotlink::assign(*states->mutable_timestamp(), now());
  for (const auto& status : simulation.controllers()) assign(*states->add_controllers(), status);
  external_.addStates(*states);
  const robotlink::StreamMessage message{robotlink::streams::kControllers, now(), std::move(states)};
  if (recorder_.active()) recorder_.add({message});
  gate_.publish(message);
}

void SimulationFeed::publishDrawings() {
  if (!demand_.transforms) return;
  for (const auto* output : run_->world().simulation().outputs()) {
    if (output->kind == simcore::ControllerOutput::Kind::kDrawing)
      gate_.publish({output->info.path, now(), drawingMessage(*output, now())});
  }
}

}  // namespace app
