// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation: controllers, and events of users in views.
#include <bit>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"
#include "simcore/control/ScenePicking.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// Events that may wait for one step.
constexpr std::size_t kMaxEvents = 1000;
/// Texts of events are names.
constexpr std::size_t kMaxEventText = 100;
/// More than any scene has.
constexpr std::size_t kMaxControllers = 10'000;

/// The access of controllers to a simulation.
class SimulationAccess final : public ControlledWorld {
 public:
  SimulationAccess(Simulation& simulation, SimulationState& state) : simulation_(simulation), state_(state) {}

  std::uint64_t step() const override { return state_.steps; }
  double time() const override { return static_cast<double>(state_.steps) * kStepSeconds; }
  std::uint64_t seed() const override { return state_.options.seed; }
  std::span<const Port> ports() const override { return simulation_.ports(); }
  const Port* port(const std::string& path) const override { return simulation_.port(path); }
  robotlink::Result<std::vector<double>> read(const std::string& path) override {
    const Port* found = simulation_.port(path);
    // Reading one sensor is cheaper than reading all of them, and gives the same values.
    if (found != nullptr && found->kind == Port::Kind::kSensor && !state_.readingsValid) {
      Sensor& sensor = state_.ports.sensors[found->index];
      state_.sensing->read(state_.noise(), found->index, sensor);
      return sensor.values;
    }
    return simulation_.read(path);
  }
  robotlink::Result<const robotlink::Image*> image(const std::string& camera) override {
    const Port* found = simulation_.port(camera);
    if (found == nullptr || found->kind != Port::Kind::kCamera)
      return robotlink::failure("simulation.port", "there is no color camera '" + camera + "'", {}, {camera});
    return &simulation_.cameraImage(found->index);
  }
  robotlink::Result<void> write(const std::string& path, std::span<const double> values) override {
    return simulation_.write(path, values);
  }
  std::optional<Pose3> modelPose(const std::string& model) const override {
    return simulation_.modelPose(model);
  }
  robotlink::Result<void> place(const std::string& model, const robotlink::Pose2& pose,
                                std::optional<double> height) override {
    if (!height) return simulation_.placeModel(model, pose);
    return simulation_.placeModel(model, pose, ModelPosture{.height = height});
  }
  std::span<const ViewEvent> events() const override { return state_.control.events; }

 private:
  Simulation& simulation_;
  SimulationState& state_;
};

std::string problemOfEvent(const ViewEvent& event) {
  if (event.view.size() > kMaxEventText || event.key.size() > kMaxEventText)
    return "the name of a view or a key is too long";
  if (!event.isOfMouse()) return event.key.empty() ? "an event of the keyboard needs a key" : "";
  if (event.button < 0 || event.button > 10)
    return "there is no mouse button " + std::to_string(event.button);
  const bool isRay = event.origin.allFinite() && event.direction.allFinite() &&
                     event.direction.norm() > 1e-9 && event.origin.norm() < 1e6;
  return isRay ? "" : "an event of the mouse needs a ray: an origin, and a direction that is not 0";
}

std::uint64_t hashOfEvent(const ViewEvent& event) {
  std::uint64_t hash = static_cast<std::uint64_t>(event.kind) + 1;
  const auto mix = [&hash](std::uint64_t value) { hash = robotlink::mixBits(hash ^ value); };
  for (const std::string* text : {&event.view, &event.key, &event.object})
    for (const char c : *text) mix(static_cast<std::uint8_t>(c));
  mix(static_cast<std::uint64_t>(event.button));
  for (const auto* vector : {&event.origin, &event.direction, &event.point})
    for (int k = 0; k < 3; ++k) mix(std::bit_cast<std::uint64_t>((*vector)[k]));
  return hash;
}

void transferShape(StateStream& stream, DrawnShape& shape) {
  stream.choice(shape.kind, DrawnShape::Kind::kText);
  stream.size(shape.points, ControllerOutput::kMaxPoints);
  for (Vector3& point : shape.points) stream.vector(point);
  stream.vector(shape.size);
  for (std::uint8_t* channel : {&shape.color.r, &shape.color.g, &shape.color.b}) stream.raw(*channel);
  stream.text(shape.text);
}

/// Transfers the contents of an output; its description belongs to the scene.
void transferOutput(StateStream& stream, ControllerOutput& output) {
  for (double& value : output.values) stream.raw(value);
  std::string bytes(output.image.data.begin(), output.image.data.end());
  stream.text(bytes);
  stream.size(output.shapes, ControllerOutput::kMaxShapes);
  for (DrawnShape& shape : output.shapes) transferShape(stream, shape);
  if (!stream.isReading()) return;
  if (bytes.size() != output.image.data.size()) return stream.fail();
  output.image.data.assign(bytes.begin(), bytes.end());
  stream.require(output.problem().empty());
}

}  // namespace

void SimulationState::addOutputPorts() {
  const auto outputs = control.controllers->outputs();
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!portsByPath.emplace(outputs[i]->info.path, allPorts.size()).second) continue;
    allPorts.push_back({outputs[i]->info, Port::Kind::kOutput, i});
  }
}

void SimulationState::pick(ViewEvent& event) {
  event.object.clear();
  event.model.clear();
  event.point.setZero();
  if (!event.isOfMouse()) return;
  event.direction.normalize();
  if (!posesValid) updatePoses();
  const RenderScene& drawn = *scene->contents().renderScene;
  const auto picked = pickInstance(drawn, poses, event.origin, event.direction);
  if (!picked) return;
  event.object = drawn.instances[picked->instance].name;
  event.model = event.object.substr(0, event.object.find('/'));
  event.point = event.origin + picked->distance * event.direction;
}

robotlink::Result<std::vector<double>> SimulationState::readOutput(std::size_t index) const {
  const ControllerOutput& output = *control.controllers->outputs()[index];
  if (output.kind == ControllerOutput::Kind::kDrawing)
    return robotlink::failure("simulation.port",
                              "'" + output.info.path + "' is a drawing, which has no values", {},
                              {output.info.path});
  if (output.kind == ControllerOutput::Kind::kValues) return output.values;
  return std::vector<double>(output.image.data.begin(), output.image.data.end());
}

void SimulationState::takeOverControl(const SimulationState& before) {
  control.controllers->adopt(*before.control.controllers);
  control.digest = before.control.digest;
  control.waiting = before.control.waiting;
}

void Simulation::startControllers() {
  Implementation& i = *implementation_;
  const bool isFirst = !i.control.controllers;
  if (isFirst) i.control.controllers = std::make_unique<Controllers>(i.world);
  i.control.restart();
  SimulationAccess access(*this, i);
  i.control.controllers->start(access);
  if (isFirst) i.addOutputPorts();
}

void Simulation::control() {
  Implementation& i = *implementation_;
  if (i.control.isDone) return;
  i.control.isDone = true;
  i.control.events = std::move(i.control.waiting);
  i.control.waiting.clear();
  for (ViewEvent& event : i.control.events) {
    i.pick(event);
    i.control.digest =
        robotlink::mixBits(i.control.digest ^ robotlink::mixBits(i.steps) ^ hashOfEvent(event));
  }
  if (i.control.controllers->isEmpty()) return;
  SimulationAccess access(*this, i);
  i.control.isRunning = true;
  i.control.controllers->step(access);
  i.control.isRunning = false;
}

void SimulationState::transferControl(StateStream& stream) {
  stream.raw(control.digest);
  stream.flag(control.isDone);
  // The set of outputs is fixed; only their contents are written.
  Controllers::Memory memory = control.controllers->memory();
  stream.size(memory.states, kMaxControllers);
  for (std::string& state : memory.states) stream.text(state);
  for (ControllerOutput& output : memory.shown) transferOutput(stream, output);
  for (auto& [why, step] : memory.troubles) {
    stream.text(why);
    stream.raw(step);
  }
  if (stream.isReading()) control.restored = std::move(memory);
}

void Simulation::resumeControllers() {
  ControlState& control = implementation_->control;
  const std::uint64_t digest = control.digest;
  const bool isDone = control.isDone;
  // New controllers, since an old one may remember more of another time than its state.
  startControllers();
  control.controllers->restore(control.restored, implementation_->steps);
  control.restored = {};
  control.digest = digest;
  control.isDone = isDone;
}

robotlink::Result<void> Simulation::addEvent(ViewEvent event) {
  if (const std::string wrong = problemOfEvent(event); !wrong.empty())
    return robotlink::failure("simulation.event", wrong);
  auto& waiting = implementation_->control.waiting;
  if (waiting.size() >= kMaxEvents)
    return robotlink::failure(
        "simulation.event",
        "1000 events are already waiting for the next step; step or start the simulation");
  const auto& origin = event.origin;
  const auto& direction = event.direction;
  implementation_->note(CommandKind::kEvent, static_cast<std::size_t>(event.kind),
                        {origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z(),
                         static_cast<double>(event.button)},
                        event.view + '\n' + event.key);
  waiting.push_back(std::move(event));
  return {};
}

std::span<const ViewEvent> Simulation::events() const {
  return implementation_->control.events;
}

std::span<const ControllerStatus> Simulation::controllers() const {
  return implementation_->control.controllers->status();
}

std::span<const ControllerOutput* const> Simulation::outputs() const {
  return implementation_->control.controllers->outputs();
}

}  // namespace simcore
