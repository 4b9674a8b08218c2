// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/platforms/simulated/world/control/PortCommands.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"
#include "simcore/world/PortInfo.h"
#include "simcore/world/ViewEvent.h"

namespace robotcontrol {
class AttachController;
class ControllerInputs;
class ControllerStates;
class SetPorts;
}  // namespace robotcontrol
namespace simcore {
class Simulation;
}

namespace app {

/// Controllers of a simulation that are remote programs, at the far end of a link: they get the readings
/// of the sensors that they named, and the events of views, and command actuators. A step waits for those in
/// lockstep, but not longer than their patience: a late one is named, its actuators are released, and it is
/// not waited for until it answers again.
///
/// Never waits itself: the caller asks until when a step has to wait. One thread at a time.
class ExternalControllers {
 public:
  using RealTime = std::chrono::steady_clock::time_point;
  static constexpr std::size_t kMaxControllers = 20, kMaxValues = 10'000;
  static constexpr double kUsualPatience = 1;  ///< s

  /// Something that a controller shows, as a sensor.
  struct Output {
    /// Its path begins with the controller's name.
    simcore::PortInfo info;
    std::vector<double> values;
  };

  /// Fails, changing nothing, if a sensor is unknown, a name is impossible, or there are too many.
  robotlink::Result<void> attach(const robotcontrol::AttachController& request,
                                 simcore::Simulation& simulation);
  /// Fails if the controller is not attached or names what there is not; what precedes that is done. Also an
  /// answer that fails is one: the step does not wait for another.
  robotlink::Result<void> set(const robotcontrol::SetPorts& request, const simcore::Simulation& simulation);
  /// The simulation starts over: commands and answers are those of the past.
  void restart();

  bool isEmpty() const { return all_.empty(); }
  bool anyIsLate() const;
  std::vector<std::string> names() const;
  /// For SimulatedWorld::setCommands().
  PortCommands& commands() { return commands_; }
  /// The time until which the next step has to wait for answers; unset if for none.
  std::optional<RealTime> waitsUntil() const;
  /// Call this before each step: gives up those who are late. Returns a sentence for each of them.
  std::vector<std::string> beforeStep(RealTime now, simcore::Simulation& simulation);
  /// Call this after each step, with the events that entered at it.
  void noteEvents(std::span<const simcore::ViewEvent> events);
  /// The inputs for the step that comes, on the streams of those for whom they are due, and before them the
  /// images of cameras that they named, each on a stream of its own (STREAM/CAMERA). Those in lockstep are
  /// waited for from then on. `newOnly`: only of those that were attached, or started over, since the last
  /// call.
  std::vector<robotlink::StreamMessage> inputs(const simcore::Simulation& simulation, robotlink::Instant time,
                                               RealTime now, bool newOnly);

  std::vector<const Output*> outputs() const;
  void addStates(robotcontrol::ControllerStates& to) const;

 private:
  struct Attached {
    std::vector<std::string> sensors;
    std::vector<Output> outputs;
    bool lockstep = false;
    std::chrono::duration<double> patience{kUsualPatience};
    std::uint64_t every = 1;
    /// Steps until its next inputs.
    std::uint64_t left = 0;
    /// The step that it has to answer; unset if it owes nothing.
    std::optional<std::uint64_t> owes;
    RealTime deadline{};
    /// The controller missed its deadline and has not answered since.
    bool isLate = false;
    std::uint64_t late = 0;
    std::vector<simcore::ViewEvent> events;
  };
  static robotlink::Result<Attached> read(const robotcontrol::AttachController& request,
                                          const simcore::Simulation& simulation);

  PortCommands commands_;
  std::map<std::string, Attached> all_;
};

}  // namespace app
