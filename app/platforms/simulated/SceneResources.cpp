// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SceneResources.h"

#include <algorithm>
#include <filesystem>

#include "app/core/program/RobotFiles.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/simulated/game/GameRules.h"
#include "simcore/Scene.h"
#include "simcore/world/WorldDescription.h"

namespace app {

using robotlink::Errors;

namespace {

bool isFile(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored);
}

/// An error at the model of a robot in its scene's file.
Errors atRobot(const simcore::Scene& scene, const simcore::SceneRobot& robot, const std::string& text) {
  const auto& models = scene.world().models;
  const auto model = std::ranges::find(models, robot.name, &simcore::ModelInstance::name);
  const robotlink::FilePosition place =
      model != models.end() ? model->where : robotlink::FilePosition{scene.file().string(), 0, 0};
  return {{"scene.robot", "'" + robot.name + "' " + text, {robot.name}, place}};
}

}  // namespace

Errors missingKind(const simcore::Scene& scene, const simcore::SceneRobot& robot) {
  const auto description = descriptionFile(robot.description);
  if (isFile(description)) return {};
  return atRobot(scene, robot,
                 "is a robot '" + robot.description + "', of which there is no description " +
                     description.string() + "; correct its <robotcontrol:robot>");
}

Errors missingLayout(const simcore::Scene& scene, const simcore::SceneRobot& robot) {
  if (robot.layout.empty() || isFile(layoutNamed(robot.layout))) return {};
  return atRobot(scene, robot,
                 "has a layout '" + robot.layout +
                     "' that is neither a shipped one nor a file; correct its <robotcontrol:layout>");
}

Errors missingField(const simcore::Scene& scene) {
  const std::string& name = scene.field();
  if (name.empty() || isFile(fieldFile(name))) return {};
  const auto& models = scene.world().models;
  const auto model = std::ranges::find_if(models, [&](const auto& each) { return each.type->field == name; });
  return {{"scene.field",
           "'" + (model != models.end() ? model->name : name) + "' is the field '" + name +
               "', of which there is no description " + fieldFile(name).string() +
               "; correct its <robotcontrol:field>",
           {name},
           model != models.end() ? model->where : robotlink::FilePosition{scene.file().string(), 0, 0}}};
}

Errors missingGame(const simcore::Scene& scene) {
  const std::string& name = scene.world().game;
  if (name.empty() || name == kNoGame || isFile(gameRulesNamed(name))) return {};
  return {{"scene.game",
           scene.world().name + ": the <robotcontrol:game> is '" + name +
               "', but there are no rules of that name (" + gameRulesNamed(name).string() +
               "); correct it, or choose others with --game",
           {name},
           scene.world().gameWhere}};
}

std::string leftOutText(const simcore::Scene& scene) {
  const std::size_t count = scene.leftOut().size();
  if (count == 0) return {};
  return std::to_string(count) + (count == 1 ? " part of the scene is" : " parts of the scene are") +
         " left out: robotctl scene check " + scene.file().string() +
         (count == 1 ? " says which" : " lists them");
}

Errors missingResources(const simcore::Scene& scene) {
  Errors all = missingField(scene);
  const auto add = [&](Errors errors) { all.insert(all.end(), errors.begin(), errors.end()); };
  for (const simcore::SceneRobot& robot : scene.robots()) {
    add(missingKind(scene, robot));
    add(missingLayout(scene, robot));
  }
  add(missingGame(scene));
  return all;
}

}  // namespace app
