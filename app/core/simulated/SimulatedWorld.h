// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/core/simulated/HeldActuators.h"
#include "app/core/simulated/SimulatedPioneer.h"
#include "app/core/simulated/TrueClasses.h"
#include "app/core/simulated/control/PortCommands.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraOptics.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/world/LightAdjustment.h"
#include "simcore/world/ViewEvent.h"

namespace app {

/// What the platforms of all robots of a simulation share: the simulation, its clock, the rendering of its
/// cameras, and the microcontrollers of its Pioneers.
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
    /// Settings of all Pioneers. Their seed is that of the world; without `noise` they have no tire errors.
    SimulatedPioneer::Options pioneers = {};
  };
  /// What the world has done since the last reset, and the real time that it took.
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

  /// See simcore::Simulation::continueIn().
  robotlink::Result<simcore::SceneChange> continueIn(std::shared_ptr<const simcore::Scene> scene);
  /// Goes on where another world is, before the first step; see simcore::Simulation::continueFrom().
  /// Microcontrollers begin anew.
  std::vector<std::string> continueFrom(const SimulatedWorld& before);

  const robotlink::Clock& clock() const { return clock_; }
  simcore::Simulation& simulation() { return *simulation_; }
  const simcore::Simulation& simulation() const { return *simulation_; }
  const Options& options() const { return options_; }
  const Costs& costs() const { return costs_; }

  /// The microcontrollers of all robots whose drive names SimulatedPioneer::kController, in the order of the
  /// scene.
  std::span<const std::unique_ptr<SimulatedPioneer>> pioneers() const { return pioneers_; }
  /// The actuators that a person holds; a reset forgets them.
  HeldActuators& held() { return held_; }

  /// What controllers elsewhere command in each step; null: there are none. It must outlive this object, or
  /// the next call.
  void setCommands(PortCommands* commands) { commands_ = commands; }
  /// The events of views that entered in the last advance().
  std::span<const simcore::ViewEvent> events() const { return events_; }

  /// Returns null if the robot has none.
  SimulatedPioneer* pioneer(const std::string& robot) const;

  /// Whether a camera (by its index) takes an image at this step.
  bool imageDue(std::size_t camera) const;
  /// Renders the image of a camera, YCbCr 4:2:2. Valid until the next call.
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

  /// What the owner of a camera can change. It stays after a reset.
  struct CameraSetting {
    /// Factors of the scene's light; the gain amplifies the noise, too.
    double exposure = 1, gain = 1;
    /// LightAdjustment::whiteBalance.
    double whiteBalance = 0;
  };
  /// The setting of a camera, by its index; changes count from the next image on.
  CameraSetting& cameraSetting(std::size_t camera) { return cameraSettings_[camera]; }

  /// A hash of the states after all steps and of all images since the start, for comparing runs.
  std::uint64_t digest() const { return digest_; }

 private:
  SimulatedWorld(std::unique_ptr<simcore::Simulation> simulation, Options options);
  /// The light as a camera sees it by its settings.
  simcore::LightAdjustment lightingOf(std::size_t camera) const;
  /// Takes the image of a camera into image_.
  void take(std::size_t camera, const simcore::CameraModel& model, const simcore::ImageNoise& noise);
  /// Makes what renders the scene, if there are cameras.
  void makeRenderer();
  /// Makes the microcontrollers.
  robotlink::Result<void> makePioneers();
  /// Renders a camera's image into image_.
  void draw(std::size_t camera);
  void mixIntoDigest(std::uint64_t value);

  Options options_;
  robotlink::ManualClock clock_;
  std::unique_ptr<simcore::Simulation> simulation_;
  std::vector<std::unique_ptr<SimulatedPioneer>> pioneers_;
  HeldActuators held_;
  PortCommands* commands_ = nullptr;
  std::vector<simcore::ViewEvent> events_;
  /// Null if there are no cameras.
  std::unique_ptr<simcore::CameraRenderer> renderer_;
  std::vector<CameraSetting> cameraSettings_;
  /// Keyed by camera: whether somebody chose its errors, instead of the scene.
  std::vector<bool> cameraErrorsChosen_;
  /// Keyed by camera.
  std::vector<simcore::CameraOptics> optics_;
  /// Whose image was rendered last.
  std::size_t lastCamera_ = 0;
  TrueClasses trueClasses_;
  /// The memory of render() and trueClasses().
  robotlink::Image image_, classes_;
  /// The step of the physics whose poses the renderer has.
  std::uint64_t posesRendered_ = ~std::uint64_t{0};
  std::uint64_t digest_ = 0;
  Costs costs_;
};

}  // namespace app
