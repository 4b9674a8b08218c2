// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Hands.h"

#include <algorithm>
#include <numbers>

#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// How fast a model swings at the spring, Hz.
constexpr double kSpringFrequency = 2.5;
/// The part of the stiffness and of the damping at which a body at the spring would begin to oscillate from
/// step to step.
constexpr double kStable = 0.5;
/// Times the weight of the model.
constexpr double kMaxPull = 10;
constexpr double kGravity = 9.81;

}  // namespace

Hands::Hands(Physics& physics, const WorldDescription& world) : physics_(physics) {
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const std::size_t count = physics_.bodiesOf(static_cast<int>(i)).second;
    models_.insert(models_.end(), count, static_cast<int>(i));
  }
}

void Hands::drag(std::size_t body, const Vector3& grip, const Vector3& target, double strength) {
  const auto at = std::ranges::lower_bound(drags_, body, {}, &Drag::body);
  const Drag drag{body, grip, target, strength};
  if (at != drags_.end() && at->body == body) {
    *at = drag;
  } else {
    drags_.insert(at, drag);
  }
}

void Hands::release(std::size_t body) {
  std::erase_if(drags_, [body](const Drag& drag) { return drag.body == body; });
}

void Hands::push(std::size_t body, const Vector3& force, const Vector3& point, std::uint64_t steps) {
  if (pushes_.size() < kMaxPushes && steps > 0) pushes_.push_back({body, force, point, steps});
}

Vector3 Hands::springForce(const Drag& drag, const Vector3& point) const {
  const double mass = physics_.massOf(models_[drag.body]);
  const double movable = physics_.massAt(drag.body, point);
  const double rate = 2 * std::numbers::pi * kSpringFrequency;
  const double stiffness =
      std::min(mass * rate * rate * drag.strength, kStable * movable / (kStepSeconds * kStepSeconds));
  const double damping = std::min(2 * std::sqrt(stiffness * mass), kStable * movable / kStepSeconds);
  Vector3 force = stiffness * (drag.target - point) - damping * physics_.velocityAt(drag.body, point);
  const double limit = kMaxPull * kGravity * mass * drag.strength;
  if (force.norm() > limit) force *= limit / force.norm();
  return force;
}

void Hands::beforeStep() {
  forces_.clear();
  for (const Drag& drag : drags_) {
    const Vector3 point = physics_.linkInWorld(drag.body) * drag.grip;
    forces_.push_back({true, drag.body, point, drag.target, springForce(drag, point)});
  }
  for (Push& push : pushes_) {
    const Vector3 point = physics_.linkInWorld(push.body) * push.point;
    forces_.push_back({false, push.body, point, Vector3::Zero(), push.force});
    --push.steps;
  }
  std::erase_if(pushes_, [](const Push& push) { return push.steps == 0; });
  for (const Force& force : forces_) physics_.addForce(force.body, force.force, force.point);
}

void Hands::transfer(StateStream& stream) {
  const auto body = [&](std::size_t& index) {
    auto number = static_cast<std::uint64_t>(index);
    stream.raw(number);
    if (number >= models_.size() || !physics_.isMovedByForces(models_[number])) return stream.fail();
    index = physics_.carrierOf(number);
  };
  stream.size(drags_, models_.size());
  for (Drag& drag : drags_) {
    body(drag.body);
    stream.vector(drag.grip);
    stream.vector(drag.target);
    stream.within(drag.strength, 0, 1000);
  }
  if (!std::ranges::is_sorted(drags_, {}, &Drag::body)) stream.fail();
  stream.size(pushes_, kMaxPushes);
  for (Push& push : pushes_) {
    body(push.body);
    stream.vector(push.force);
    stream.vector(push.point);
    stream.raw(push.steps);
    if (push.steps == 0) stream.fail();
  }
  if (!stream.isReading()) return;
  forces_.clear();
  if (stream.good()) return;
  drags_.clear();
  pushes_.clear();
}

std::vector<std::size_t> Hands::dragged() const {
  std::vector<std::size_t> bodies;
  for (const Drag& drag : drags_) bodies.push_back(drag.body);
  return bodies;
}

}  // namespace simcore
