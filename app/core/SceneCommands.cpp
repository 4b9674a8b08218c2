// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/SceneCommands.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "robotcontrol/Requests.pb.h"
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

Result<void> place(OpenPlatform& open, const Values& values) {
  const std::string& model = text(values, 0);
  const auto known = models(open);
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

}  // namespace

void addSceneCommands(CommandTable& commands, OpenPlatform& open) {
  commands.attach(
      "scene.place", [&open](const Values& values) { return place(open, values); },
      [&open](const auto& before) { return before.empty() ? models(open) : std::vector<std::string>(); });
}

}  // namespace app
