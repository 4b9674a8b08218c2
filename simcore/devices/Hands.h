// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "simcore/physics/Physics.h"

namespace simcore {

class StateStream;

/// The forces that a user applies to bodies by hand: springs that drag them to a point, and pushes. A
/// spring is as strong as it takes to move the body's model with about 2.5 Hz, critically damped, and never
/// stronger than the step of the physics allows. Bodies are numbered as those of Physics. One thread at a
/// time.
class Hands {
 public:
  /// No more pushes act at the same time; further ones are ignored.
  static constexpr std::size_t kMaxPushes = 1000;

  /// Both must outlive it.
  Hands(Physics& physics, const WorldDescription& world);

  /// Drags the point `grip` of a body, in the frame of its link, to `target`, in the world, until it is
  /// released. `strength` multiplies the spring. Replaces another spring at the body.
  void drag(std::size_t body, const Vector3& grip, const Vector3& target, double strength);
  void release(std::size_t body);
  void releaseAll() { drags_.clear(); }
  /// Pushes a body with a force in the world at a point in the frame of its link, for some steps.
  void push(std::size_t body, const Vector3& force, const Vector3& point, std::uint64_t steps);

  /// Call this before each step of the physics.
  void beforeStep();
  /// Writes or reads all forces.
  void transfer(StateStream& stream);

  /// A force of the last step, in the world; `target` only of a spring.
  struct Force {
    bool isDrag = false;
    std::size_t body = 0;
    Vector3 point, target, force;
  };
  const std::vector<Force>& forces() const { return forces_; }
  /// The bodies that are dragged, in ascending order.
  std::vector<std::size_t> dragged() const;

 private:
  struct Drag {
    std::size_t body = 0;
    Vector3 grip = Vector3::Zero(), target = Vector3::Zero();
    double strength = 1;
  };
  struct Push {
    std::size_t body = 0;
    Vector3 force = Vector3::Zero(), point = Vector3::Zero();
    std::uint64_t steps = 0;
  };
  Vector3 springForce(const Drag& drag, const Vector3& point) const;

  Physics& physics_;
  /// Keyed by body: its model.
  std::vector<int> models_;
  /// Sorted by body.
  std::vector<Drag> drags_;
  std::vector<Push> pushes_;
  std::vector<Force> forces_;
};

}  // namespace simcore
