// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "simcore/CameraRenderer.h"
#include "simcore/PortInfo.h"
#include "simcore/RangeSensor.h"
#include "simcore/RenderScene.h"

namespace simcore {

class Scene;

/// A sensor that yields numbers. Its reading is that of the last step, noise included.
struct Sensor {
  PortInfo info;
  std::vector<double> values;
};

struct CameraSensor {
  PortInfo info;
  CameraModel model;
  int body = 0;  ///< index in RenderScene::bodies
  Pose3 cameraInBody = Pose3::Identity();
  robotlink::Duration period{};  ///< between images
  double noise =
      0;  ///< standard deviation of each channel, grey values; to be applied only if options ask for noise
};

/// A joint's servo: it turns towards a requested angle with limited speed and torque.
struct Servo {
  PortInfo info;                    ///< "red1/legFL1/request"
  double minimum = 0, maximum = 0;  ///< rad
  double maximumSpeed = 0;          ///< rad/s
  double maximumTorque = 0;         ///< N m
};

/// Driven wheels on a robot's two sides ("skid steering"). A side's wheels are told one speed.
struct WheelDrive {
  PortInfo info;            ///< "p3at1/drive": the speeds of the left and the right rims, {2}, m/s
  std::string controller;   ///< the protocol of its microcontroller ("arcos"); empty: it has none
  double wheelRadius = 0;   ///< m
  double track = 0;         ///< m; while nothing is in the way, the robot turns by (right - left) / track
  double maximumSpeed = 0;  ///< m/s, of the rims
};

/// What a drive's encoders and motors tell. Travel is that of the rims, mean of a side's wheels, since the
/// simulation began; it never wraps, and goes on while wheels slip.
struct WheelState {
  double leftTravel = 0, rightTravel = 0;  ///< m
  double leftSpeed = 0, rightSpeed = 0;    ///< m/s
  /// The motors do what they can, yet the wheels hardly turn, for a tenth of a second at least.
  bool leftBlocked = false, rightBlocked = false;
};

struct SimulationOptions {
  std::uint64_t seed = 1;
  bool noise = true;
  /// Models with a drive are moved by their odometry, and stop before what is in the way, instead of by
  /// forces.
  bool kinematic = false;
};

/// A world in motion: bodies, joints, contacts, sensors and servos, in steps of Simulation::kStep.
///
/// Deterministic: scene, seed and the servos' requests give the same bytes on one machine. One thread at a
/// time may use a simulation; several simulations may run on several threads. Knows no robot program.
class Simulation {
 public:
  static constexpr robotlink::Duration kStep = std::chrono::milliseconds(4);

  static robotlink::Result<std::unique_ptr<Simulation>> create(std::shared_ptr<const Scene> scene,
                                                               SimulationOptions options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  void step();
  std::uint64_t steps() const;
  robotlink::Duration time() const;
  /// Back to the scene's first poses, with a new seed.
  void reset(std::uint64_t seed);

  const Scene& scene() const;
  std::shared_ptr<const RenderScene> renderScene() const;
  /// Where each body of renderScene() is, by body index; valid until the next call to a non-const function.
  std::span<const Pose3> bodyPoses() const;

  std::span<const Sensor> sensors() const;
  std::span<const CameraSensor> cameras() const;
  std::span<const RangeSensor> rangeSensors() const;
  /// Writes what a range sensor measures now, m, into a span of as many as its readings. It costs something
  /// only when it is called. The same within a step however often, and whether others are asked for or not.
  void measure(std::size_t rangeSensor, std::span<double> ranges) const;
  std::span<const Servo> servos() const;
  /// An angle for a servo; limited to its range.
  void requestAngle(std::size_t servo, double angle);
  /// Share of the maximum torque that a servo may use, 0 to 1.
  void setTorqueLimit(std::size_t servo, double share);

  std::span<const WheelDrive> drives() const;
  const WheelState& wheelState(std::size_t drive) const;
  /// Speeds of a drive's rims, m/s, limited to what it can, from the next step on. How fast they may change
  /// is up to whoever asks.
  void requestWheelSpeeds(std::size_t drive, double left, double right);
  /// Motors without power roll out against their gears' friction. They are on at first.
  void setDriveOn(std::size_t drive, bool on);

  /// True pose of a model ("red1", "ball") in the world. A robot's frame lies at its body's centre, x to the
  /// front.
  std::optional<Pose3> modelPose(const std::string& model) const;
  /// Puts a model somewhere, at rest, keeping its height and its joints; refuses a place where it would not
  /// fit.
  robotlink::Result<void> placeModel(const std::string& model, const robotlink::Pose2& pose);

  /// How often a robot and the ball began to touch.
  std::uint64_t ballContacts() const;
  std::uint64_t ballContacts(const std::string& robot) const;

  /// How often a robot began to touch anything but the floor, and for how long it did altogether.
  std::uint64_t obstacleContacts(const std::string& robot) const;
  robotlink::Duration obstacleContactTime(const std::string& robot) const;

  /// A hash over all poses and velocities.
  std::uint64_t digest() const;

 private:
  Simulation();
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
