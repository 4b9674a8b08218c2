// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfReader.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <set>
#include <sstream>

#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfDevices.h"
#include "simcore/sdf/SdfElements.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/world/WorldSize.h"

namespace simcore {
using tinyxml2::XMLElement;

namespace {

/// Calls a function that uses libsdformat, and reports its exceptions.
template <typename Read>
void guarded(const SdfContext& context, Read read) {
  try {
    read();
  } catch (const sdf::Exception&) {
    // An assertion, which nothing that was checked should reach; it is no std::exception.
    context.fail(context.root, "scene.sdf", "libsdformat cannot read this, and does not say why");
  } catch (const std::exception& exception) {
    context.fail(context.root, "scene.sdf", std::string("libsdformat cannot read this: ") + exception.what());
  }
}

/// Reports the errors of libsdformat when it reads a tree; returns whether there are none.
bool loadSdf(const sdf::ElementPtr& tree, const SdfContext& context, sdf::Root& root) {
  sdf::ParserConfig config;
  config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  const auto document = std::make_shared<sdf::SDF>();
  document->Root(tree);
  return context.take(root.Load(document, config), nullptr);
}

/// Reads the initial positions of robots that a field defines.
void readHomes(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context) {
  for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName() != "robotcontrol:home") continue;
    HomeDescription home;
    if (child->HasAttribute("team")) home.team = child->Get<std::string>("team");
    std::istringstream(child->Get<std::string>()) >> home.place.x >> home.place.y >> home.place.heading;
    const bool isSound = context.orLeaveOut(child, "<robotcontrol:home>", [&](const SdfContext& own) {
      for (const double at : {home.place.x, home.place.y}) own.within(at, -1000, 1000, "a place", child);
    });
    if (!isSound) continue;
    home.place.heading = robotlink::normalizedAngle(home.place.heading);
    model.homes.push_back(std::move(home));
  }
}

/// Adds the links of a model and of those in it.
void readLinks(const sdf::Model& source, const Pose3& sourceInModel, const std::string& prefix,
               ModelDescription& model, const SdfContext& context) {
  for (std::uint64_t i = 0; i < source.LinkCount(); ++i) {
    const sdf::Link& link = *source.LinkByIndex(i);
    LinkDescription read = readLink(link, context);
    read.name = prefix + read.name;
    read.poseInModel = sourceInModel * read.poseInModel;
    model.links.push_back(std::move(read));
    const std::size_t before = model.sensors.size();
    readSensors(link, static_cast<int>(model.links.size()) - 1, model, context);
    for (std::size_t k = before; k < model.sensors.size(); ++k)
      model.sensors[k].name = prefix + model.sensors[k].name;
  }
  for (std::uint64_t i = 0; i < source.ModelCount(); ++i) {
    const sdf::Model& nested = *source.ModelByIndex(i);
    const Pose3 pose = resolvedPose(nested.SemanticPose(), "__model__", nested.Element(), context);
    if (nested.Element()->HasElement("static") && nested.Static() != context.isStatic)
      context.omit(nested.Element(), "<static> of a model in a model", "the outermost model sets it for all");
    readLinks(nested, sourceInModel * pose, prefix + nested.Name() + "::", model, context);
  }
}

void readAllJoints(const sdf::Model& source, const Pose3& sourceInModel, const std::string& prefix,
                   ModelDescription& model, const SdfContext& context) {
  readJoints(source, sourceInModel, prefix, model, context);
  for (std::uint64_t i = 0; i < source.ModelCount(); ++i) {
    const sdf::Model& nested = *source.ModelByIndex(i);
    ignition::math::Pose3d pose;
    // Problems were reported with the links.
    if (!nested.SemanticPose().Resolve(pose, "__model__").empty()) continue;
    readAllJoints(nested, sourceInModel * toEigen(pose), prefix + nested.Name() + "::", model, context);
  }
}

/// Adds the controllers of a model and of those in it.
void readAllControllers(const sdf::Model& source, const std::string& prefix, ModelDescription& model,
                        const SdfContext& context) {
  readControllers(source.Element(), prefix, model.controllers, context);
  for (std::uint64_t i = 0; i < source.ModelCount(); ++i) {
    const sdf::Model& nested = *source.ModelByIndex(i);
    readAllControllers(nested, prefix + nested.Name() + "::", model, context);
  }
}

/// Sensors of different links may have one name; then those of the links are before it, because paths of
/// ports have only one name.
void separateSensors(ModelDescription& model) {
  std::map<std::string, std::set<int>> links;
  for (const SensorDescription& sensor : model.sensors) links[sensor.name].insert(sensor.link);
  for (SensorDescription& sensor : model.sensors) {
    if (links[sensor.name].size() < 2) continue;
    const std::size_t nested = sensor.name.rfind("::");
    const std::string own = nested == std::string::npos ? sensor.name : sensor.name.substr(nested + 2);
    sensor.name = model.links[static_cast<std::size_t>(sensor.link)].name + "::" + own;
  }
}

ModelDescription readModel(const sdf::Model& source, const SdfContext& context) {
  ModelDescription model;
  const sdf::ElementPtr element = source.Element();
  model.file = element->FilePath();
  model.name = source.Name();
  model.isStatic = context.isStatic;
  model.isBall = element->HasElement("robotcontrol:ball") && element->Get<bool>("robotcontrol:ball");
  if (element->HasElement("robotcontrol:robot"))
    model.robot = element->Get<std::string>("robotcontrol:robot");
  if (element->HasElement("robotcontrol:layout"))
    model.layout = layoutIn(element->Get<std::string>("robotcontrol:layout"), context.file);
  if (element->HasElement("robotcontrol:field"))
    model.field = element->Get<std::string>("robotcontrol:field");
  readHomes(element, model, context);
  readLinks(source, Pose3::Identity(), "", model, context);
  if (model.links.empty()) context.fail(element, "scene.no-link", "the model has no <link>");
  readAllJoints(source, Pose3::Identity(), "", model, context);
  if (!model.links.empty()) orderJoints(model, element, context);
  readDrive(source, model, context);
  readJointSensors(source, model, context);
  separateSensors(model);
  readDoors(source, model, context);
  readGuided(element, model, context);
  readVehicle(source, model, context);
  readWalk(element, model, context);
  readMotion(element, model, context);
  readAllControllers(source, "", model, context);
  return model;
}

sdf::ElementPtr childOf(const sdf::World& world, const char* name) {
  return world.Element()->HasElement(name) ? world.Element()->GetElement(name) : world.Element();
}

void readSurroundings(const sdf::World& world, WorldDescription& result, const SdfContext& context) {
  result.gravity = toEigen(world.Gravity());
  if (!(result.gravity.norm() <= 1000))
    context.fail(childOf(world, "gravity"), "scene.gravity", "gravity must be below 1000 m/s^2");
  if (world.Element()->HasElement("robotcontrol:sleeping"))
    result.sleeps = world.Element()->Get<bool>("robotcontrol:sleeping");
  result.magneticField = toEigen(world.MagneticField());
  if (!(result.magneticField.norm() <= 100))
    context.fail(childOf(world, "magnetic_field"), "scene.magnetic-field",
                 "magnetic_field must be below 100 T");
  result.radiationClasses = readClasses(world.Element(), context);
  readControllers(world.Element(), "", result.controllers, context);
  if (world.Element()->HasElement("robotcontrol:game")) {
    result.game = world.Element()->Get<std::string>("robotcontrol:game");
    result.gameWhere = context.placeOf(world.Element()->GetElement("robotcontrol:game"));
  }
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255.F));
  };
  if (const sdf::Scene* scene = world.Scene()) {
    const auto ambient = scene->Ambient();
    result.ambient = std::clamp(ambient.R(), 0.F, 1.F);
    if (ambient.G() != ambient.R() || ambient.B() != ambient.R())
      context.omit(scene->Element(), "the color of <ambient>", "its red channel is the ambient light");
    result.background = {byte(scene->Background().R()), byte(scene->Background().G()),
                         byte(scene->Background().B())};
  }
}

}  // namespace

Pose3 poseFromNumbers(const std::array<double, 6>& numbers) {
  return toEigen(
      ignition::math::Pose3d(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]));
}

namespace {

bool isStaticModel(const XMLElement& model) {
  return isTrue(childText(model, "static"));
}

/// A joint in the world, or a frame to which something is relative, connects models.
bool connectsModels(const XMLElement& world) {
  for (auto* child = world.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const XMLElement* pose = child->FirstChildElement("pose");
    const std::string_view name = child->Name();
    if (name == "joint" || child->FirstChildElement("placement_frame") != nullptr ||
        child->Attribute("placement_frame") != nullptr || child->Attribute("attached_to") != nullptr) {
      return true;
    }
    const char* frame = pose != nullptr ? pose->Attribute("relative_to") : nullptr;
    if (frame != nullptr && *frame != '\0' && std::string_view(frame) != "world") return true;
  }
  return false;
}

ModelInstance instanceOf(const std::string& name, const XMLElement& element, const std::string& file) {
  ModelInstance instance;
  instance.name = name;
  instance.where = {file, sourceLine(element), 0};
  return instance;
}

Pose3 checkedPose(const Pose3& pose, const XMLElement& element, const std::string& file,
                  robotlink::Errors& errors) {
  if (pose.matrix().allFinite() && pose.translation().norm() <= 1e5) return pose;
  errors.push_back({"scene.pose",
                    objectPath(element) + ": a pose must be finite and at most 100 km away",
                    {},
                    {file, sourceLine(element), 0}});
  return Pose3::Identity();
}

/// The models of a world whose poses do not depend on each other, one by one.
void readSeparately(const XMLElement& world, const SdfSources& sources, WorldDescription& result) {
  const std::string file = sources.files.file().string();
  std::size_t parts = 0;
  // With too many, Scene::load() fails anyway.
  for (auto* model = world.FirstChildElement("model"); model != nullptr && parts <= kMaxWorldParts;
       model = model->NextSiblingElement("model")) {
    ModelInstance instance = instanceOf(nameOf(*model), *model, file);
    instance.type = readSdfModel(*model, file, sources);
    if (!instance.type) continue;
    parts += partCount(*instance.type);
    instance.poseInWorld = checkedPose(ownPoseOf(*model), *model, file, sources.errors);
    result.models.push_back(std::move(instance));
  }
}

/// The models of a whole world that libsdformat has read.
void readTogether(const sdf::World& world, const SdfContext& context, WorldDescription& result) {
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
    const sdf::Model& model = *world.ModelByIndex(i);
    SdfContext own = context;
    own.isStatic = model.Static();
    ModelInstance instance;
    instance.name = model.Name();
    instance.where = {context.file, model.Element()->LineNumber().value_or(1), 0};
    instance.poseInWorld = resolvedPose(model.SemanticPose(), "", model.Element(), own);
    instance.type = std::make_shared<ModelDescription>(readModel(model, own));
    result.models.push_back(std::move(instance));
  }
}

}  // namespace

Pose3 ownPoseOf(const XMLElement& model) {
  const XMLElement* pose = model.FirstChildElement("pose");
  const auto numbers = pose != nullptr ? poseIn(*pose) : std::nullopt;
  return numbers ? poseFromNumbers(*numbers) : Pose3::Identity();
}

std::shared_ptr<const ModelDescription> readSdfModel(const XMLElement& model, const std::string& file,
                                                     const SdfSources& sources,
                                                     std::optional<bool> isStatic) {
  const std::size_t before = sources.errors.size();
  const sdf::ElementPtr tree =
      SdfElements(sources.files, sources.spec, sources.errors).modelRoot(model, file);
  const SdfContext context{file,
                           tree,
                           sources.files.palette(),
                           sources.errors,
                           sources.leftOut,
                           sources.meshes,
                           sources.files.search(),
                           isStatic.value_or(isStaticModel(model))};
  if (sources.errors.size() > before) return nullptr;
  std::shared_ptr<const ModelDescription> result;
  guarded(context, [&] {
    sdf::Root root;
    if (!loadSdf(tree, context, root)) return;
    if (root.Model() == nullptr) return context.fail(tree, "scene.no-model", "the file describes no model");
    result = std::make_shared<ModelDescription>(readModel(*root.Model(), context));
  });
  return sources.errors.size() > before ? nullptr : result;
}

WorldDescription readSdfWorld(const SdfSources& sources, bool& includesRead) {
  WorldDescription result;
  const std::string file = sources.files.file().string();
  const XMLElement& source = *sources.files.world();
  includesRead = connectsModels(source);
  const sdf::ElementPtr tree =
      SdfElements(sources.files, sources.spec, sources.errors).worldRoot(source, file, includesRead);
  const SdfContext context{file,
                           tree,
                           sources.files.palette(),
                           sources.errors,
                           sources.leftOut,
                           sources.meshes,
                           sources.files.search()};
  guarded(context, [&] {
    sdf::Root root;
    if (!loadSdf(tree, context, root) || root.WorldCount() != 1) return;
    const sdf::World& world = *root.WorldByIndex(0);
    result.name = world.Name();
    readSurroundings(world, result, context);
    readLamps(world, result, context);
    if (includesRead) readTogether(world, context, result);
  });
  if (!includesRead) readSeparately(source, sources, result);
  if (const XMLElement* joint = source.FirstChildElement("joint")) {
    leaveOut(sources.leftOut, {{file, sourceLine(*joint), 0},
                               objectPath(source),
                               "<joint> in <world>",
                               "joints connect links of one model"});
  }
  return result;
}

}  // namespace simcore
