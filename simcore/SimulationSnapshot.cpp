// SPDX-License-Identifier: GPL-3.0-or-later
// Simulation: keeping its state, and going back to it.
#include <bit>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/Simulation.h"
#include "simcore/SimulationState.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// Half a year; a simulation that has run longer cannot be restored from a file.
constexpr std::uint64_t kMaxSteps = std::uint64_t{1} << 32U;

/// Steps of a simulation that has run without end.
constexpr std::uint64_t kMaxTouches = std::uint64_t{1} << 40U;

/// Computes a number from many.
class Fingerprint {
 public:
  void add(std::uint64_t bits) { hash_ = robotlink::mixBits(hash_ ^ bits); }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(const std::string& text) { add(hashOfPath(text)); }
  void add(const Vector3& vector) {
    for (int i = 0; i < 3; ++i) add(vector[i]);
  }
  void add(const Pose3& pose) {
    for (int i = 0; i < 16; ++i) add(pose.matrix().data()[i]);
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0;
};

void hashLink(Fingerprint& print, const LinkDescription& link) {
  print.add(link.name);
  print.add(link.poseInModel);
  print.add(link.mass);
  print.add(link.centerOfMass);
  for (int i = 0; i < 9; ++i) print.add(link.inertia.data()[i]);
  for (const CollisionDescription& solid : link.collisions) {
    print.add(static_cast<std::uint64_t>(solid.shape.kind));
    print.add(solid.poseInLink);
    print.add(solid.shape.size);
    print.add(solid.shape.radius);
    print.add(solid.shape.length);
    print.add(solid.friction);
  }
}

void hashJoint(Fingerprint& print, const JointDescription& joint) {
  print.add(joint.name);
  print.add(static_cast<std::uint64_t>(joint.kind));
  print.add(static_cast<std::uint64_t>(joint.child));
  print.add(joint.anchorInModel);
  print.add(joint.axisInModel);
  print.add(joint.maximumTorque);
}

/// A value of a command; 0 if the command has fewer.
double valueOf(const Rewind::Command& command, std::size_t i) {
  return i < command.values.size() ? command.values[i] : 0;
}

Vector3 vectorOf(const Rewind::Command& command, std::size_t i) {
  return {valueOf(command, i), valueOf(command, i + 1), valueOf(command, i + 2)};
}

void repeatPlacing(Simulation& simulation, const Rewind::Command& command) {
  const auto at = [&](std::size_t i) { return valueOf(command, i); };
  std::optional<ModelPosture> posture;
  if (command.index > 0) posture.emplace(ModelPosture{std::nullopt, at(4), at(5)});
  if (command.index > 1) posture->height = at(3);
  // A pose that did not fit then does not fit now.
  (void)simulation.placeModel(command.text, {at(0), at(1), at(2)}, posture);
}

void repeatErrors(Simulation& simulation, const Rewind::Command& command) {
  const std::vector<double>& v = command.values;
  SensorErrors errors{{}, valueOf(command, 0), valueOf(command, 1), valueOf(command, 2)};
  for (std::size_t i = 3; i + 7 <= v.size(); i += 7)
    errors.noise.push_back({v[i], v[i + 1], v[i + 2], v[i + 3], v[i + 4], v[i + 5], v[i + 6]});
  (void)simulation.setSensorErrors(command.text, errors);
}

void repeatEvent(Simulation& simulation, const Rewind::Command& command) {
  const std::size_t end = command.text.find('\n');
  ViewEvent event{
      static_cast<ViewEvent::Kind>(command.index), command.text.substr(0, end), command.text.substr(end + 1),
      static_cast<int>(valueOf(command, 6)),       vectorOf(command, 0),        vectorOf(command, 3)};
  (void)simulation.addEvent(std::move(event));
}

/// Gives a simulation the command that it had before.
void repeat(Simulation& simulation, const Rewind::Command& command) {
  const auto at = [&](std::size_t i) { return valueOf(command, i); };
  const auto vector = [&](std::size_t i) { return vectorOf(command, i); };
  switch (command.kind) {
    case CommandKind::kAngle:
      return simulation.requestAngle(command.index, at(0));
    case CommandKind::kTorqueLimit:
      return simulation.setTorqueLimit(command.index, at(0));
    case CommandKind::kWheelSpeeds:
      return simulation.requestWheelSpeeds(command.index, at(0), at(1));
    case CommandKind::kDriveOn:
      return simulation.setDriveOn(command.index, at(0) != 0);
    case CommandKind::kGuide:
      return simulation.guide(command.index, command.values);
    case CommandKind::kDoor:
      return simulation.moveDoor(command.index, at(0) != 0);
    case CommandKind::kPlace:
      return repeatPlacing(simulation, command);
    case CommandKind::kErrors:
      return repeatErrors(simulation, command);
    case CommandKind::kTurn:
      (void)simulation.turnModel(command.text, at(0), at(1), at(2));
      return;
    case CommandKind::kThrow:
      (void)simulation.throwModel(command.text, vector(0), vector(3));
      return;
    case CommandKind::kPin:
      (void)simulation.pin(command.text, at(0) != 0);
      return;
    case CommandKind::kDrag:
      (void)simulation.drag(command.text, vector(0), vector(3), at(6));
      return;
    case CommandKind::kRelease:
      return simulation.release(command.text);
    case CommandKind::kPush:
      (void)simulation.push(command.text, vector(0), vector(3), at(6));
      return;
    case CommandKind::kEvent:
      return repeatEvent(simulation, command);
  }
}

}  // namespace

void TouchCount::transfer(StateStream& stream) {
  for (std::uint64_t* count : {&stepsSince_, &count_, &steps_}) stream.upTo(*count, kMaxTouches);
}

std::uint64_t SimulationState::fingerprint() const {
  if (knownFingerprint) return *knownFingerprint;
  Fingerprint print;
  print.add(static_cast<std::uint64_t>(options.kinematic));
  print.add(world.gravity);
  print.add(static_cast<std::uint64_t>(world.sleeps));
  for (const ModelInstance& model : world.models) {
    print.add(model.name);
    print.add(model.poseInWorld);
    print.add(static_cast<std::uint64_t>(model.type->isStatic));
    for (const LinkDescription& link : model.type->links) hashLink(print, link);
    for (const JointDescription& joint : model.type->joints) hashJoint(print, joint);
  }
  for (const Port& port : allPorts) print.add(port.info.path);
  knownFingerprint = print.hash();
  return *knownFingerprint;
}

void SimulationState::transferTiming(StateStream& stream) {
  for (auto* sensors : {&rangeTiming, &imageTiming, &cameraTiming}) {
    for (TimedSensor& sensor : *sensors) {
      transferErrors(stream, sensor.errors);
      stream.flag(sensor.chosen);
      if (stream.isReading()) sensor.set(SensorErrors(sensor.errors));
    }
  }
  for (CameraSensor& camera : ports.cameras) stream.within(camera.noise, 0, 1e9);
  std::vector<std::uint32_t> chosen;
  for (const auto& [sensor, errors] : chosenErrors) chosen.push_back(static_cast<std::uint32_t>(sensor));
  stream.size(chosen, ports.sensors.size());
  std::map<std::size_t, SensorErrors> read;
  for (std::uint32_t sensor : chosen) {
    stream.raw(sensor);
    SensorErrors errors = stream.isReading() ? SensorErrors{} : chosenErrors[sensor];
    transferErrors(stream, errors);
    if (sensor >= ports.sensors.size()) return stream.fail();
    if (stream.isReading()) read[sensor] = std::move(errors);
  }
  if (stream.isReading()) chosenErrors = std::move(read);
}

void SimulationState::transfer(StateStream& stream) {
  stream.raw(options.seed);
  stream.flag(options.noise);
  stream.upTo(steps, kMaxSteps);
  if (!stream.good()) return;
  physics->transfer(stream);
  actuation->transfer(stream);
  doors->transfer(stream);
  hands->transfer(stream);
  sensing->transfer(stream, noise());
  transferTiming(stream);
  history.transfer(stream, steps, poses.size());
  if (ranging) ranging->transfer(stream, noise());
  if (imaging) imaging->transfer(stream, noise());
  stream.bits(driveUnobstructed);
  stream.raw(ballContacts);
  stream.bits(touchedBall);
  for (TouchCount& touches : obstacles) touches.transfer(stream);
  transferControl(stream);
  if (!stream.isReading()) return;
  readWheels();
  invalidate();
}

std::uint64_t Simulation::fingerprint() const {
  return implementation_->fingerprint();
}

Snapshot Simulation::snapshot() const {
  Snapshot snapshot;
  snapshot.scene = scene().file().string();
  snapshot.of = implementation_->scene;
  snapshot.fingerprint = implementation_->fingerprint();
  snapshot.step = implementation_->steps;
  StateStream stream(snapshot.state);
  implementation_->transfer(stream);
  return snapshot;
}

void Simulation::takeOverAdded(const Implementation& present) {
  Implementation& i = *implementation_;
  const auto isAdded = [&](const std::string& model) {
    return before_->modelIndex(model) < 0 && i.modelIndex(model) >= 0;
  };
  std::vector<int> added;
  for (std::size_t m = 0; m < i.world.models.size(); ++m) {
    const ModelInstance& model = i.world.models[m];
    if (isAdded(model.name) && !model.type->isStatic) added.push_back(static_cast<int>(m));
  }
  i.takeOverPorts(present, added);
  for (const int model : added) i.sensing->adoptVelocitiesOf(model);
  i.readWheels();
  i.invalidate();
  for (const auto& [path, errors] : present.errorsByPath()) {
    if (isAdded(port(path)->info.robot)) static_cast<void>(setSensorErrors(path, errors));
  }
}

robotlink::Result<std::vector<std::string>> Simulation::restoreInEdited(const Snapshot& snapshot) {
  auto present =
      std::exchange(implementation_, std::make_unique<Implementation>(snapshot.of, implementation_->options));
  auto before = std::move(before_);
  startControllers();
  // Models added since then continue as they are.
  Continuation how{.otherPorts = true};
  for (std::size_t i = 0; i < present->world.models.size(); ++i) {
    const ModelInstance& model = present->world.models[i];
    if (!model.type->isStatic)
      how.motions[model.name] = std::make_shared<const ModelMotion>(
          ModelMotion{model, present->physics->motionOf(static_cast<int>(i))});
  }
  auto restored = restore(snapshot);
  robotlink::Result<SceneChange> gone;
  if (restored) gone = continueIn(present->scene, how);
  if (restored && gone) takeOverAdded(*present);
  before_ = std::move(before);
  if (!restored || !gone) {
    implementation_ = std::move(present);
    return tl::unexpected(restored ? gone.error() : restored.error());
  }
  implementation_->rewind = std::move(present->rewind);
  implementation_->clearRewind();
  readForces(present->readsForces);
  return std::move(gone->putBack);
}

robotlink::Result<std::vector<std::string>> Simulation::restore(const Snapshot& snapshot) {
  Implementation& i = *implementation_;
  const bool isEdited = snapshot.of && snapshot.of != i.scene && snapshot.of->file() == i.scene->file();
  if (isEdited && snapshot.fingerprint != i.fingerprint()) return restoreInEdited(snapshot);
  if (snapshot.fingerprint != i.fingerprint()) {
    const std::string own = scene().file().string();
    return robotlink::failure(
        "snapshot.scene",
        snapshot.scene == own
            ? "the snapshot is of " + own +
                  " with other models, or with models that are moved otherwise, than it has now; open the "
                  "scene "
                  "as it was when the snapshot was taken, and save an edited scene before a snapshot of it "
                  "becomes a file"
            : "the snapshot is of another scene, " + snapshot.scene + "; the one that runs is " + own,
        {}, {snapshot.scene, own});
  }
  std::vector<std::uint8_t> before;
  StateStream keep(before);
  i.transfer(keep);
  StateStream stream(snapshot.state,
                     snapshot.isForeign ? StateStream::Trust::kForeign : StateStream::Trust::kOwn);
  i.transfer(stream);
  const bool isRead = stream.complete() && i.steps == snapshot.step;
  if (!isRead) {
    StateStream back(before, StateStream::Trust::kOwn);
    i.transfer(back);
    resumeControllers();
    return robotlink::failure("snapshot.damaged",
                              "the snapshot of " + snapshot.scene + " has an impossible state", {},
                              {snapshot.scene});
  }
  resumeControllers();
  i.clearRewind();
  return std::vector<std::string>();
}

void SimulationState::keepForRewind() {
  if (!rewind || isRepeating || !rewind->isDue(steps)) return;
  std::vector<std::uint8_t> state;
  StateStream stream(state);
  transfer(stream);
  rewind->add(steps, std::move(state));
}

void SimulationState::clearRewind() {
  if (!rewind) return;
  rewind->clear();
  keepForRewind();
}

void Simulation::keepForRewind(std::size_t maxBytes) {
  implementation_->rewind = maxBytes > 0 ? std::make_unique<Rewind>(maxBytes) : nullptr;
  implementation_->keepForRewind();
}

std::uint64_t Simulation::rewindableFrom() const {
  const Implementation& i = *implementation_;
  return i.rewind ? i.rewind->oldest().value_or(i.steps) : i.steps;
}

robotlink::Result<void> Simulation::rewindTo(std::uint64_t step) {
  Implementation& i = *implementation_;
  if (step > i.steps || step < rewindableFrom() || !i.rewind || !i.rewind->oldest()) {
    return robotlink::failure(
        "simulation.rewind",
        "the simulation can go back to " +
            std::to_string(robotlink::seconds(kStep * static_cast<std::int64_t>(rewindableFrom()))) +
            " s at most");
  }
  const std::uint64_t from = i.rewind->stateBefore(step);
  StateStream stream(i.rewind->stateAt(from), StateStream::Trust::kOwn);
  i.transfer(stream);
  resumeControllers();
  i.isRepeating = true;
  const auto again = [this](const Rewind::Command& command) { repeat(*this, command); };
  if (step == from) i.rewind->replay(from, from, [](const Rewind::Command&) {});
  while (i.steps < step) {
    i.rewind->replay(from, i.steps, again);
    this->step();
  }
  i.isRepeating = false;
  i.rewind->forgetAfter(step);
  return {};
}

}  // namespace simcore
