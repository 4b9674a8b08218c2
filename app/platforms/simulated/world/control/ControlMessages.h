// SPDX-License-Identifier: GPL-3.0-or-later
// Messages about the controllers of a simulation, what they show, and what people do in views.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "robotlink/base/Clock.h"

namespace foxglove {
class SceneUpdate;
}
namespace robotcontrol {
class ControllerState;
class PortReading;
class ViewEvent;
class ViewEvents;
}  // namespace robotcontrol
namespace simcore {
struct ControllerOutput;
struct ControllerStatus;
struct ViewEvent;
class Simulation;
}  // namespace simcore

namespace app {

/// An event of a request; what the simulation finds out itself stays empty.
simcore::ViewEvent viewEvent(const robotcontrol::ViewEvent& from);
void assign(robotcontrol::ViewEvent& to, const simcore::ViewEvent& from);
/// The events that have entered at a step.
std::shared_ptr<const robotcontrol::ViewEvents> viewEvents(std::span<const simcore::ViewEvent> events,
                                                           robotlink::Instant time, std::uint64_t step);
void assign(robotcontrol::ControllerState& to, const simcore::ControllerStatus& from);

/// Returns the reading at a path: numbers of a port, or the truth of a sensor (Simulation::portOfTruth()).
/// Unset if there is no such thing.
std::optional<robotcontrol::PortReading> readingOf(const simcore::Simulation& simulation,
                                                   const std::string& path);

/// A drawing as one entity, whose id is the path of its port, in the world's frame.
std::shared_ptr<const foxglove::SceneUpdate> drawingMessage(const simcore::ControllerOutput& output,
                                                            robotlink::Instant time);

}  // namespace app
