// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/ranging/RadiationLight.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

/// A class that is derived from colors, with the coefficients of robotlink::toYCbCr.
struct DerivedClass {
  const char* name;
  float red, green, blue, offset;
};

constexpr DerivedClass kDerived[] = {{"Y", 0.299F, 0.587F, 0.114F, 0},
                                     {"Cb", -0.168736F, -0.331264F, 0.5F, 128},
                                     {"Cr", 0.5F, -0.418688F, -0.081312F, 128},
                                     {"R", 1, 0, 0, 0},
                                     {"G", 0, 1, 0, 0},
                                     {"B", 0, 0, 1, 0}};

// A shadow ray ends that much of its length before the surface, as those of CameraRenderer do.
constexpr float kShadowEnd = 0.9998F;
// The same for directional lamps, whose shadow rays are longer.
constexpr float kFarShadowEnd = 0.99999F;

Eigen::Vector3f vectorOf(Rgb color) {
  return {static_cast<float>(color.r), static_cast<float>(color.g), static_cast<float>(color.b)};
}

}  // namespace

RadiationLight::RadiationLight(std::shared_ptr<const RenderScene> scene)
    : scene_(std::move(scene)), tree_(*scene_) {}

void RadiationLight::setPoses(std::span<const Pose3> bodyInWorld) {
  poses_ = bodyInWorld;
  tree_.setPoses(bodyInWorld);
  shadows_ = tree_.scene();
  sources_.clear();
  for (const Lamp& lamp : scene_->lamps)
    sources_.push_back({placeOf(lamp), lamp.attenuation, lamp.intensity * lamp.color, nullptr, &lamp});
  for (const PlacedEmitter& emitter : scene_->radiation.emitters) {
    const Eigen::Vector3d position = poses_[static_cast<std::size_t>(emitter.body)] * emitter.positionInBody;
    const Lamp* lamp = emitter.lamp < 0 ? nullptr : &scene_->lamps[static_cast<std::size_t>(emitter.lamp)];
    sources_.push_back({position.cast<float>(), static_cast<float>(emitter.attenuation),
                        Eigen::Vector3f::Zero(), &emitter.intensities, lamp});
  }
  arriving_.resize(sources_.size());
}

RadiationLight::Sensed RadiationLight::sensedClass(const std::string& name) const {
  Sensed sensed;
  for (const DerivedClass& each : kDerived) {
    if (name != each.name) continue;
    sensed.color = {each.red, each.green, each.blue};
    sensed.offset = each.offset;
    sensed.derived = true;
  }
  const auto& declared = scene_->radiation.classes;
  const auto found = std::ranges::find(declared, name);
  if (found != declared.end()) sensed.declared = static_cast<int>(found - declared.begin());
  return sensed;
}

RadiationLight::Point RadiationLight::pointOf(const BundleHit& hit, const Eigen::Vector3d& direction,
                                              const Pose3& frame) const {
  const RenderInstance& instance = scene_->instances[static_cast<std::size_t>(hit.instance)];
  const Mesh& mesh = scene_->meshes[static_cast<std::size_t>(instance.mesh)];
  const auto& triangle = mesh.triangles[hit.triangle];
  const Eigen::Vector3f normal = (1 - hit.u - hit.v) * mesh.normals[triangle[0]] +
                                 hit.u * mesh.normals[triangle[1]] + hit.v * mesh.normals[triangle[2]];
  const Pose3 meshInWorld = poses_[static_cast<std::size_t>(instance.body)] * instance.meshInBody;
  const Eigen::Vector3d along = frame.linear() * direction;
  Eigen::Vector3d outward = (meshInWorld.linear() * normal.cast<double>()).normalized();
  // Surfaces are seen from either side.
  if (outward.dot(along) > 0) outward = -outward;
  return {(frame.translation() + static_cast<double>(hit.distance) * along).cast<float>(),
          outward.cast<float>()};
}

bool RadiationLight::isVisible(const Source& source, const Eigen::Vector3f& point) const {
  const Eigen::Vector3f& from = source.position;
  RTCRay ray{};
  const Eigen::Vector3f way = point - from;
  ray.org_x = from.x();
  ray.org_y = from.y();
  ray.org_z = from.z();
  ray.dir_x = way.x();
  ray.dir_y = way.y();
  ray.dir_z = way.z();
  const bool isFar = source.lamp != nullptr && source.lamp->kind == Lamp::Kind::kDirectional;
  ray.tfar = isFar ? kFarShadowEnd : kShadowEnd;
  ray.mask = ~0U;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(shadows_, &context, &ray);
  return ray.tfar >= 0;
}

void RadiationLight::light(const Point& point) {
  brightness_.setConstant(scene_->ambient);
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const Source& source = sources_[i];
    arriving_[i] = 0;
    const Eigen::Vector3f toSource = source.position - point.position;
    const float squared = toSource.squaredNorm();
    const float cosine = toSource.dot(point.normal) / std::sqrt(std::max(squared, 1e-12F));
    const float share = source.lamp == nullptr ? 1 : shareTowards(*source.lamp, -toSource);
    if (cosine <= 0 || share <= 0 || !isVisible(source, point.position)) continue;
    arriving_[i] = share * cosine / (1 + squared * source.attenuation);
    brightness_ += arriving_[i] * source.intensity;
  }
  brightness_ /= std::max(brightness_.maxCoeff(), 1.F);
}

float RadiationLight::valueOf(const Sensed& sensed, const RenderInstance* instance, std::size_t index) const {
  const SceneRadiation& radiation = scene_->radiation;
  if (sensed.declared >= 0) {
    const auto of = static_cast<std::size_t>(sensed.declared);
    if (instance == nullptr && !sensed.derived) return radiation.ambient[of];
    const SceneRadiation::Surface surface = instance != nullptr && index < radiation.surfaces.size()
                                                ? radiation.surfaces[index][of]
                                                : SceneRadiation::Surface{};
    if (!sensed.derived || surface.stated) {
      float sum = radiation.ambient[of];
      for (std::size_t i = 0; i < sources_.size(); ++i) {
        if (sources_[i].intensities != nullptr) sum += arriving_[i] * (*sources_[i].intensities)[of];
      }
      return surface.emits + surface.reflects * sum;
    }
  }
  if (instance == nullptr) return sensed.offset + sensed.color.dot(vectorOf(scene_->background));
  return sensed.offset + sensed.color.dot(brightness_.cwiseProduct(vectorOf(instance->color)));
}

void RadiationLight::shade(const RayBundle& rays, std::span<const BundleHit> hits, const Pose3& frameInWorld,
                           const std::vector<std::string>& classes, std::span<float> values) {
  std::vector<Sensed> sensed;
  for (const std::string& name : classes) sensed.push_back(sensedClass(name));
  directions_.resize(rays.size());
  for (const RayBundle::Packet& packet : rays.packets()) {
    for (std::size_t lane = 0; static_cast<int>(lane) < packet.count; ++lane) {
      const auto& d = packet.direction;
      directions_[static_cast<std::size_t>(packet.ray[lane])] =
          Eigen::Vector3f(d[0][lane], d[1][lane], d[2][lane]).cast<double>();
    }
  }
  auto out = values.begin();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const RenderInstance* instance = nullptr;
    const auto index = static_cast<std::size_t>(std::max(hits[i].instance, 0));
    if (hits[i].instance >= 0) {
      instance = &scene_->instances[index];
      light(pointOf(hits[i], directions_[i], frameInWorld));
    }
    for (const Sensed& each : sensed) *out++ = valueOf(each, instance, index);
  }
}

}  // namespace simcore
