// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/core/simulated/SimulatedPioneer.h"
#include "app/core/simulated/TrueClasses.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraRenderer.h"
#include "simcore/world/Lighting.h"

namespace app {

/// A simulation with a clock, with cameras that render, and with the microcontrollers of its robots on
/// wheels: what the platforms of all simulated robots share.
///
/// Moves in steps of kStep, two of the physics. One thread at a time; the clock may be read by any.
class SimulatedWorld {
 public:
  static constexpr robotlink::Duration kStep = 2 * simcore::Simulation::kStep;

  struct Options {
    std::uint64_t seed = 1;
    bool noise = true;
    bool shadows = true;
    bool blackout = false;  ///< all images are black
    simcore::Lighting lighting = {};
    std::optional<simcore::LensVignetting> vignetting = {};  ///< of all cameras, instead of their own
    std::optional<double> imageNoise =
        {};                  ///< standard deviation, gray values; likewise, unless `noise` is off
    bool kinematic = false;  ///< robots on wheels are moved by their odometry instead of by forces
    SimulatedPioneer::Options pioneers = {};  ///< of all of them; seed and odometry's errors are the world's
  };
  /// What it did and what that cost, in real time.
  struct Costs {
    std::uint64_t steps = 0;  ///< of the physics
    std::uint64_t images = 0;
    robotlink::Duration physics{};
    robotlink::Duration rendering{};
    robotlink::Duration pioneers{};  ///< microcontrollers and what they measure
  };

  static robotlink::Result<std::unique_ptr<SimulatedWorld>> create(
      std::shared_ptr<const simcore::Scene> scene, Options options);

  void advance();
  /// Back to the start, with another seed; the clock starts at 0 again.
  void reset(std::uint64_t seed);

  const robotlink::Clock& clock() const { return clock_; }
  simcore::Simulation& simulation() { return *simulation_; }
  const simcore::Simulation& simulation() const { return *simulation_; }
  const Options& options() const { return options_; }
  const Costs& costs() const { return costs_; }

  /// Those of all robots whose drive has such a microcontroller, in the order of the scene.
  std::span<const std::unique_ptr<SimulatedPioneer>> pioneers() const { return pioneers_; }
  /// Null if that robot has none.
  SimulatedPioneer* pioneer(const std::string& robot) const;

  /// Whether a camera takes an image at this step.
  bool imageDue(std::size_t camera) const;
  /// That image, YCbCr 4:2:2; valid until the next call.
  const robotlink::Image& render(std::size_t camera);
  /// What the image that was rendered last truly shows: TrueClasses. Valid until the next call.
  const robotlink::Image& trueClasses();

  /// From the next image on; stays when the world is reset. Fails where a value is out of its range.
  robotlink::Result<void> setLighting(const simcore::Lighting& lighting);

  /// A hash over the states after all steps and over all images since the start.
  std::uint64_t digest() const { return digest_; }

 private:
  SimulatedWorld(std::unique_ptr<simcore::Simulation> simulation, Options options);
  robotlink::Result<void> makePioneers();
  void mixIntoDigest(std::uint64_t value);

  Options options_;
  robotlink::ManualClock clock_;
  std::unique_ptr<simcore::Simulation> simulation_;
  std::vector<std::unique_ptr<SimulatedPioneer>> pioneers_;
  std::unique_ptr<simcore::CameraRenderer> renderer_;  ///< null: there are no cameras
  TrueClasses trueClasses_;
  robotlink::Image image_, classes_;
  std::uint64_t posesRendered_ = ~std::uint64_t{0};  ///< the physics step whose poses the renderer has
  std::uint64_t digest_ = 0;
  Costs costs_;
};

}  // namespace app
