// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "simcore/devices/Ports.h"
#include "simcore/physics/Physics.h"

namespace simcore {

class StateStream;

/// Executes the commands of servos, motors and guided models, and tracks their state. One thread at a
/// time.
class Actuation {
 public:
  /// All arguments must outlive it.
  Actuation(Physics& physics, const Ports& ports);

  /// The command of a servo from a step on, limited to its range; NaN is ignored.
  void command(std::size_t servo, double value, std::uint64_t step);
  void setTorqueShare(std::size_t servo, double share) { servos_[servo].state.torqueShare = share; }
  double torqueShare(std::size_t servo) const { return servos_[servo].state.torqueShare; }
  /// The command of a guide: as many finite values as its port has, which are limited; others are ignored.
  void guide(std::size_t guide, std::span<const double> values);

  /// Has a servo continue as one of another simulation does; its command is limited to its own range. Delayed
  /// commands become due `later` steps later, modulo 2^64, than in the other simulation.
  void takeOver(std::size_t servo, const Actuation& from, std::size_t fromServo, std::uint64_t later);

  /// The same of a guide.
  void takeOverGuide(std::size_t guide, const Actuation& from, std::size_t fromGuide);
  /// Writes or reads what was commanded and how far it was followed.
  void transfer(StateStream& stream);

  /// The random numbers of gaits, if they have noise.
  struct Randomness {
    bool noise = false;
    std::uint64_t seed = 0;
  };
  /// Call this before and after each step of the physics.
  void beforeStep(std::uint64_t step, const Randomness& random);
  void afterStep();

  ActuatorState servoState(std::size_t servo) const;
  ActuatorState guideState(std::size_t guide) const;

 private:
  struct Command {
    std::uint64_t step = 0;
    double value = 0;
  };
  struct ServoMotor {
    ServoState state;
    /// Commands that do not count yet, in the order of their steps.
    std::deque<Command> waiting;
    /// The integral of its error, for a servo with gains.
    double integral = 0;
    bool unobstructed = true;
  };
  struct GuideMotor {
    std::array<double, 6> wanted{};
    /// The command of a vehicle or a following model in this step.
    std::array<double, 6> present{};
    /// Velocities that were reached so far, in the model's frame.
    Vector3 velocity = Vector3::Zero(), rate = Vector3::Zero();
    bool unobstructed = true;
  };
  void transferServo(StateStream& stream, std::size_t index);
  void drive(std::size_t index);
  void drivePosition(const Servo& servo, ServoMotor& motor) const;
  void driveByGains(const Servo& servo, ServoMotor& motor) const;
  /// Turns a hinge by a torque, up to the speed of the motor, N m.
  void exert(const Servo& servo, std::size_t hinge, double torque) const;
  void push(std::size_t index);
  // Moves a guided model by its wheels, or without forces.
  void roll(std::size_t index);
  void follow(std::size_t index, std::uint64_t step, const Randomness& random);
  /// Approaches the command with limited acceleration.
  std::array<double, 6> approached(std::size_t index);
  /// Sets the wheels and steering joints of a vehicle for a command.
  void turnWheels(const GuidedMotion& motion, const GuideMeans& means, const std::array<double, 6>& command);
  /// Computes the target motion of a guide: velocity and turning rate in the model's frame.
  static void wantedMotion(const GuidedMotion& motion, const std::array<double, 6>& wanted, Vector3& velocity,
                           Vector3& rate);

  Physics& physics_;
  const Ports& ports_;
  std::vector<ServoMotor> servos_;
  std::vector<GuideMotor> guides_;
};

}  // namespace simcore
