// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/WorldChanges.h"

#include <algorithm>
#include <optional>

#include "app/platforms/simulated/world/SimulatedWorld.h"
#include "app/platforms/simulated/world/WorldPorts.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/packages/Conversions.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"

namespace app {
namespace {

using robotcontrol::Request;
using robotlink::Result;
using robotlink::Vector3;

template <typename Message>
Vector3 vectorOf(const Message& message) {
  return {message.x(), message.y(), message.z()};
}

Result<void> placeModel(SimulatedWorld& world, const Request& request) {
  const auto& place = request.place_model();
  std::optional<simcore::ModelPosture> posture;
  if (place.height() != 0 || place.roll() != 0 || place.pitch() != 0) {
    posture.emplace();
    if (place.height() != 0) posture->height = place.height();
    posture->roll = place.roll();
    posture->pitch = place.pitch();
  }
  return world.simulation().placeModel(place.model(), robotlink::pose2(place.pose_in_field()), posture);
}

Result<void> turnModel(SimulatedWorld& world, const Request& request) {
  const auto& turn = request.turn_model();
  return world.simulation().turnModel(turn.model(), turn.heading(), turn.roll(), turn.pitch());
}

Result<void> throwModel(SimulatedWorld& world, const Request& request) {
  const auto& thrown = request.throw_model();
  const auto pinned = world.simulation().pinned();
  if (std::ranges::any_of(pinned, [&](const auto& link) { return link.starts_with(thrown.model() + "/"); }))
    return robotlink::failure("simulation.pinned", "'" + thrown.model() + "' is pinned; release it first", {},
                              {thrown.model()});
  return world.simulation().throwModel(thrown.model(), vectorOf(thrown.velocity()), vectorOf(thrown.spin()));
}

Result<void> pinObject(SimulatedWorld& world, const Request& request) {
  return world.simulation().pin(request.pin_object().path(), request.pin_object().pinned());
}

Result<void> dragObject(SimulatedWorld& world, const Request& request) {
  const auto& drag = request.drag_object();
  if (drag.released()) {
    const std::string model = drag.path().substr(0, drag.path().find('/'));
    std::vector<std::string> known;
    for (const auto& each : world.simulation().scene().world().models) known.push_back(each.name);
    if (!model.empty() && std::ranges::find(known, model) == known.end())
      return robotlink::failure("simulation.unknown-model",
                                "there is no '" + model + "' here" + robotlink::suggestion(model, known), {},
                                {model});
    world.simulation().release(drag.path());
    return {};
  }
  return world.simulation().drag(drag.path(), vectorOf(drag.grip()), vectorOf(drag.target()),
                                 drag.strength() == 0 ? 1 : drag.strength());
}

Result<void> pushObject(SimulatedWorld& world, const Request& request) {
  const auto& push = request.push_object();
  return world.simulation().push(push.path(), vectorOf(push.force()), vectorOf(push.point()), push.seconds());
}

Result<void> setLighting(SimulatedWorld& world, const Request& request) {
  const auto& wanted = request.set_lighting();
  const double before = world.options().lighting.brightness;
  return world.setLighting({wanted.has_brightness() ? wanted.brightness() : before, wanted.warmth()});
}

Result<void> setSensorErrors(SimulatedWorld& world, const Request& request) {
  const auto& wanted = request.set_sensor_errors();
  const bool ofNumbers = wanted.has_noise() || wanted.has_bias() || wanted.has_drift() ||
                         wanted.has_drift_time() || wanted.has_precision();
  const bool ofTiming = wanted.has_delay() || wanted.has_rate() || wanted.has_dropout();
  if (!ofNumbers && !ofTiming) return world.setSensorErrors(wanted.sensor(), {});
  simcore::SensorErrors errors = world.simulation().errorsInUse(wanted.sensor());
  if (ofNumbers && errors.noise.empty()) errors.noise.emplace_back();
  for (simcore::NoiseModel& noise : errors.noise) {
    if (wanted.has_noise()) noise.stddev = wanted.noise();
    if (wanted.has_bias()) noise.mean = wanted.bias();
    if (wanted.has_drift()) noise.driftStddev = wanted.drift();
    if (wanted.has_drift_time()) noise.driftTime = wanted.drift_time();
    if (wanted.has_precision()) noise.precision = wanted.precision();
    const bool isOfDrift = wanted.has_drift() || wanted.has_drift_time();
    if (isOfDrift && noise.driftStddev > 0 && noise.driftTime == 0)
      noise.driftTime = simcore::NoiseModel::kForever;
  }
  if (wanted.has_delay()) errors.delay = wanted.delay();
  if (wanted.has_rate()) errors.rate = wanted.rate();
  if (wanted.has_dropout()) errors.dropout = wanted.dropout();
  return world.setSensorErrors(wanted.sensor(), errors);
}

Result<void> moveDoor(SimulatedWorld& world, const Request& request) {
  const std::string& path = request.move_door().door();
  simcore::Simulation& simulation = world.simulation();
  const simcore::Port* port = simulation.port(path);
  if (port == nullptr || port->kind != simcore::Port::Kind::kDoor)
    return robotlink::failure("simulation.door", "there is no door '" + path + "'", {}, {path});
  simulation.moveDoor(port->index, request.move_door().open());
  return {};
}

constexpr robotlink::RequestRow<Result<void> (*)(SimulatedWorld&, const Request&)> kWorldRows[]{
    {Request::kPlaceModel, &placeModel},   {Request::kTurnModel, &turnModel},
    {Request::kThrowModel, &throwModel},   {Request::kPinObject, &pinObject},
    {Request::kDragObject, &dragObject},   {Request::kPushObject, &pushObject},
    {Request::kSetLighting, &setLighting}, {Request::kSetSensorErrors, &setSensorErrors},
    {Request::kMoveDoor, &moveDoor}};

}  // namespace

bool changesWorld(const Request& request) {
  return request.has_set_actuator() || robotlink::rowOf(kWorldRows, request.what_case()) != nullptr;
}

Result<void> changeWorld(SimulatedWorld& world, const Request& request,
                         const std::vector<std::string>& stopped) {
  if (request.has_set_actuator())
    return WorldPorts(world).set(request.robot(), request.set_actuator(), stopped);
  const auto* row = robotlink::rowOf(kWorldRows, request.what_case());
  if (row == nullptr)
    return robotlink::failure("simulation.request",
                              "a simulated world cannot " + robotlink::inWords(request));
  return row->handler(world, request);
}

}  // namespace app
