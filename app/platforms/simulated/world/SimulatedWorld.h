// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/platforms/simulated/world/CameraWork.h"
#include "app/platforms/simulated/world/HeldActuators.h"
#include "app/platforms/simulated/world/SimulatedPioneer.h"
#include "app/platforms/simulated/world/control/PortCommands.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "simcore/Simulation.h"
#include "simcore/world/LightAdjustment.h"
#include "simcore/world/ViewEvent.h"

namespace app {

/// The part of a simulation that the platforms of all its robots share: the physics, its clock, the rendering
/// of its cameras, and the microcontrollers of its Pioneers.
///
/// It moves in steps of kStep, each of two steps of the physics. One thread at a time; the clock may be read
/// by any.
class SimulatedWorld {
 public:
  /// The period of sensors and actuators.
  static constexpr robotlink::Duration kStep = 2 * simcore::Simulation::kStep;

  /// Settings of a world.
  struct Options {
    std::uint64_t seed = 1;
    /// Whether sensors and odometry have errors.
    bool noise = true;
    bool shadows = true;
    /// Whether all images are black.
    bool blackout = false;
    simcore::LightAdjustment lighting = {};
    /// The vignetting of all cameras, instead of their own.
    std::optional<simcore::LensVignetting> vignetting = {};
    /// Standard deviation of the noise of all images, in gray values, instead of the cameras' own. Ignored if
    /// `noise` is off.
    std::optional<double> imageNoise = {};
    /// Whether robots on wheels are moved by their odometry instead of by forces.
    bool kinematic = false;
    /// The number of bytes of its past that are kept, so that it can be rewound; 0: it cannot.
    std::size_t rewindBytes = 0;
    /// How many threads share the work: physics, measurements, images, and in SimulatedRun the programs. The
    /// results are the same for any number.
    int threads = 1;
    /// Settings of all Pioneers. Their seed is that of the world; without `noise` they have no tire errors.
    SimulatedPioneer::Options pioneers = {};
  };
  /// The work of the world since the last reset, and the real time that it took.
  struct Costs {
    /// Steps of the physics.
    std::uint64_t steps = 0;
    std::uint64_t images = 0;
    robotlink::Duration physics{};
    robotlink::Duration rendering{};
    /// The microcontrollers, including their measurements.
    robotlink::Duration pioneers{};
  };

  /// Fails if the simulation or a microcontroller cannot be made.
  static robotlink::Result<std::unique_ptr<SimulatedWorld>> create(
      std::shared_ptr<const simcore::Scene> scene, Options options);

  /// Advances physics, clock and microcontrollers by kStep.
  void advance();
  /// Puts everything back to the start, with another seed. The clock starts at 0 again; the lighting stays.
  void reset(std::uint64_t seed);

  /// See simcore::Simulation::continueIn(). What was set for cameras is kept by their paths. Microcontrollers
  /// keep running, unless their robots have other sensors; those of removed robots exist until forgetGone().
  robotlink::Result<simcore::SceneChange> continueIn(std::shared_ptr<const simcore::Scene> scene,
                                                     const simcore::Continuation& how = {});
  /// Takes back the last continueIn(), before the next step and before forgetGone().
  void goBack();
  /// Destroys the microcontrollers of removed robots, which no platform may still use.
  void forgetGone() { gone_.clear(); }

  /// Keeps everything of the world that changes: the simulation, what is held, light, cameras, the digest.
  simcore::Snapshot snapshot() const;
  /// The digest() at that instant; 0 if the snapshot does not say it.
  static std::uint64_t digestOf(const simcore::Snapshot& snapshot);
  /// Goes back (or on) to a snapshot. Its clock continues, and so do microcontrollers with their odometry:
  /// readers of a clock must not see it jump. From before the first step, the clock is that of the
  /// snapshot. Fails, changing nothing, if the snapshot is of another scene or is not possible. Returns the
  /// models that an edited scene has where its file puts them.
  robotlink::Result<std::vector<std::string>> restore(const simcore::Snapshot& snapshot);
  /// The time by which it can go back.
  robotlink::Duration rewindable() const;
  /// Goes back in the simulation by at least a step of kStep, to the nearest one, as restore() does; digest()
  /// continues. Fails, changing nothing, if that is too long ago.
  robotlink::Result<void> rewind(robotlink::Duration back);

  const robotlink::Clock& clock() const { return clock_; }
  simcore::Simulation& simulation() { return *simulation_; }
  const simcore::Simulation& simulation() const { return *simulation_; }
  const Options& options() const { return options_; }
  const Costs& costs() const { return costs_; }
  /// The threads that share the work. Not null.
  const std::shared_ptr<robotlink::ThreadPool>& pool() const { return pool_; }

  /// The microcontrollers of all robots whose drive names SimulatedPioneer::kController, in the order of the
  /// scene.
  std::span<const std::unique_ptr<SimulatedPioneer>> pioneers() const { return pioneers_; }
  /// The actuators that a person holds; a reset forgets them.
  HeldActuators& held() { return held_; }

  /// Sets the commands of remote controllers in each step; null: there are none. They must outlive this
  /// object, or the next call.
  void setCommands(PortCommands* commands) { commands_ = commands; }
  /// The events of views that entered in the last advance().
  std::span<const simcore::ViewEvent> events() const { return events_; }

  /// Returns null if the robot has none.
  SimulatedPioneer* pioneer(const std::string& robot) const;

  /// Whether a camera (by its index) takes an image at this step.
  bool imageDue(std::size_t camera) const { return imageDue(camera, simulation_->steps()); }
  /// Renders the image of a camera, YCbCr 4:2:2. Valid until the next call. With several threads, images that
  /// are due now of other cameras that were requested when their previous one was due are made meanwhile.
  const robotlink::Image& render(std::size_t camera);
  /// Renders what a camera sees for a person, as render() does; costs() and digest() do not count it. Valid
  /// until the next call of either.
  const robotlink::Image& preview(std::size_t camera);
  /// The true classes of the image that was rendered last; see TrueClasses. Valid until the next call.
  const robotlink::Image& trueClasses();

  /// Changes the light from the next image on; a reset does not change it back. Fails if a value is out of
  /// range.
  robotlink::Result<void> setLighting(const simcore::LightAdjustment& lighting);

  /// Replaces the errors of a sensor, by the path of its port, from now on and after a reset, even if the
  /// world has no noise. Fails if there is no such sensor or a number is out of range.
  robotlink::Result<void> setSensorErrors(const std::string& path, const simcore::SensorErrors& errors);

  /// The settings of a camera that its owner can change. They stay after a reset.
  struct CameraSetting {
    /// Factors of the scene's light; the gain amplifies the noise, too.
    double exposure = 1, gain = 1;
    /// LightAdjustment::whiteBalance.
    double whiteBalance = 0;
  };
  /// The setting of a camera, by its index; changes count from the next image on.
  CameraSetting& cameraSetting(std::size_t camera) {
    cameraWork_.forgetImages();
    return cameraSettings_[camera];
  }

  /// The number of images that were begun while the simulation continued; see CameraWork.
  std::uint64_t imagesBegunAhead() const { return cameraWork_.begunAhead(); }

  /// A hash of the states after all steps and of all images since the start, for comparing runs.
  std::uint64_t digest() const { return digest_; }

 private:
  SimulatedWorld(std::unique_ptr<simcore::Simulation> simulation, Options options,
                 std::shared_ptr<robotlink::ThreadPool> pool);
  /// The light as a camera sees it by its settings.
  simcore::LightAdjustment lightingOf(std::size_t camera) const;
  /// Returns the properties that an image of a camera must have now.
  CameraWork::Order orderOf(std::size_t camera) const;
  bool imageDue(std::size_t camera, std::uint64_t step) const;
  CameraWork::Orders orders() const;
  CameraWork::IsDue dues() const;
  /// Makes the microcontrollers, or continues with those that there are.
  robotlink::Result<void> makePioneers();
  /// Settings of a microcontroller.
  SimulatedPioneer::Options pioneerOptions(const std::string& robot) const;
  /// Keeps what was set for cameras, and finds it again in another scene.
  void keepCameras();
  void findCameras();
  void mixIntoDigest(std::uint64_t value);
  /// Discards what was measured or rendered of the world before a jump; the clock continues.
  void settleAfterJump();
  struct Kept;
  /// The settings of a camera.
  struct KeptCamera {
    CameraSetting setting;
    bool errorsChosen = false;
  };
  /// Restores what the simulation does not; `of`: the scene of the snapshot, if it is known.
  void restoreKept(const Kept& kept, const simcore::Scene* of);

  Options options_;
  std::shared_ptr<robotlink::ThreadPool> pool_;
  robotlink::ManualClock clock_;
  /// The clock minus the time of the simulation, which was put back.
  robotlink::Duration clockAhead_{};
  std::unique_ptr<simcore::Simulation> simulation_;
  std::vector<std::unique_ptr<SimulatedPioneer>> pioneers_;
  /// The microcontrollers of robots that were removed.
  std::vector<std::unique_ptr<SimulatedPioneer>> gone_;
  HeldActuators held_;
  CameraWork cameraWork_;
  PortCommands* commands_ = nullptr;
  std::vector<simcore::ViewEvent> events_;
  std::vector<CameraSetting> cameraSettings_;
  /// Keyed by path, also of cameras that are gone, whose robots may come back.
  std::map<std::string, KeptCamera> keptCameras_;
  /// Keyed by camera: whether its errors were chosen, instead of those of the scene.
  std::vector<bool> cameraErrorsChosen_;
  std::uint64_t digest_ = 0;
  Costs costs_;
};

}  // namespace app
