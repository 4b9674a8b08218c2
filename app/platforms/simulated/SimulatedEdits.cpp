// SPDX-License-Identifier: GPL-3.0-or-later
// SimulatedRun: models that are added, removed and duplicated while it runs.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/platforms/simulated/SimulatedRun.h"
#include "simcore/Scene.h"
#include "simcore/world/ModelGeometry.h"
#include "simcore/world/WorldDescription.h"

namespace app {

using robotlink::Errors;
using simcore::ModelInstance;

namespace {

constexpr std::size_t kMaxEdits = 100;

const ModelInstance* findModel(const simcore::Scene& scene, const std::string& name) {
  const auto& models = scene.world().models;
  const auto found = std::ranges::find(models, name, &ModelInstance::name);
  return found == models.end() ? nullptr : &*found;
}

/// The name of the model that has what a path leads to: "red1" of "red1/link:head".
std::string modelOf(const std::string& path) {
  return path.substr(0, path.find('/'));
}

tl::unexpected<Errors> noSuchModel(const std::string& name) {
  return tl::unexpected(Errors{{"scene.model", "there is no model '" + name + "' in the scene", {name}, {}}});
}

/// A name without the number at its end: "p3at" of "p3at12".
std::string withoutNumber(const std::string& name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  return last == std::string::npos ? name : name.substr(0, last + 1);
}

/// The places around a model where its copy could be, the nearest first.
std::vector<robotlink::Pose2> placesBeside(const robotlink::Pose2& pose, double radius) {
  constexpr int kRings = 4, kDirections = 8;
  std::vector<robotlink::Pose2> places;
  for (int ring = 0; ring < kRings; ++ring) {
    const double distance = (2 * radius + 0.1) * (1 + 0.5 * ring);
    for (int i = 0; i < kDirections; ++i) {
      const double angle = pose.heading + 2 * std::numbers::pi * i / kDirections;
      places.push_back(
          {pose.x + distance * std::cos(angle), pose.y + distance * std::sin(angle), pose.heading});
    }
  }
  return places;
}

}  // namespace

void SimulatedRun::noteEdit(Edit edit) {
  edits_.push_back(std::move(edit));
  if (edits_.size() > kMaxEdits) edits_.erase(edits_.begin());
}

std::shared_ptr<const simcore::Scene> SimulatedRun::withEdits(
    std::shared_ptr<const simcore::Scene> scene) const {
  const simcore::Scene& present = world_->simulation().scene();
  for (const auto& model : read_->world().models) {
    if (findModel(present, model.name) != nullptr) continue;
    if (auto without = scene->without(model.name)) scene = std::move(*without);
  }
  for (const auto& model : present.world().models) {
    if (findModel(*read_, model.name) != nullptr) continue;
    // Fails if the edited file has a model of this name by now; that one counts.
    if (auto with = scene->with(model, scene->world().models.size())) scene = std::move(*with);
  }
  return scene;
}

tl::expected<std::string, Errors> SimulatedRun::addModel(const simcore::ModelToAdd& model) {
  auto scene = world_->simulation().scene().with(model);
  if (!scene) return tl::unexpected(std::move(scene.error()));
  const std::string name = (*scene)->world().models.back().name;
  if (auto done = goOnIn(*scene, {.fitsNow = true}); !done) return tl::unexpected(std::move(done.error()));
  noteEdit({.kind = Edit::Kind::kAddition, .model = name});
  return name + " was added.";
}

tl::expected<void, Errors> SimulatedRun::takeOut(const std::string& model) {
  auto scene = world_->simulation().scene().without(model);
  if (!scene) return tl::unexpected(Errors{scene.error()});
  if (auto done = goOnIn(*scene, {.fitsNow = true}); !done) return tl::unexpected(std::move(done.error()));
  return {};
}

tl::expected<std::string, Errors> SimulatedRun::removeModel(const std::string& path) {
  const std::string name = modelOf(path);
  const auto scene = world_->simulation().sharedScene();
  const ModelInstance* model = findModel(*scene, name);
  if (model == nullptr) return noSuchModel(name);
  Edit edit{.kind = Edit::Kind::kRemoval,
            .model = name,
            .instance = std::make_shared<const ModelInstance>(*model),
            .index = static_cast<std::size_t>(model - scene->world().models.data()),
            .motion = world_->simulation().motionOf(name)};
  if (auto done = takeOut(name); !done) return tl::unexpected(std::move(done.error()));
  noteEdit(std::move(edit));
  return name + " was removed.";
}

tl::expected<std::string, Errors> SimulatedRun::duplicateModel(const std::string& path,
                                                               const std::string& wanted) {
  const std::string name = modelOf(path);
  const auto scene = world_->simulation().sharedScene();
  const ModelInstance* model = findModel(*scene, name);
  const auto pose = world_->simulation().modelPose(name);
  if (model == nullptr || !pose) return noSuchModel(name);
  ModelInstance copy = *model;
  copy.name = wanted.empty() ? scene->freeName(withoutNumber(name), true) : wanted;
  if (findModel(*scene, copy.name) != nullptr)
    return tl::unexpected(Errors{{"scene.duplicate-name",
                                  "there is another model '" + copy.name + "'; choose another name",
                                  {copy.name},
                                  {}}});
  // The copy is as high as in its file, since the model may have fallen.
  const robotlink::Pose2 here = robotlink::groundPose(*pose);
  Errors why;
  for (const auto& place : placesBeside(here, simcore::extentOf(*model->type).radius)) {
    const robotlink::Pose2 start = robotlink::groundPose(model->poseInWorld);
    robotlink::Pose3 turned =
        robotlink::Pose3(Eigen::AngleAxisd(place.heading - start.heading, robotlink::Vector3::UnitZ())) *
        model->poseInWorld;
    turned.translation() << place.x, place.y, model->poseInWorld.translation().z();
    copy.poseInWorld = turned;
    const auto next = scene->with(copy, scene->world().models.size());
    if (!next) return tl::unexpected(Errors{next.error()});
    auto done = goOnIn(*next, {.fitsNow = true});
    if (done) {
      noteEdit({.kind = Edit::Kind::kAddition, .model = copy.name});
      return copy.name + " was added as a copy of " + name + ".";
    }
    why = std::move(done.error());
    if (why.front().id != "scene.no-room") break;
  }
  return tl::unexpected(std::move(why));
}

tl::expected<std::string, Errors> SimulatedRun::undoEdit() {
  if (edits_.empty())
    return tl::unexpected(
        Errors{{"scene.nothing-to-undo", "nothing was added to the scene or removed from it", {}, {}}});
  const Edit edit = edits_.back();
  if (edit.kind == Edit::Kind::kAddition) {
    if (auto done = takeOut(edit.model); !done) return tl::unexpected(std::move(done.error()));
    edits_.pop_back();
    return edit.model + " was removed again.";
  }
  auto scene = world_->simulation().scene().with(*edit.instance, edit.index);
  if (!scene) return tl::unexpected(Errors{scene.error()});
  const simcore::Continuation how{.fitsNow = true, .motions = {{edit.model, edit.motion}}};
  if (auto done = goOnIn(*scene, how); !done) return tl::unexpected(std::move(done.error()));
  edits_.pop_back();
  return edit.model + " is there again.";
}

std::string SimulatedRun::undoable() const {
  if (edits_.empty()) return {};
  const bool isRemoval = edits_.back().kind == Edit::Kind::kRemoval;
  return (isRemoval ? "the removal of " : "the addition of ") + edits_.back().model;
}

}  // namespace app
