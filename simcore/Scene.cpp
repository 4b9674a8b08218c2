// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/Scene.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "simcore/PortList.h"
#include "simcore/SceneContents.h"
#include "simcore/SceneFileKind.h"
#include "simcore/control/ControllerCheck.h"
#include "simcore/maps/MapWorld.h"
#include "simcore/placement/RobotPlacement.h"
#include "simcore/sdf/ModelWorld.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/world/RenderSceneBuilder.h"
#include "simcore/world/WorldSize.h"

namespace simcore {
namespace fs = std::filesystem;
using robotlink::Errors;
using robotlink::GroundMap;

namespace {

/// The types of included models, by file and by whether an <include> makes them static.
class IncludedTypes {
 public:
  explicit IncludedTypes(const SdfSources& sources) : sources_(sources) {}

  /// Null after errors, which are reported once.
  std::shared_ptr<const ModelDescription> of(const fs::path& file, std::optional<bool> isStatic) {
    const auto key = std::pair(file, isStatic);
    const auto known = types_.find(key);
    if (known != types_.end()) return known->second;
    const auto* model = sources_.files.model(file);
    auto type = model != nullptr ? readSdfModel(*model, file.string(), sources_, isStatic) : nullptr;
    // An <include> that says what the model says anyway has the same type.
    if (type && !isStatic) types_[std::pair(file, std::optional(type->isStatic))] = type;
    return types_[key] = type;
  }

 private:
  const SdfSources& sources_;
  std::map<std::pair<fs::path, std::optional<bool>>, std::shared_ptr<const ModelDescription>> types_;
};

/// The role that robots can have in their team from the start.
constexpr const char* kGoalieRole = "goalie";

/// Sets team, layout and role that an <include> names.
void setUse(const SceneInclude& include, const SceneFiles& files, ModelInstance& instance, Errors& errors) {
  instance.layout = include.layout;
  instance.role = include.role;
  if (!include.role.empty() && include.role != kGoalieRole) {
    errors.push_back(
        {"scene.role",
         "'" + instance.name +
             "': the <robotcontrol:role> must be goalie, or be omitted, so that the team decides; not '" +
             include.role + "'",
         {instance.name},
         instance.where});
  }
  if (include.team.empty()) return;
  const auto color = files.palette().find(include.team);
  instance.teamColorName = include.team;
  if (color != files.palette().end())
    instance.teamColor = color->second;
  else
    errors.push_back({"scene.color", "no palette has the color '" + include.team + "'", {}, instance.where});
}

void setMotion(const SceneInclude& include, ModelInstance& instance, Errors& errors) {
  if (include.motion.empty()) return;
  const auto mode = motionModeOf(include.motion, include.motionAtObjects);
  instance.motion = mode.value_or(MotionMode::kUnset);
  const bool pushes =
      instance.type->drive && include.motionAtObjects == "push" && mode && *mode != MotionMode::kPhysics;
  const bool fits = mode && (*mode == MotionMode::kPhysics || instance.follows() || instance.type->drive);
  if (fits && !pushes) return;
  errors.push_back({"scene.motion",
                    "'" + instance.name + "': " +
                        (!mode    ? kMotionRule
                         : pushes ? kDrivesStop
                                  : kMotionNeeds),
                    {instance.name},
                    instance.where});
}

ModelInstance instanceOf(const SceneInclude& include, const SceneFiles& files,
                         std::shared_ptr<const ModelDescription> type, Errors& errors) {
  ModelInstance instance;
  instance.name = include.name.empty() ? type->name : include.name;
  instance.where = {files.file().string(), include.line, 0};
  instance.poseInWorld =
      include.pose ? poseFromNumbers(*include.pose) : ownPoseOf(*files.model(include.file));
  instance.type = std::move(type);
  if (!instance.poseInWorld.matrix().allFinite() || instance.poseInWorld.translation().norm() > 1e5) {
    errors.push_back({"scene.pose", "a pose must be finite and at most 100 km away", {}, instance.where});
  }
  setUse(include, files, instance, errors);
  setMotion(include, instance, errors);
  return instance;
}

void checkNames(const WorldDescription& world, Errors& errors) {
  std::set<std::string> names;
  for (const ModelInstance& model : world.models) {
    if (names.insert(model.name).second) continue;
    errors.push_back(
        {"scene.duplicate-name", "there is another model '" + model.name + "'", {}, model.where});
  }
}

void checkSize(const WorldDescription& world, Errors& errors) {
  const ModelInstance* const large = firstTooMany(world);
  if (large == nullptr) return;
  errors.push_back({"scene.size",
                    "with '" + large->name + "' the scene has more than " + std::to_string(kMaxWorldParts) +
                        " links, joints, shapes and sensors",
                    {large->name},
                    large->where});
}

/// Reports what controllers name and the world does not have.
void checkControl(const WorldDescription& world, Errors& errors) {
  const bool hasAny =
      !world.controllers.empty() || std::ranges::any_of(world.models, [](const ModelInstance& model) {
        return !model.type->controllers.empty();
      });
  if (hasAny) checkControllers(world, portsOf(Ports::of(world), world), errors);
}

/// A world under construction, from either kind of file.
struct Draft {
  WorldDescription world;
  std::shared_ptr<const GroundMap> map;
  SceneFiles files;
  LeftOuts leftOut;
};

Draft readSdfScene(const fs::path& file, const std::vector<fs::path>& folders, const SceneTexts& texts,
                   const SdfSpec& spec, Errors& errors) {
  Draft draft{{}, {}, SceneFiles(file, folders, texts, spec, errors), {}};
  MeshFiles meshes;
  const SdfSources sources{draft.files, spec, meshes, errors, draft.leftOut};
  if (draft.files.world() == nullptr) {
    const auto* model = draft.files.model(file);
    auto type = model != nullptr ? readSdfModel(*model, file.string(), sources) : nullptr;
    if (type) draft.world = worldOfModel(std::move(type), ownPoseOf(*model));
    return draft;
  }
  IncludedTypes types(sources);
  bool includesRead = false;
  draft.world = readSdfWorld(sources, includesRead);
  for (const SceneInclude& include : draft.files.includes()) {
    if (includesRead) {
      const auto read = std::ranges::find(draft.world.models, include.name, &ModelInstance::name);
      if (read == draft.world.models.end()) continue;
      setUse(include, draft.files, *read, errors);
      setMotion(include, *read, errors);
    } else if (auto type = types.of(include.file, include.isStatic)) {
      draft.world.models.push_back(instanceOf(include, draft.files, std::move(type), errors));
    }
  }
  checkNames(draft.world, errors);
  checkSize(draft.world, errors);
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
  Draft draft{{}, {}, SceneFiles(file), {}};
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
  const auto model = draft.files.addModel(name, spec, errors);
  if (!model || !errors.empty()) return nullptr;
  MeshFiles meshes;
  const SdfSources sources{draft.files, spec, meshes, errors, draft.leftOut};
  auto type = readSdfModel(*draft.files.model(*model), model->string(), sources);
  if (!type || !errors.empty()) return nullptr;
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
      addRobots(draft.world, draft.map.get(), type, robots, draft.files.palette(), file.string());
  if (!added) errors.push_back(added.error());
}

}  // namespace

void SceneContents::complete() {
  robots.clear();
  balls.clear();
  for (const ModelInstance& model : world.models) {
    const std::string& layout = model.layout.empty() ? model.type->layout : model.layout;
    if (!model.type->robot.empty())
      robots.push_back({model.name, model.type->robot, model.teamColorName, layout, model.role});
    if (model.type->isBall) balls.push_back(model.name);
  }
  const auto* shown = firstModel(world, [](const auto& model) { return !model.field.empty(); });
  field = shown != nullptr ? shown->type->field : std::string();
  renderScene = buildRenderScene(world);
}

Scene::Scene() : contents_(std::make_unique<SceneContents>()) {}
Scene::~Scene() = default;

tl::expected<std::shared_ptr<const Scene>, Errors> Scene::load(const fs::path& file,
                                                               const RobotsToAdd& robots,
                                                               const LoadProgress& report,
                                                               const std::vector<fs::path>& modelFolders,
                                                               const SceneTexts& texts) {
  Errors errors;
  const Progress progress(report, errors);
  if (!progress.reached(0)) return tl::unexpected(std::move(errors));
  Draft draft = isMapFile(file) ? readMapScene(file, progress, errors)
                                : readSdfScene(file, modelFolders, texts, SdfSpec::shared(), errors);
  if (progress.reached(0.4) && robots.count > 0) putRobots(draft, robots, file, SdfSpec::shared(), errors);
  checkControl(draft.world, errors);
  if (!progress.reached(0.8)) return tl::unexpected(std::move(errors));
  const std::shared_ptr<Scene> scene(new Scene);
  SceneContents& implementation = *scene->contents_;
  implementation.file = file;
  implementation.world = std::move(draft.world);
  implementation.groundMap = std::move(draft.map);
  implementation.leftOut = draft.files.leftOut();
  for (LeftOut& one : draft.leftOut) leaveOut(implementation.leftOut, std::move(one));
  implementation.modelFolders = modelFolders;
  implementation.palette = draft.files.palette();
  implementation.complete();
  if (!progress.reached(0.95)) return tl::unexpected(std::move(errors));
  return scene;
}

const fs::path& Scene::file() const {
  return contents_->file;
}
const std::vector<Scene::Robot>& Scene::robots() const {
  return contents_->robots;
}
std::vector<SceneModel> Scene::models() const {
  std::vector<SceneModel> result;
  for (const ModelInstance& model : contents_->world.models)
    result.push_back({model.name, model.type->file, model.type->isStatic});
  return result;
}
const std::string& Scene::field() const {
  return contents_->field;
}
const std::vector<std::string>& Scene::balls() const {
  return contents_->balls;
}
const LeftOuts& Scene::leftOut() const {
  return contents_->leftOut;
}
const WorldDescription& Scene::world() const {
  return contents_->world;
}
std::shared_ptr<const robotlink::GroundMap> Scene::groundMap() const {
  return contents_->groundMap;
}

}  // namespace simcore
