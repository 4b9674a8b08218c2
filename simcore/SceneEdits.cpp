// SPDX-License-Identifier: GPL-3.0-or-later
// Scene: the same scene with other models.
#include <algorithm>
#include <optional>

#include "simcore/Scene.h"
#include "simcore/SceneContents.h"
#include "simcore/placement/RobotPlacement.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/world/ModelGeometry.h"

namespace simcore {
using robotlink::Errors;
using robotlink::failure;
using robotlink::Result;

namespace {

bool hasModel(const WorldDescription& world, const std::string& name) {
  return std::ranges::find(world.models, name, &ModelInstance::name) != world.models.end();
}

auto nameIsTaken(const std::string& name) {
  return failure("scene.duplicate-name", "there is another model '" + name + "'; choose another name", {},
                 {name});
}

/// The height of the highest level plane; 0 without one.
double floorOf(const WorldDescription& world) {
  std::optional<double> floor;
  for (const ModelInstance& model : world.models) {
    const std::vector<Pose3> links = linksAtStart(*model.type);
    for (std::size_t i = 0; i < links.size(); ++i) {
      for (const CollisionDescription& collision : model.type->links[i].collisions) {
        if (collision.shape.kind != Shape::Kind::kPlane) continue;
        const Pose3 plane = model.poseInWorld * links[i] * collision.poseInLink;
        const bool isLevel = plane.linear()(2, 2) > 1 - 1e-9;
        if (isLevel) floor = std::max(floor.value_or(plane.translation().z()), plane.translation().z());
      }
    }
  }
  return floor.value_or(0);
}

Pose3 poseOfAdded(const ModelToAdd& added, const ModelDescription& type, const WorldDescription& world) {
  const double height = added.height ? *added.height : floorOf(world) - extentOf(type).low;
  return Eigen::Translation3d(added.place.x, added.place.y, height) *
         Pose3(Eigen::AngleAxisd(added.place.heading, Vector3::UnitZ()));
}

}  // namespace

std::string Scene::freeName(const std::string& prefix, bool numbered) const {
  if (!numbered && !hasModel(contents_->world, prefix)) return prefix;
  for (int number = 1;; ++number) {
    std::string name = prefix + std::to_string(number);
    if (!hasModel(contents_->world, name)) return name;
  }
}

tl::expected<std::shared_ptr<const Scene>, Errors> Scene::with(const ModelToAdd& added) const {
  Errors errors;
  const SdfSpec& spec = SdfSpec::shared();
  SceneFiles files(contents_->file, contents_->modelFolders, contents_->palette);
  const auto file = files.addModelOf(added.model, spec, errors);
  const auto* element = file && errors.empty() ? files.model(*file) : nullptr;
  if (element == nullptr) return tl::unexpected(std::move(errors));
  MeshFiles meshes;
  LeftOuts leftOut = files.leftOut();
  const auto type = readSdfModel(*element, file->string(), {files, spec, meshes, errors, leftOut});
  if (!type) return tl::unexpected(std::move(errors));
  ModelInstance instance;
  instance.type = type;
  instance.poseInWorld = poseOfAdded(added, *type, contents_->world);
  instance.where = {file->string(), 0, 0};
  if (!added.team.empty()) {
    const auto color = files.palette().find(added.team);
    if (color == files.palette().end())
      return tl::unexpected(Errors{{"scene.color", "no palette has the color '" + added.team + "'", {}, {}}});
    instance.teamColorName = added.team;
    instance.teamColor = color->second;
  }
  const std::string& prefix = added.team.empty() || !wearsTeamColor(*type) ? type->name : added.team;
  instance.name = added.name.empty() ? freeName(prefix, !type->robot.empty()) : added.name;
  if (hasModel(contents_->world, instance.name))
    return tl::unexpected(Errors{nameIsTaken(instance.name).value()});
  std::shared_ptr<Scene> scene(new Scene);
  *scene->contents_ = *contents_;
  scene->contents_->palette = files.palette();
  for (LeftOut& one : leftOut) leaveOut(scene->contents_->leftOut, std::move(one));
  scene->contents_->world.models.push_back(std::move(instance));
  scene->contents_->complete();
  return scene;
}

Result<std::shared_ptr<const Scene>> Scene::with(const ModelInstance& model, std::size_t index) const {
  if (hasModel(contents_->world, model.name)) return nameIsTaken(model.name);
  const std::shared_ptr<Scene> scene(new Scene);
  *scene->contents_ = *contents_;
  auto& models = scene->contents_->world.models;
  models.insert(models.begin() + static_cast<std::ptrdiff_t>(std::min(index, models.size())), model);
  scene->contents_->complete();
  return scene;
}

Result<std::shared_ptr<const Scene>> Scene::without(const std::string& model) const {
  if (!hasModel(contents_->world, model))
    return failure("scene.model", "there is no model '" + model + "' in the scene", {}, {model});
  if (contents_->world.models.size() == 1)
    return failure("scene.last-model",
                   "'" + model + "' is the only model in the scene, so it cannot be removed", {}, {model});
  const std::shared_ptr<Scene> scene(new Scene);
  *scene->contents_ = *contents_;
  std::erase_if(scene->contents_->world.models, [&](const auto& each) { return each.name == model; });
  scene->contents_->complete();
  return scene;
}

}  // namespace simcore
