// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Scene.h"

#include <algorithm>

#include "simcore/RenderSceneBuilder.h"
#include "simcore/SceneImplementation.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"

namespace simcore {
namespace fs = std::filesystem;
using robotlink::Errors;

namespace {

using ModelTypes = std::map<fs::path, std::shared_ptr<const ModelDescription>>;

/// A type with `static` overridden by an <include>.
std::shared_ptr<const ModelDescription> madeStatic(const std::shared_ptr<const ModelDescription>& type) {
  auto copy = std::make_shared<ModelDescription>(*type);
  copy->isStatic = true;
  return copy;
}

void addInclude(const SceneInclude& include, const SceneFiles& files, const ModelTypes& types,
                const std::string& file, WorldDescription& world, Errors& errors) {
  const auto& type = types.at(include.file);
  if (!type) return;
  const robotlink::FilePosition where{file, include.line, 0};
  ModelInstance instance;
  instance.name = include.name.empty() ? type->name : include.name;
  instance.type = include.isStatic && !type->isStatic ? madeStatic(type) : type;
  instance.poseInWorld = poseFromNumbers(include.pose);
  instance.where = where;
  if (!instance.poseInWorld.matrix().allFinite() || instance.poseInWorld.translation().norm() > 1e4) {
    errors.push_back({"scene.pose", "a pose must be finite and at most 10 km away", {}, where});
  }
  if (!include.team.empty()) {
    const auto color = files.palette.find(include.team);
    instance.teamColorName = include.team;
    if (color != files.palette.end())
      instance.teamColor = color->second;
    else
      errors.push_back({"scene.color", "no palette has the colour '" + include.team + "'", {}, where});
  }
  if (std::ranges::any_of(world.models,
                          [&](const ModelInstance& other) { return other.name == instance.name; })) {
    errors.push_back({"scene.duplicate-name", "there is another model '" + instance.name + "'", {}, where});
  }
  world.models.push_back(std::move(instance));
}

WorldDescription readWorld(const fs::path& file, Errors& errors) {
  const SdfSpec spec;
  const SceneFiles files = SceneFiles::read(file, spec, errors);
  if (!errors.empty()) return {};
  ModelTypes types;
  for (const auto& [path, text] : files.models)
    types[path] = readSdfModel(text, path.string(), files.palette, spec, errors);
  WorldDescription world = readSdfWorld(files.worldText, file.string(), files.palette, spec, errors);
  for (const SceneInclude& include : files.includes) {
    addInclude(include, files, types, file.string(), world, errors);
  }
  return world;
}

}  // namespace

Scene::Scene() : implementation_(std::make_unique<Implementation>()) {}
Scene::~Scene() = default;

tl::expected<std::shared_ptr<const Scene>, Errors> Scene::load(const fs::path& file) {
  Errors errors;
  WorldDescription world = readWorld(file, errors);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  const std::shared_ptr<Scene> scene(new Scene);
  Implementation& implementation = *scene->implementation_;
  implementation.file = file;
  implementation.world = std::move(world);
  for (const ModelInstance& model : implementation.world.models) {
    if (!model.type->robot.empty()) implementation.robots.push_back({model.name, model.type->robot});
  }
  implementation.renderScene = buildRenderScene(implementation.world);
  return scene;
}

const fs::path& Scene::file() const {
  return implementation_->file;
}
const std::vector<Scene::Robot>& Scene::robots() const {
  return implementation_->robots;
}

}  // namespace simcore
