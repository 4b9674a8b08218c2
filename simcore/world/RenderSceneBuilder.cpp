// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/world/RenderSceneBuilder.h"

#include <algorithm>
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
    addClasses(world);
    for (const ModelInstance& model : world.models) add(model);
    label();
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
      for (const Emitter& emitter : link.emitters) {
        scene_->radiation.emitters.push_back(
            {body, linkInBody * emitter.positionInLink, emitter.attenuation, byClass(emitter.classes)});
      }
      for (const VisualDescription& visual : link.visuals) {
        addSurface(visual);
        const bool ofTeam = visual.teamColor && model.teamColor;
        scene_->instances.push_back({meshIndex(visual.shape), body, linkInBody * visual.poseInLink,
                                     ofTeam ? *model.teamColor : visual.color, name + "/" + visual.name,
                                     visual.castsShadow, ofTeam ? model.teamColorName : visual.colorName});
      }
    }
  }

  void addClasses(const WorldDescription& world) {
    SceneRadiation& radiation = scene_->radiation;
    for (const RadiationClass& each : world.radiationClasses) {
      radiation.classes.push_back(each.name);
      radiation.ambient.push_back(static_cast<float>(each.ambient));
    }
    addNamedClasses(world);
    for (std::size_t i = 0; i < world.lamps.size() && i < world.lampRadiation.size(); ++i) {
      const Lamp& lamp = world.lamps[i];
      if (world.lampRadiation[i].empty()) continue;
      radiation.emitters.push_back({0, placeOf(lamp).cast<double>(), lamp.attenuation,
                                    byClass(world.lampRadiation[i]), static_cast<int>(i)});
    }
  }

  /// Adds the classes that something emits or reflects, but that are not declared.
  void addNamedClasses(const WorldDescription& world) {
    SceneRadiation& radiation = scene_->radiation;
    const auto addAll = [&](const auto& named) {
      for (const auto& each : named) {
        if (std::ranges::find(radiation.classes, each.name) == radiation.classes.end())
          radiation.classes.push_back(each.name);
      }
    };
    for (const auto& lamp : world.lampRadiation) addAll(lamp);
    for (const ModelInstance& model : world.models) {
      for (const LinkDescription& link : model.type->links) {
        for (const Emitter& emitter : link.emitters) addAll(emitter.classes);
        for (const VisualDescription& visual : link.visuals) addAll(visual.radiation);
      }
    }
    radiation.ambient.resize(radiation.classes.size());
  }

  std::ptrdiff_t classOf(const std::string& name) const {
    const auto& names = scene_->radiation.classes;
    return std::ranges::find(names, name) - names.begin();
  }

  std::vector<float> byClass(const std::vector<ClassIntensity>& intensities) const {
    std::vector<float> result(scene_->radiation.classes.size());
    for (const ClassIntensity& each : intensities) {
      const auto index = static_cast<std::size_t>(classOf(each.name));
      if (index < result.size()) result[index] = static_cast<float>(each.intensity);
    }
    return result;
  }

  void addSurface(const VisualDescription& visual) {
    std::vector<SceneRadiation::Surface> surface(scene_->radiation.classes.size());
    for (const SurfaceRadiation& each : visual.radiation) {
      const auto index = static_cast<std::size_t>(classOf(each.name));
      if (index >= surface.size()) continue;
      surface[index] = {static_cast<float>(each.reflects), static_cast<float>(each.emits), true};
    }
    scene_->radiation.surfaces.push_back(std::move(surface));
  }

  /// Numbers the names of colors.
  void label() {
    auto& names = scene_->labelNames;
    for (const RenderInstance& instance : scene_->instances) {
      if (!instance.colorName.empty()) names.push_back(instance.colorName);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    for (const RenderInstance& instance : scene_->instances) {
      const auto found = std::ranges::find(names, instance.colorName);
      scene_->labels.push_back(found == names.end() ? 0
                                                    : static_cast<std::uint16_t>(found - names.begin() + 1));
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
