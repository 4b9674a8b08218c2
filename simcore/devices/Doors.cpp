// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Doors.h"

#include <cmath>

#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

// Contact sensors read 0 or 1, with errors something between.
constexpr double kTouched = 0.5;

bool notices(const Door& door, double reading) {
  return door.sensor.isContact ? reading >= kTouched : reading < door.description.below;
}

}  // namespace

Doors::Doors(const Ports& ports, Actuation& actuation)
    : ports_(ports), actuation_(actuation), states_(ports.doors.size()) {
  for (std::size_t i = 0; i < states_.size(); ++i) move(i, false, 0);
}

void Doors::afterStep(std::uint64_t step, const Reading& reading) {
  if (step % kLookSteps != 0) return;
  for (std::size_t i = 0; i < states_.size(); ++i) {
    const Door& door = ports_.doors[i];
    const bool noticed = door.sensor.kind != DoorSensor::Kind::kNone && notices(door, reading(door));
    if (noticed) command(i, true, step);
    if (!noticed && states_[i].open && step >= states_[i].closesAt) move(i, false, step);
  }
}

void Doors::transfer(StateStream& stream) {
  for (State& state : states_) {
    stream.flag(state.open);
    stream.raw(state.closesAt);
  }
}

void Doors::command(std::size_t door, bool open, std::uint64_t step) {
  const double seconds = ports_.doors[door].description.seconds;
  states_[door].closesAt = step + static_cast<std::uint64_t>(std::ceil(seconds / kStepSeconds - 1e-6));
  if (open != states_[door].open) move(door, open, step);
}

void Doors::move(std::size_t door, bool open, std::uint64_t step) {
  states_[door].open = open;
  const DoorDescription& of = ports_.doors[door].description;
  actuation_.command(ports_.doors[door].servo, open ? of.open : of.closed, step);
}

}  // namespace simcore
