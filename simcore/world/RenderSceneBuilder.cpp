// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/RenderSceneBuilder.h"

#include <map>
#include <tuple>

namespace simcore {
namespace {

/// The properties that determine a mesh, so that equal ones are shared.
using MeshKey = std::tuple<Shape::Kind, double, double, double, double, double, const Mesh*>;

MeshKey keyOf(const Shape& shape) {
  return {shape.kind,   shape.size.x(), shape.size.y(),  shape.size.z(),
          shape.radius, shape.length,   shape.mesh.get()};
}

Mesh planeMesh(const Vector3& size) {
  const auto x = static_cast<float>(size.x() / 2), y = static_cast<float>(size.y() / 2);
  Mesh mesh;
  mesh.vertices = {{-x, -y, 0}, {x, -y, 0}, {x, y, 0}, {-x, y, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh makeMesh(const Shape& shape) {
  const auto radius = static_cast<float>(shape.radius), length = static_cast<float>(shape.length);
  switch (shape.kind) {
    case Shape::Kind::kBox:
      return boxMesh(shape.size.cast<float>());
    case Shape::Kind::kSphere:
      return sphereMesh(radius);
    case Shape::Kind::kCylinder:
      return cylinderMesh(radius, length);
    case Shape::Kind::kCapsule:
      return capsuleMesh(radius, length);
    case Shape::Kind::kPlane:
      return planeMesh(shape.size);
    case Shape::Kind::kMesh:
      return *shape.mesh;
  }
  return {};
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const WorldDescription& world) {
    scene_->ambient = world.ambient;
    scene_->background = world.background;
    scene_->lamps = world.lamps;
    scene_->bodies = {"world"};
    for (const ModelInstance& model : world.models) add(model);
  }
  std::shared_ptr<const RenderScene> scene() const { return scene_; }

 private:
  void add(const ModelInstance& model) {
    for (const LinkDescription& link : model.type->links) {
      const std::string name = model.name + "/" + link.name;
      Pose3 linkInBody = Pose3::Identity();
      int body = 0;
      if (model.type->isStatic) {
        linkInBody = model.poseInWorld * link.poseInModel;
      } else {
        body = static_cast<int>(scene_->bodies.size());
        scene_->bodies.push_back(name);
      }
      for (const VisualDescription& visual : link.visuals) {
        const bool ofTeam = visual.teamColor && model.teamColor;
        scene_->instances.push_back({meshIndex(visual.shape), body, linkInBody * visual.poseInLink,
                                     ofTeam ? *model.teamColor : visual.color, name + "/" + visual.name,
                                     visual.castsShadow, ofTeam ? model.teamColorName : visual.colorName});
      }
    }
  }

  int meshIndex(const Shape& shape) {
    const auto [entry, isNew] = meshes_.try_emplace(keyOf(shape), static_cast<int>(scene_->meshes.size()));
    if (isNew) scene_->meshes.push_back(makeMesh(shape));
    return entry->second;
  }

  std::shared_ptr<RenderScene> scene_ = std::make_shared<RenderScene>();
  std::map<MeshKey, int> meshes_;
};

}  // namespace

std::shared_ptr<const RenderScene> buildRenderScene(const WorldDescription& world) {
  return SceneBuilder(world).scene();
}

}  // namespace simcore
