// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"
#include "simcore/Snapshot.h"
#include "simcore/world/ComingImage.h"
#include "simcore/world/Continuation.h"
#include "simcore/world/Devices.h"
#include "simcore/world/Forces.h"
#include "simcore/world/ImageSensor.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Port.h"
#include "simcore/world/RangeSensor.h"
#include "simcore/world/RenderScene.h"
#include "simcore/world/SimulationOptions.h"

namespace simcore {

class Scene;
struct ControllerOutput;
struct ControllerStatus;
struct SimulationState;
struct ViewEvent;

/// How a placed model is tilted: turned by roll about x, then by pitch about y, then by the heading about z;
/// rad.
struct ModelPosture {
  /// The height of the model's frame in the world, m; unset: as it is.
  std::optional<double> height = {};
  double roll = 0, pitch = 0;
};

/// The result of continuing a running simulation in another scene.
struct SceneChange {
  /// Whether it has the same sensors, cameras, servos and drives as before, in the same order, so that their
  /// indices stay valid. If not, nothing was changed, unless Continuation::otherPorts.
  bool hasSamePorts = false;
  /// The models of both scenes that have other sensors, cameras, servos or drives than before.
  std::vector<std::string> changedPorts = {};
  /// Models that were in the scene before and stand at the places that the new scene gives them: they have
  /// other links or joints, or another place in its file, or would stand inside something.
  std::vector<std::string> putBack = {};
};

/// A running simulation of a world: bodies, joints, contacts, sensors and servos, in steps of kStep. SI
/// units; poses are in the world's frame.
///
/// Deterministic: on one machine, the same scene, options and requests give the same bytes. Each simulation
/// may be used by one thread at a time; several simulations may run in several threads. It does not know
/// about robot programs.
class Simulation {
 public:
  /// The duration of a step.
  static constexpr robotlink::Duration kStep = std::chrono::milliseconds(4);

  /// Fails if a robot or a ball starts inside another model; other models may (see overlaps()).
  static robotlink::Result<std::unique_ptr<Simulation>> create(std::shared_ptr<const Scene> scene,
                                                               SimulationOptions options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Advances by one step: controllers, servos and drives first, then physics, then contact counters.
  void step();
  /// Calls the controllers of the scene for the next step, which step() does otherwise: commands that
  /// are given after it override theirs.
  void control();
  /// Adds an event of a view to the next step, which determines what its ray hits; controllers get it.
  /// Events are part of digest(). Fails if it is invalid, or if too many wait.
  robotlink::Result<void> addEvent(ViewEvent event);
  /// The events that entered at the last step, or at the one that comes after control(); valid until the next
  /// call of a non-const function.
  std::span<const ViewEvent> events() const;
  /// The status of the controllers: those of the world first, then those of its models, in their order.
  std::span<const ControllerStatus> controllers() const;
  /// The views that controllers add, in the order of their ports; valid until the next reset.
  std::span<const ControllerOutput* const> outputs() const;

  /// Steps since the start or the last reset.
  std::uint64_t steps() const;
  /// Simulated time since then.
  robotlink::Duration time() const;
  /// Returns to the initial state of the scene, with a new seed.
  void reset(std::uint64_t seed);

  /// Continues in another scene, usually the same file after an edit. Time and step go on. Models of the same
  /// name that move, have the same links and joints, and have the same place in both scenes keep their poses,
  /// joint angles and velocities, and their servos and drives keep their commands; all others are at
  /// the start of the new scene. Fails as create() does, and then nothing has changed.
  robotlink::Result<SceneChange> continueIn(std::shared_ptr<const Scene> scene, const Continuation& how = {});
  /// Takes back the last continueIn(), as if it had never been. Only before the next step() or reset();
  /// otherwise it does nothing.
  void goBack();
  /// Goes on where another simulation is, in the same way, whatever ports that has. Returns
  /// SceneChange::putBack. Call this before the first step.
  std::vector<std::string> continueFrom(const Simulation& before);

  const Scene& scene() const;
  std::shared_ptr<const Scene> sharedScene() const;
  std::shared_ptr<const RenderScene> renderScene() const;
  /// The poses of the bodies of renderScene(), by body index; valid until the next call of a non-const
  /// function.
  std::span<const Pose3> bodyPoses() const;
  /// Changes whenever these poses may have changed, also within a step.
  std::uint64_t posesVersion() const;

  /// The sensors with their readings of the last step. They are computed on demand, once a step.
  std::span<const Sensor> sensors() const;
  /// The cameras; images are made by a CameraRenderer.
  std::span<const CameraSensor> cameras() const;
  std::span<const RangeSensor> rangeSensors() const;
  /// Measures the present ranges of a range sensor, m; `ranges` has as many elements as the sensor has
  /// readings. Computed on demand; repeated calls within a step, in any order of sensors, give the same
  /// values.
  void measure(std::size_t rangeSensor, std::span<double> ranges) const;
  /// The sensors of depth, classes, facettes and radiation, addressed by their index.
  std::span<const ImageSensor> imageSensors() const;
  /// Measures the present image of an image sensor; `values` has ImageSensor::values() elements. Computed on
  /// demand, and the same whenever and however often it is called within a step.
  void measureImage(std::size_t imageSensor, std::span<float> values) const;
  /// Sets `poses` to those of all bodies, by index, as a camera sees them: `age` seconds before the instant
  /// of its present image, which its delay puts into the past. Ages beyond its exposure and readout are
  /// limited to what is remembered.
  void cameraPoses(std::size_t camera, double age, std::vector<Pose3>& poses) const;
  /// Predicts a camera's image that is requested at step `at`, if nothing but going back to another instant
  /// or choosing other errors of the camera can change it. Unset if anything else can, which is always so
  /// without a delay.
  std::optional<ComingImage> comingImage(std::size_t camera, std::uint64_t at) const;
  /// Renders the present image of a color camera, kYuyv, in the light of the scene, unless setCameraImages()
  /// provides the images; valid until the next call.
  const robotlink::Image& cameraImage(std::size_t camera) const;
  /// Makes the present image of a color camera; null where it cannot. It is valid until the next one.
  using CameraImages = std::function<const robotlink::Image*(std::size_t camera)>;
  /// Has the images that cameraImage() yields, and so those that controllers read, be made by the caller, who
  /// knows of other light and of settings of cameras. Unset: no longer.
  void setCameraImages(CameraImages images) { cameraImages_ = std::move(images); }
  /// The step of the present image of a camera, which its delay puts into the past.
  std::uint64_t cameraStep(std::size_t camera) const;
  /// Returns the best possible percepts of a camera's present image: the models of which it shows a pixel.
  std::vector<TruePercept> truePercepts(std::size_t camera) const;

  /// The errors of a sensor, camera, range or image sensor by its path ("red1/accelerometer"); null if there
  /// is none.
  const SensorErrors* sensorErrors(const std::string& path) const;
  /// The same as far as they count: none where noise is off, unless they were replaced.
  SensorErrors errorsInUse(const std::string& path) const;
  /// Replaces them from now on, even where noise is off; a reset keeps them. Of cameras the timing and the
  /// standard deviation count. Fails, changing nothing, if there is no such sensor or a value is out of
  /// range.
  robotlink::Result<void> setSensorErrors(const std::string& path, const SensorErrors& errors);

  /// The sensor whose readings without errors a path names ("red1/psd/true"), or the camera whose true
  /// percepts it names; null if it names none.
  const Port* portOfTruth(const std::string& path) const;
  /// All that can be read or commanded, by path; constant. Truth is what the oracle knows: for each model its
  /// pose (MODEL/true_pose) and its velocity (MODEL/true_velocity).
  std::span<const Port> ports() const;
  /// The paths of all that can be read: of the ports, and of the truth about each sensor (portOfTruth()).
  std::vector<std::string> readablePaths() const;
  /// Null if there is none.
  const Port* port(const std::string& path) const;
  /// The present values of a port in the order of its shape; of an actuator its last command is not known
  /// here, so it yields {reached, unobstructed} of ActuatorState, 0 or 1. Images of cameras are not read so.
  /// Fails if there is no such port.
  robotlink::Result<std::vector<double>> read(const std::string& path) const;
  /// Returns the reading of a sensor without any errors and delay. Fails if there is no such sensor.
  robotlink::Result<std::vector<double>> readTruth(const std::string& path) const;
  /// Commands an actuator: as many finite values as it has. Fails if there is no such actuator.
  robotlink::Result<void> write(const std::string& path, std::span<const double> values);

  /// The servos, addressed by their index.
  std::span<const Servo> servos() const;
  /// Return the state of the last command.
  ActuatorState servoState(std::size_t servo) const;
  ActuatorState guideState(std::size_t guide) const;
  ActuatorState driveState(std::size_t drive) const;
  /// The models that move as they are commanded, addressed by their index.
  std::span<const Guide> guides() const;
  /// Commands a guided model: as many finite values as its port has; others are ignored.
  void guide(std::size_t guide, std::span<const double> values);
  /// The doors, addressed by their index.
  std::span<const Door> doors() const;
  /// Opens a door for its time, or closes it at once; if its sensor still detects something, it opens again.
  void moveDoor(std::size_t door, bool open);
  /// Whether it opens or is open.
  bool isDoorOpen(std::size_t door) const;
  /// Commands a servo: the target angle, rad, or the speed or torque of a motor
  /// (Servo::control); clamped to its range. NaN is ignored.
  void requestAngle(std::size_t servo, double angle);
  /// Sets the fraction of its maximum torque that a servo may use, 0 to 1.
  void setTorqueLimit(std::size_t servo, double share);

  /// The torque that a servo exerted in the last step, N m, in the direction of its angle.
  double servoTorque(std::size_t servo) const;

  /// The drives, addressed by their index.
  std::span<const WheelDrive> drives() const;
  const WheelState& wheelState(std::size_t drive) const;
  /// Sets the speeds of a drive's rims from the next step on, m/s; clamped to its maximum. Acceleration
  /// limits are left to the caller. NaN is ignored.
  void requestWheelSpeeds(std::size_t drive, double left, double right);
  /// Switches the power of a drive's motors, initially on. Without power the wheels coast against the
  /// friction of their gears.
  void setDriveOn(std::size_t drive, bool on);

  /// The true pose of a model ("red1", "ball") in the world; empty if there is none. A robot's frame is at
  /// the center of its body, x to the front.
  std::optional<Pose3> modelPose(const std::string& model) const;
  /// Moves a model to a pose on the ground and brings it to rest, with the same joint angles; without a
  /// posture also with the same height and tilt. Fails, changing nothing, if the model is unknown or static,
  /// or does not fit there.
  robotlink::Result<void> placeModel(const std::string& model, const robotlink::Pose2& pose,
                                     const std::optional<ModelPosture>& posture = {});

  // Manipulate models by hand while they move. A path is that of a model ("ball") or of a link
  // ("red1/link:body"); a model means its first link. Vectors are in the world, SI units. Each fails,
  // changing nothing, if there is no such object, or if it is static, or follows its odometry where forces do
  // not move it.

  /// Turns a model by roll about x, then pitch about y, then heading about z, about its origin and the axes
  /// of the world; rad. It is at rest then. Fails if it does not fit there.
  robotlink::Result<void> turnModel(const std::string& model, double heading, double roll, double pitch);
  /// Sets a model in motion as a whole: the velocity of its center of mass, and its turning rate.
  robotlink::Result<void> throwModel(const std::string& model, const robotlink::Vector3& velocity,
                                     const robotlink::Vector3& spin);
  /// Holds a link where it is, whatever pushes it, or lets it go.
  robotlink::Result<void> pin(const std::string& path, bool on);
  /// The paths of all links that are held.
  std::vector<std::string> pinned() const;
  /// Pulls a link by a spring from the point `grip`, in the frame of the link, to the point `target`, until
  /// it is released. A strength of 1 is usual, see Hands.
  robotlink::Result<void> drag(const std::string& path, const robotlink::Vector3& grip,
                               const robotlink::Vector3& target, double strength = 1);
  /// Releases a link, or with an empty path all; does nothing if it is not dragged.
  void release(const std::string& path);
  /// The paths of all links that are dragged.
  std::vector<std::string> dragged() const;
  /// Pushes a link with a force at the point `point`, in the frame of the link, for some simulated seconds, 0
  /// to 60; at least for one step.
  robotlink::Result<void> push(const std::string& path, const robotlink::Vector3& force,
                               const robotlink::Vector3& point, double seconds);

  /// Whether the forces of contacts are measured from the next step on; at first they are not. That changes
  /// nothing else.
  void readForces(bool on);
  /// The forces of the last step; without contacts unless they are measured.
  Forces forces() const;

  /// Keeps everything that changes while it runs. It takes some ten microseconds.
  Snapshot snapshot() const;
  /// Snapshot::fingerprint of this simulation.
  std::uint64_t fingerprint() const;
  /// Goes back (or on) to a snapshot, of this simulation or another one of the same scene: from then on
  /// everything is as it was then, to the last bit. Whether forces are read stays. Fails, changing nothing,
  /// if it is of another scene, or is not possible. If the scene was edited since then, what it still has is
  /// restored, as by continueIn(); returns the models that are where its file has them instead.
  robotlink::Result<std::vector<std::string>> restore(const Snapshot& snapshot);
  /// Keeps a snapshot for each simulated second and all commands from now on, in at most `maxBytes`, of which
  /// the oldest are given up. 0 bytes: no longer.
  void keepForRewind(std::size_t maxBytes);
  /// The first step to which one can go back; steps() if one cannot.
  std::uint64_t rewindableFrom() const;
  /// Goes back to an earlier step, exactly: from the last snapshot before it, everything is computed again
  /// with the same commands. Costs up to 250 steps. What followed is forgotten. Fails, changing nothing,
  /// if that step is not kept.
  robotlink::Result<void> rewindTo(std::uint64_t step);
  /// How a model stands and moves now, for Continuation::motions; null if there is none or it is static.
  std::shared_ptr<const ModelMotion> motionOf(const std::string& model) const;

  /// The models that start inside others by more than 3 mm.
  const LeftOuts& overlaps() const;
  /// The names of the models that a moving model touches at its present pose; costs a search. Empty if the
  /// model is unknown or static.
  std::vector<std::string> modelsTouching(const std::string& model) const;

  /// The links of a model that touched anything but a floor and a ball in the last step, by their names, each
  /// once.
  std::vector<std::string> linksAtObstacles(const std::string& model) const;
  /// How far a model that forces move is above what is below it (the floor, a table, a ramp) while it touches
  /// nothing, m; 0 while it does, and of any other model.
  double heightInAir(const std::string& model) const;

  /// How often robots began to touch a ball.
  std::uint64_t ballContacts() const;

  /// How often a robot began to touch anything but the floor (contacts less than 0.1 s apart count as one),
  /// and for how long in total.
  std::uint64_t obstacleContacts(const std::string& robot) const;
  robotlink::Duration obstacleContactTime(const std::string& robot) const;

  /// A hash of all poses and velocities, events, and outputs of controllers, for tests of determinism.
  std::uint64_t digest() const;

 private:
  Simulation();
  using Implementation = SimulationState;
  /// Makes the controllers again.
  void startControllers();
  /// restore() of a snapshot of the scene as it was before it was edited.
  robotlink::Result<std::vector<std::string>> restoreInEdited(const Snapshot& snapshot);
  /// Has models that the scene of before_ did not have go on with the commands, and the errors of sensors
  /// that somebody chose, that they have in `present`.
  void takeOverAdded(const Implementation& present);
  /// Has new controllers go on by what those of a snapshot remembered.
  void resumeControllers();

  std::unique_ptr<Implementation> implementation_;
  /// The state to which goBack() returns; null: none.
  std::unique_ptr<Implementation> before_;
  CameraImages cameraImages_;
};

}  // namespace simcore
