// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"
#include "simcore/control/ControllerOutput.h"
#include "simcore/world/Port.h"
#include "simcore/world/ViewEvent.h"

namespace simcore {

/// A controller's interface to the world that it controls: its ports by their paths, its models, and the
/// events of users in views. SI units, the world's frame. Only to be used during Controller::step() and the
/// constructor.
class ControlledWorld {
 public:
  virtual ~ControlledWorld() = default;

  /// Steps, and seconds, since the start or the last reset.
  virtual std::uint64_t step() const = 0;
  virtual double time() const = 0;
  /// The seed of the simulation: random numbers must be computed from it, and from counters.
  virtual std::uint64_t seed() const = 0;

  virtual std::span<const Port> ports() const = 0;
  /// Null if there is none.
  virtual const Port* port(const std::string& path) const = 0;
  /// The values of a port, in the order of its shape, with the sensor's errors; the images of color cameras
  /// are read by image(). Fails if there is no such port.
  virtual robotlink::Result<std::vector<double>> read(const std::string& path) = 0;
  /// The present image of a color camera, kYuyv, as its robot gets it: with noise, delay, lens and shutter.
  /// It is rendered when it is asked for, and valid until the next one. Fails if there is no such camera.
  virtual robotlink::Result<const robotlink::Image*> image(const std::string& camera) = 0;
  /// Commands an actuator; counts from the step that follows. The program of a robot commands before it, a
  /// person who holds the actuator after it. Fails if there is none, or with another number of values.
  virtual robotlink::Result<void> write(const std::string& path, std::span<const double> values) = 0;

  /// Unset if there is no such model.
  virtual std::optional<robotlink::Pose3> modelPose(const std::string& model) const = 0;
  /// Puts a model at a place on the ground, at rest; with a height, upright there. Fails, changing nothing,
  /// if it is unknown, static, or does not fit.
  virtual robotlink::Result<void> place(const std::string& model, const robotlink::Pose2& pose,
                                        std::optional<double> height) = 0;

  /// The events of users since the previous step, in their order.
  virtual std::span<const ViewEvent> events() const = 0;

  /// The first value of a port. Throws std::runtime_error if it cannot be read, which switches a controller
  /// off.
  double number(const std::string& path);
  /// Commands an actuator, and throws if that is refused.
  void command(const std::string& path, std::initializer_list<double> values);
};

/// Controls a scene, a model, or all of it: called before each step, it reads sensors, sets actuators, reacts
/// to keys and mouse, and shows what it likes by its outputs.
///
/// All controllers of a simulation are called in its thread, one after the other, in the order of the scene.
/// They must be deterministic: the same seed, readings and events give the same commands. An exception
/// switches a controller off; it is reported, and the simulation continues. A reset makes a new one.
class Controller {
 public:
  Controller() = default;
  virtual ~Controller() = default;
  Controller(const Controller&) = delete;
  Controller& operator=(const Controller&) = delete;

  virtual void step(ControlledWorld& world) = 0;

  /// Returns the state to keep when a simulation continues in another scene or in a snapshot: any bytes,
  /// which restore() gets in another object of the same kind and parameters. The bytes may be those of an
  /// older program.
  virtual std::string state() const { return {}; }
  virtual void restore(std::string_view /*state*/) {}
};

}  // namespace simcore
