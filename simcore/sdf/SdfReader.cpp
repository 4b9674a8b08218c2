// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfReader.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "simcore/sdf/SdfConversion.h"
#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfSpec.h"

namespace simcore {
namespace {

sdf::ParserConfig parserConfig() {
  sdf::ParserConfig config;
  // Warnings of libsdformat become errors here rather than output on the terminal.
  config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::ERR);
  return config;
}

/// Parses a text into `root`; returns false, after adding errors, if that fails.
bool loadSdf(const std::string& text, const SdfSpec& spec, const SdfContext& context, sdf::Root& root) {
  const auto document = std::make_shared<sdf::SDF>();
  document->Root(spec.description().text->Root()->Clone());
  sdf::Errors found;
  const bool readable = sdf::readString(text, parserConfig(), document, found);
  if (!context.take(found, nullptr)) return false;
  if (!readable) {
    context.fail(nullptr, "scene.sdf", "libsdformat cannot read this file");
    return false;
  }
  return context.take(root.Load(document, parserConfig()), nullptr);
}

int linkIndex(const ModelDescription& model, const std::string& name) {
  const auto found = std::ranges::find(model.links, name, &LinkDescription::name);
  return found == model.links.end() ? -1 : static_cast<int>(found - model.links.begin());
}

void readServo(const sdf::JointAxis& axis, const sdf::ElementPtr& element, JointDescription& result,
               const SdfContext& context) {
  const sdf::ElementPtr servo = element->GetElement("robotcontrol:servo");
  result.servo = true;
  // Without limits, SDFormat has infinite values, which no servo has.
  result.maximumSpeed = context.within(axis.MaxVelocity(), 1e-6, 1000, "a servo's <velocity>", element);
  result.maximumTorque = context.within(axis.Effort(), 1e-9, 1000, "a servo's <effort>", element);
  const auto number = [&](const char* key) { return servo->HasElement(key) ? servo->Get<double>(key) : 0.0; };
  result.initialAngle = context.within(number("robotcontrol:initial_position"), result.lower, result.upper,
                                       "initial_position of '" + result.name + "'", servo);
  result.positionNoise = context.within(number("robotcontrol:position_noise"), 0, 1, "position_noise", servo);
}

void readHinge(const sdf::Joint& joint, JointDescription& result, const SdfContext& context) {
  const sdf::JointAxis& axis = *joint.Axis(0);
  ignition::math::Vector3d direction;
  context.take(axis.ResolveXyz(direction, "__model__"), joint.Element());
  result.axisInModel = toEigen(direction).normalized();
  if (!result.axisInModel.allFinite())
    context.fail(joint.Element(), "scene.axis", "an axis must be a finite vector");
  constexpr double kFullTurn = 2 * robotlink::kPi;
  const bool limited = joint.Type() == sdf::JointType::REVOLUTE && axis.Upper() < 1e15;
  result.lower =
      limited ? context.within(axis.Lower(), -kFullTurn, kFullTurn, "lower", joint.Element()) : -kFullTurn;
  result.upper =
      limited ? context.within(axis.Upper(), result.lower, kFullTurn, "upper", joint.Element()) : kFullTurn;
  if (joint.Element()->HasElement("robotcontrol:servo")) readServo(axis, joint.Element(), result, context);
}

JointDescription readJoint(const sdf::Joint& joint, const ModelDescription& model,
                           const SdfContext& context) {
  JointDescription result;
  result.name = joint.Name();
  std::string parent, child;
  context.take(joint.ResolveParentLink(parent), joint.Element());
  context.take(joint.ResolveChildLink(child), joint.Element());
  result.parent = linkIndex(model, parent);
  result.child = linkIndex(model, child);
  if (result.child < 0 || (result.parent < 0 && parent != "world")) {
    context.fail(joint.Element(), "scene.joint", "the joint '" + joint.Name() + "' does not join two links");
    result.child = 0;
  }
  result.anchorInModel =
      resolvedPose(joint.SemanticPose(), "__model__", joint.Element(), context).translation();
  if (joint.Type() == sdf::JointType::FIXED) {
    result.fixed = true;
  } else if ((joint.Type() == sdf::JointType::REVOLUTE || joint.Type() == sdf::JointType::CONTINUOUS) &&
             joint.Axis(0) != nullptr) {
    readHinge(joint, result, context);
  } else {
    context.fail(joint.Element(), "scene.joint-type",
                 "of joints, only revolute, continuous and fixed ones are known");
  }
  return result;
}

/// Sorts joints from parents to children, so each link must have at most one parent, and there must be no
/// cycles.
void orderJoints(ModelDescription& model, const sdf::ElementPtr& element, const SdfContext& context) {
  std::vector<JointDescription> ordered, waiting = std::move(model.joints);
  std::vector<bool> placed(model.links.size(), true);
  for (const JointDescription& joint : waiting) placed[static_cast<std::size_t>(joint.child)] = false;
  bool progress = true;
  while (progress && !waiting.empty()) {
    progress = false;
    for (auto joint = waiting.begin(); joint != waiting.end(); ++joint) {
      const bool ready = joint->parent < 0 || placed[static_cast<std::size_t>(joint->parent)];
      if (!ready || placed[static_cast<std::size_t>(joint->child)]) continue;
      placed[static_cast<std::size_t>(joint->child)] = true;
      ordered.push_back(*joint);
      waiting.erase(joint);
      progress = true;
      break;
    }
  }
  if (!waiting.empty()) {
    context.fail(element, "scene.joint-cycle",
                 "the joint '" + waiting.front().name + "' closes a cycle or gives a link a second parent");
  }
  model.joints = std::move(ordered);
}

/// Reads the initial positions of robots that a field defines.
void readHomes(const sdf::ElementPtr& element, ModelDescription& model, const SdfContext& context) {
  for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
    if (child->GetName() != "robotcontrol:home") continue;
    HomeDescription home;
    if (child->HasAttribute("team")) home.team = child->Get<std::string>("team");
    std::istringstream(child->Get<std::string>()) >> home.place.x >> home.place.y >> home.place.heading;
    home.place.x = context.within(home.place.x, -1000, 1000, "a place", child);
    home.place.y = context.within(home.place.y, -1000, 1000, "a place", child);
    home.place.heading = robotlink::normalizedAngle(home.place.heading);
    model.homes.push_back(std::move(home));
  }
}

ModelDescription readModel(const sdf::Model& source, const SdfContext& context) {
  ModelDescription model;
  const sdf::ElementPtr element = source.Element();
  model.file = context.file;
  model.name = source.Name();
  model.isStatic = source.Static();
  model.isBall = element->HasElement("robotcontrol:ball") && element->Get<bool>("robotcontrol:ball");
  if (element->HasElement("robotcontrol:robot"))
    model.robot = element->Get<std::string>("robotcontrol:robot");
  if (element->HasElement("robotcontrol:field"))
    model.field = element->Get<std::string>("robotcontrol:field");
  readHomes(element, model, context);
  if (source.ModelCount() > 0) {
    context.fail(element, "scene.nested", "models inside models are not known");
  }
  for (std::uint64_t i = 0; i < source.LinkCount(); ++i) {
    model.links.push_back(readLink(*source.LinkByIndex(i), context));
    readSensors(*source.LinkByIndex(i), static_cast<int>(i), model, context);
  }
  for (std::uint64_t i = 0; i < source.JointCount(); ++i) {
    model.joints.push_back(readJoint(*source.JointByIndex(i), model, context));
  }
  if (!model.links.empty()) orderJoints(model, element, context);
  readDrive(source, model, context);
  return model;
}

void readLamps(const sdf::World& world, WorldDescription& result, const SdfContext& context) {
  for (std::uint64_t i = 0; i < world.LightCount(); ++i) {
    const sdf::Light& light = *world.LightByIndex(i);
    if (light.Type() != sdf::LightType::POINT) {
      context.fail(light.Element(), "scene.light", "of lights, only point lights are known");
      continue;
    }
    const Pose3 pose = resolvedPose(light.SemanticPose(), "", light.Element(), context);
    Lamp lamp;
    lamp.position = pose.translation().cast<float>();
    lamp.intensity =
        static_cast<float>(context.within(light.Intensity(), 0, 100, "a light's intensity", light.Element()));
    lamp.attenuation = static_cast<float>(context.within(light.QuadraticAttenuationFactor(), 0, 1000,
                                                         "a light's attenuation", light.Element()));
    result.lamps.push_back(lamp);
  }
}

void readSurroundings(const sdf::World& world, WorldDescription& result, const SdfContext& context) {
  result.gravity = toEigen(world.Gravity());
  if (!(result.gravity.norm() <= 1000))
    context.fail(world.Element(), "scene.gravity", "gravity must be below 1000 m/s^2");
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.F, 1.F) * 255.F));
  };
  if (const sdf::Scene* scene = world.Scene()) {
    result.ambient = std::clamp(scene->Ambient().R(), 0.F, 1.F);
    result.background = {byte(scene->Background().R()), byte(scene->Background().G()),
                         byte(scene->Background().B())};
  }
}

}  // namespace

Pose3 poseFromNumbers(const double (&numbers)[6]) {
  return toEigen(
      ignition::math::Pose3d(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5]));
}

std::shared_ptr<const ModelDescription> readSdfModel(const std::string& text, const std::string& file,
                                                     const Palette& palette, const SdfSpec& spec,
                                                     robotlink::Errors& errors) {
  const SdfContext context{file, text, palette, errors};
  sdf::Root root;
  if (!loadSdf(text, spec, context, root)) return nullptr;
  if (root.Model() == nullptr) {
    context.fail(root.Element(), "scene.no-model", "the file describes no model");
    return nullptr;
  }
  return std::make_shared<ModelDescription>(readModel(*root.Model(), context));
}

WorldDescription readSdfWorld(const std::string& text, const std::string& file, const Palette& palette,
                              const SdfSpec& spec, robotlink::Errors& errors) {
  const SdfContext context{file, text, palette, errors};
  WorldDescription result;
  sdf::Root root;
  if (!loadSdf(text, spec, context, root)) return result;
  if (root.WorldCount() != 1) {
    context.fail(root.Element(), "scene.no-world", "the file must describe one world");
    return result;
  }
  const sdf::World& world = *root.WorldByIndex(0);
  result.name = world.Name();
  readSurroundings(world, result, context);
  readLamps(world, result, context);
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
    const sdf::Model& model = *world.ModelByIndex(i);
    ModelInstance instance;
    instance.name = model.Name();
    instance.where = {file, model.Element()->LineNumber().value_or(1), 0};
    instance.poseInWorld = resolvedPose(model.SemanticPose(), "", model.Element(), context);
    instance.type = std::make_shared<ModelDescription>(readModel(model, context));
    result.models.push_back(std::move(instance));
  }
  return result;
}

}  // namespace simcore
