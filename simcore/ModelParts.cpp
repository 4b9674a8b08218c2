// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/ModelParts.h"

#include "robotlink/base/Resources.h"
#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/SdfReader.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/world/RenderSceneBuilder.h"

namespace simcore {

tl::expected<ModelParts, robotlink::Errors> ModelParts::load(const std::string& model,
                                                             std::optional<Rgb> team) {
  robotlink::Errors errors;
  const SdfSpec& spec = SdfSpec::shared();
  // Models are searched for beside a scene, too, so this is the one that the shipped models belong to.
  SceneFiles files(robotlink::resource("scenes") / "scene");
  const auto file = files.addModel(model, spec, errors);
  if (!file || !errors.empty()) return tl::unexpected(std::move(errors));
  const tinyxml2::XMLElement& element = *files.model(*file);
  // Reported first and alone: other problems, such as a color that only worlds have, do not matter
  // then.
  if (childText(element, "robotcontrol:robot").empty() || isTrue(childText(element, "static"))) {
    return tl::unexpected(robotlink::Errors{
        {"scene.no-robot", "'" + model + "' is no robot", {model}, {file->string(), 0, 0}}});
  }
  MeshFiles meshes;
  LeftOuts leftOut;
  const auto type = readSdfModel(element, file->string(), {files, spec, meshes, errors, leftOut});
  if (!type) return tl::unexpected(std::move(errors));
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  ModelParts parts;
  for (const LinkDescription& link : type->links) parts.links.push_back(link.poseInModel);
  for (const JointDescription& joint : type->joints) {
    if (joint.closesCycle) continue;
    const bool hinge = joint.kind == JointDescription::Kind::kHinge;
    parts.joints.push_back({joint.name, joint.parent, joint.child, joint.anchorInModel, joint.axisInModel,
                            hinge ? joint.initialAngle : 0});
  }
  WorldDescription world;
  ModelInstance instance;
  instance.name = model;
  instance.type = type;
  instance.teamColor = team;
  world.models.push_back(std::move(instance));
  parts.shapes = buildRenderScene(world);
  return parts;
}

}  // namespace simcore
