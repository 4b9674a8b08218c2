// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/adapter/SceneCommands.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "app/platforms/simulated/scenetext/SceneText.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;

/// The names of what can be placed; empty without a simulation.
std::vector<std::string> models(OpenPlatform& open) {
  const auto* status = open.session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, open.session().timeline().newest());
  if (status == nullptr) return {};
  return {status->models().begin(), status->models().end()};
}

const robotcontrol::WorldObjects* objects(OpenPlatform& open) {
  return open.session().store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                     open.session().timeline().newest());
}

/// Whether there is a model of this name.
bool isModel(OpenPlatform& open, const std::string& name) {
  const auto* all = objects(open);
  return all != nullptr && std::ranges::any_of(all->objects(), [&](const robotcontrol::WorldObject& object) {
           return object.path() == name && object.model() == name;
         });
}

Result<void> place(OpenPlatform& open, const Values& values) {
  const std::string& model = text(values, 0);
  const auto known = models(open);
  if (std::ranges::find(known, model) == known.end() && isModel(open, model))
    return failure("scene.model",
                   "'" + model + "' is fixed to the world; change its <pose> in the scene's file instead", {},
                   {model});
  if (known.empty())
    return failure("scene.none", "there is no simulation in which something could be placed; open a scene");
  if (std::ranges::find(known, model) == known.end()) {
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    return failure("scene.model", "there is no model " + model + " that can be placed; there are " + names,
                   {}, {model});
  }
  robotcontrol::Request request;
  auto& details = *request.mutable_place_model();
  details.set_model(model);
  details.mutable_pose_in_field()->set_x(number(values, 1));
  details.mutable_pose_in_field()->set_y(number(values, 2));
  details.mutable_pose_in_field()->set_heading(std::remainder(number(values, 3), 2 * std::numbers::pi));
  details.set_height(number(values, 4));
  details.set_roll(number(values, 5));
  details.set_pitch(number(values, 6));
  open.ask(std::move(request));
  return {};
}

/// The ports of all actuators; empty without a simulation.
std::vector<std::string> actuators(OpenPlatform& open) {
  std::vector<std::string> ports;
  if (const auto* all = objects(open)) {
    for (const auto& object : all->objects())
      if (object.port().is_actuator()) ports.push_back(object.port().path());
  }
  return ports;
}

Result<void> setActuator(OpenPlatform& open, robotcontrol::SetActuator set) {
  const std::string port = set.port();
  robotcontrol::Request request;
  if (!port.empty()) {
    const auto known = actuators(open);
    if (std::ranges::find(known, port) == known.end())
      return failure("scene.actuator", "there is no actuator " + port + robotlink::suggestion(port, known),
                     {}, {port});
    const std::string robot = port.substr(0, port.find('/'));
    const auto& robots = open.session().robots();
    if (std::ranges::find(robots, robot) != robots.end()) request.set_robot(robot);
  }
  *request.mutable_set_actuator() = std::move(set);
  open.ask(std::move(request));
  return {};
}

Result<void> hold(OpenPlatform& open, const Values& values) {
  robotcontrol::SetActuator set;
  set.set_port(text(values, 0));
  std::size_t count = 1;
  if (const auto* all = objects(open)) {
    const auto object = std::ranges::find(all->objects(), set.port(), &robotcontrol::WorldObject::path);
    if (object != all->objects().end() && object->port().shape_size() == 1)
      count = static_cast<std::size_t>(std::max(1, object->port().shape(0)));
  }
  // Programs set actuators with more values.
  for (std::size_t i = 0; i < std::min(count, values.size() - 1); ++i) set.add_values(number(values, i + 1));
  return setActuator(open, std::move(set));
}

Result<void> release(OpenPlatform& open, const Values& values) {
  robotcontrol::SetActuator set;
  set.set_port(text(values, 0));
  set.set_released(true);
  return setActuator(open, std::move(set));
}

/// Asks for what is done by hand, unless something is wrong with it.
Result<void> askByHand(OpenPlatform& open, robotcontrol::Request request) {
  const auto* status = open.session().store().latestAs<robotcontrol::SimulationStatus>(
      robotlink::streams::kSimulation, open.session().timeline().newest());
  if (status == nullptr || status->is_real())
    return failure("scene.none", "there is no simulation in which something could be moved; open a scene");
  if (const std::string wrong = robotlink::wrongWith(request); !wrong.empty())
    return failure("scene.hand", wrong);
  open.ask(std::move(request));
  return {};
}

template <typename Vector>
void setVector(Vector& vector, const Values& values, std::size_t first) {
  vector.set_x(number(values, first));
  vector.set_y(number(values, first + 1));
  vector.set_z(number(values, first + 2));
}

Result<void> turn(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  auto& details = *request.mutable_turn_model();
  details.set_model(text(values, 0));
  details.set_heading(number(values, 1));
  details.set_roll(number(values, 2));
  details.set_pitch(number(values, 3));
  return askByHand(open, std::move(request));
}

Result<void> throwModel(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  auto& details = *request.mutable_throw_model();
  details.set_model(text(values, 0));
  setVector(*details.mutable_velocity(), values, 1);
  details.mutable_spin()->set_z(number(values, 4));
  return askByHand(open, std::move(request));
}

Result<void> pin(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  request.mutable_pin_object()->set_path(text(values, 0));
  request.mutable_pin_object()->set_pinned(flag(values, 1));
  return askByHand(open, std::move(request));
}

Result<void> drag(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  auto& details = *request.mutable_drag_object();
  details.set_path(text(values, 0));
  setVector(*details.mutable_target(), values, 1);
  details.set_strength(number(values, 4));
  return askByHand(open, std::move(request));
}

Result<void> drop(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  request.mutable_drag_object()->set_path(text(values, 0));
  request.mutable_drag_object()->set_released(true);
  return askByHand(open, std::move(request));
}

Result<void> push(OpenPlatform& open, const Values& values) {
  robotcontrol::Request request;
  auto& details = *request.mutable_push_object();
  details.set_path(text(values, 0));
  setVector(*details.mutable_force(), values, 1);
  details.set_seconds(number(values, 4));
  return askByHand(open, std::move(request));
}

/// The height of a model's frame; fails if the text is no number.
Result<std::optional<double>> heightIn(const std::string& text) {
  if (text.empty()) return std::optional<double>();
  char* end = nullptr;
  const double height = std::strtod(text.c_str(), &end);
  if (end == text.c_str() + text.size() && std::isfinite(height)) return std::optional(height);
  return failure("scene.height", "the height must be a number of meters, not '" + text + "'", {}, {text});
}

Result<void> whetherSimulated(OpenPlatform& open) {
  const LoadedPlatform* loaded = open.loaded();
  if (loaded == nullptr || loaded->adapter != SimulationFeed::kAdapter)
    return failure("simulation.none", "there is no simulation; open a scene first");
  return {};
}

Result<void> edit(OpenPlatform& open, robotcontrol::EditScene change) {
  if (auto simulated = whetherSimulated(open); !simulated) return simulated;
  robotcontrol::Request request;
  *request.mutable_edit_scene() = std::move(change);
  if (const std::string wrong = robotlink::wrongWith(request); !wrong.empty())
    return failure("scene.edit", wrong);
  open.ask(std::move(request));
  return {};
}

Result<void> add(OpenPlatform& open, const Values& values) {
  const auto height = heightIn(text(values, 5));
  if (!height) return tl::unexpected(height.error());
  robotcontrol::EditScene change;
  auto& added = *change.mutable_add();
  added.set_model(text(values, 0));
  added.mutable_pose_in_field()->set_x(number(values, 1));
  added.mutable_pose_in_field()->set_y(number(values, 2));
  added.mutable_pose_in_field()->set_heading(std::remainder(number(values, 3), 2 * std::numbers::pi));
  added.set_name(text(values, 4));
  if (*height) added.set_height(**height);
  added.set_team(text(values, 6));
  return edit(open, std::move(change));
}

Result<void> removeModel(OpenPlatform& open, const Values& values) {
  robotcontrol::EditScene change;
  change.mutable_remove()->set_model(text(values, 0));
  return edit(open, std::move(change));
}

Result<void> duplicate(OpenPlatform& open, const Values& values) {
  robotcontrol::EditScene change;
  change.mutable_duplicate()->set_model(text(values, 0));
  change.mutable_duplicate()->set_name(text(values, 1));
  return edit(open, std::move(change));
}

Result<void> undo(OpenPlatform& open) {
  robotcontrol::EditScene change;
  change.set_undo(true);
  return edit(open, std::move(change));
}

/// The names of all models of the scene.
std::vector<std::string> allModels(OpenPlatform& open) {
  std::vector<std::string> names;
  if (const auto* all = objects(open)) {
    for (const auto& object : all->objects())
      if (object.path() == object.model()) names.push_back(object.path());
  }
  return names;
}

/// Returns the models that can be added by name.
std::vector<std::string> addable(OpenPlatform& open) {
  std::vector<std::string> names;
  const LoadedPlatform* loaded = open.loaded();
  if (!whetherSimulated(open) || loaded->sources.empty()) return names;
  for (const SceneModelFile& model : sceneModels(loaded->sources.front(), open.modelFolders()))
    names.push_back(model.name);
  return names;
}

Result<void> reload(OpenPlatform& open) {
  if (auto simulated = whetherSimulated(open); !simulated) return simulated;
  open.readSceneAgain();
  return {};
}

}  // namespace

void addSceneCommands(CommandTable& commands, OpenPlatform& open) {
  const auto ports = [&open](const auto& before) {
    return before.empty() ? actuators(open) : std::vector<std::string>();
  };
  commands.attach(
      "scene.hold", [&open](const Values& values) { return hold(open, values); }, ports);
  commands.attach(
      "scene.release", [&open](const Values& values) { return release(open, values); }, ports);
  commands.attach(
      "scene.place", [&open](const Values& values) { return place(open, values); },
      [&open](const auto& before) { return before.empty() ? models(open) : std::vector<std::string>(); });
  const auto moved = [&open](const auto& before) {
    return before.empty() ? models(open) : std::vector<std::string>();
  };
  const auto byHand = [&](const char* name, Result<void> (*handler)(OpenPlatform&, const Values&)) {
    commands.attach(
        name, [&open, handler](const Values& values) { return handler(open, values); }, moved);
  };
  byHand("scene.turn", &turn);
  byHand("scene.throw", &throwModel);
  byHand("scene.pin", &pin);
  byHand("scene.drag", &drag);
  byHand("scene.drop", &drop);
  byHand("scene.push", &push);
  const auto ofModels = [&open](const auto& before) {
    return before.empty() ? allModels(open) : std::vector<std::string>();
  };
  commands.attach(
      "scene.add", [&open](const Values& values) { return add(open, values); },
      [&open](const auto& before) { return before.empty() ? addable(open) : std::vector<std::string>(); });
  commands.attach(
      "scene.remove", [&open](const Values& values) { return removeModel(open, values); }, ofModels);
  commands.attach(
      "scene.duplicate", [&open](const Values& values) { return duplicate(open, values); }, ofModels);
  commands.attach("scene.undo", [&open](const Values&) { return undo(open); });
  commands.attach("scene.reload", [&open](const Values&) { return reload(open); });
}

}  // namespace app
