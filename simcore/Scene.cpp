// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Scene.h"

#include <algorithm>
#include <optional>

#include "simcore/SceneContents.h"
#include "simcore/SceneFileKind.h"
#include "simcore/maps/MapWorld.h"
#include "simcore/placement/RobotPlacement.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/world/RenderSceneBuilder.h"

namespace simcore {
namespace fs = std::filesystem;
using robotlink::Errors;
using robotlink::GroundMap;

namespace {

using ModelTypes = std::map<fs::path, std::shared_ptr<const ModelDescription>>;

/// A copy of a type with `static` overridden by an <include>.
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
      errors.push_back({"scene.color", "no palette has the color '" + include.team + "'", {}, where});
  }
  if (std::ranges::any_of(world.models,
                          [&](const ModelInstance& other) { return other.name == instance.name; })) {
    errors.push_back({"scene.duplicate-name", "there is another model '" + instance.name + "'", {}, where});
  }
  world.models.push_back(std::move(instance));
}

/// A world under construction, from either kind of file.
struct Draft {
  WorldDescription world;
  std::shared_ptr<const GroundMap> map;
  // Empty if the world comes from a map and no model was added.
  SceneFiles files;
};

Draft readSdfScene(const fs::path& file, const SdfSpec& spec, Errors& errors) {
  Draft draft;
  draft.files = SceneFiles::read(file, spec, errors);
  if (!errors.empty()) return draft;
  ModelTypes types;
  for (const auto& [path, text] : draft.files.models)
    types[path] = readSdfModel(text, path.string(), draft.files.palette, spec, errors);
  draft.world = readSdfWorld(draft.files.worldText, file.string(), draft.files.palette, spec, errors);
  for (const SceneInclude& include : draft.files.includes) {
    addInclude(include, draft.files, types, file.string(), draft.world, errors);
  }
  return draft;
}

/// Reports the progress of loading a scene, and whether to continue.
class Progress {
 public:
  Progress(const LoadProgress& report, Errors& errors) : report_(report), errors_(errors) {}

  /// Whether to continue: nothing is wrong yet, and loading was not canceled.
  bool reached(double share) const {
    if (errors_.empty() && report_ && !report_(share))
      errors_.push_back({"scene.given-up", "opening was canceled", {}, {}});
    return errors_.empty();
  }

 private:
  const LoadProgress& report_;
  Errors& errors_;
};

Draft readMapScene(const fs::path& file, const Progress& progress, Errors& errors) {
  Draft draft;
  auto map = GroundMap::load(file);
  if (!map) {
    errors = std::move(map.error());
    return draft;
  }
  if (!progress.reached(0.2)) return draft;
  auto world = mapWorld(*map, file.string());
  if (!world) {
    errors.push_back(std::move(world.error()));
    return draft;
  }
  draft.world = std::move(*world);
  draft.map = std::make_shared<const GroundMap>(std::move(*map));
  return draft;
}

/// The first of the world's own models that fits; null if there is none.
template <typename Fits>
const ModelInstance* firstModel(const WorldDescription& world, Fits fits) {
  const auto found =
      std::ranges::find_if(world.models, [&](const ModelInstance& model) { return fits(*model.type); });
  return found == world.models.end() ? nullptr : &*found;
}

/// Reads the model of the robots to add; null, after adding errors, if it is not a robot.
std::shared_ptr<const ModelDescription> readRobot(Draft& draft, const std::string& name, const fs::path& file,
                                                  const SdfSpec& spec, Errors& errors) {
  const auto model = draft.files.addModel(name, file, spec, errors);
  if (!model || !errors.empty()) return nullptr;
  auto type = readSdfModel(draft.files.models.at(*model), model->string(), draft.files.palette, spec, errors);
  if (!errors.empty()) return nullptr;
  if (!type->robot.empty() && !type->isStatic) return type;
  errors.push_back(
      {"scene.no-robot", "'" + name + "' is not a robot that can be added", {name}, {file.string(), 0, 0}});
  return nullptr;
}

void putRobots(Draft& draft, RobotsToAdd robots, const fs::path& file, const SdfSpec& spec, Errors& errors) {
  std::shared_ptr<const ModelDescription> type;
  if (robots.model.empty()) {
    const auto* own = firstModel(
        draft.world, [](const ModelDescription& model) { return !model.robot.empty() && !model.isStatic; });
    if (own != nullptr) type = own->type;
    robots.model = own != nullptr ? own->type->name : RobotsToAdd{}.model;
  }
  if (!type) type = readRobot(draft, robots.model, file, spec, errors);
  if (!type) return;
  const auto added =
      addRobots(draft.world, draft.map.get(), type, robots, draft.files.palette, file.string());
  if (!added) errors.push_back(added.error());
}

}  // namespace

Scene::Scene() : contents_(std::make_unique<SceneContents>()) {}
Scene::~Scene() = default;

tl::expected<std::shared_ptr<const Scene>, Errors> Scene::load(const fs::path& file,
                                                               const RobotsToAdd& robots,
                                                               const LoadProgress& report) {
  Errors errors;
  const Progress progress(report, errors);
  if (!progress.reached(0)) return tl::unexpected(std::move(errors));
  // It takes longer to make than a small map takes to read.
  std::optional<SdfSpec> spec;
  if (!isMapFile(file) || robots.count > 0) spec.emplace();
  Draft draft = isMapFile(file) ? readMapScene(file, progress, errors) : readSdfScene(file, *spec, errors);
  if (progress.reached(0.4) && robots.count > 0) putRobots(draft, robots, file, *spec, errors);
  if (!progress.reached(0.8)) return tl::unexpected(std::move(errors));
  const std::shared_ptr<Scene> scene(new Scene);
  SceneContents& implementation = *scene->contents_;
  implementation.file = file;
  implementation.world = std::move(draft.world);
  implementation.groundMap = std::move(draft.map);
  for (const ModelInstance& model : implementation.world.models) {
    if (!model.type->robot.empty())
      implementation.robots.push_back({model.name, model.type->robot, model.teamColorName});
    if (model.type->isBall) implementation.balls.push_back(model.name);
  }
  if (const auto* field =
          firstModel(implementation.world, [](const auto& model) { return !model.field.empty(); })) {
    implementation.field = field->type->field;
  }
  implementation.renderScene = buildRenderScene(implementation.world);
  if (!progress.reached(0.95)) return tl::unexpected(std::move(errors));
  return scene;
}

const fs::path& Scene::file() const {
  return contents_->file;
}
const std::vector<Scene::Robot>& Scene::robots() const {
  return contents_->robots;
}
const std::string& Scene::field() const {
  return contents_->field;
}
const std::vector<std::string>& Scene::balls() const {
  return contents_->balls;
}
std::shared_ptr<const robotlink::GroundMap> Scene::groundMap() const {
  return contents_->groundMap;
}

}  // namespace simcore
