// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/RayCaster.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/BundleTracing.h"
#include "simcore/rendering/DrawableMesh.h"
#include "simcore/rendering/FanTracing.h"

namespace simcore {
namespace {

/// A body with at least one triangle.
struct Target {
  int body = 0;
  RTCScene tree = nullptr;
  // In the body's frame.
  rendering::Sphere bound;
  Pose3 pose = Pose3::Identity();
  // Center of the bound in the world.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  // The instance of each geometry of the tree.
  std::vector<std::int32_t> instances;
};

/// The instances of a body that are in its tree, in the order of its geometries.
std::vector<std::int32_t> instancesOf(const RenderScene& scene, int body) {
  std::vector<std::int32_t> result;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const RenderInstance& instance = scene.instances[i];
    const bool drawn = !scene.meshes[static_cast<std::size_t>(instance.mesh)].triangles.empty();
    if (instance.body == body && drawn) result.push_back(static_cast<std::int32_t>(i));
  }
  return result;
}

rendering::Sphere boundOf(RTCScene tree) {
  RTCBounds box;
  rtcGetSceneBounds(tree, &box);
  const Eigen::Vector3d low(box.lower_x, box.lower_y, box.lower_z),
      high(box.upper_x, box.upper_y, box.upper_z);
  return {(low + high) / 2, (high - low).norm() / 2 * (1 + 1e-6)};
}

/// Whether a ray of unit direction meets a sphere before `farthest`.
bool meets(const Eigen::Vector3d& toCenter, const Eigen::Vector3d& direction, double radius,
           double farthest) {
  const double along = toCenter.dot(direction);
  const double across = toCenter.squaredNorm() - along * along;
  if (across > radius * radius) return false;
  const double half = std::sqrt(radius * radius - across);
  return along + half >= 0 && along - half <= farthest;
}

void trace(const Target& target, const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
           RayCaster::Hit& nearest) {
  const Eigen::Vector3d from = target.pose.inverse(Eigen::Isometry) * origin;
  const Eigen::Vector3d along = target.pose.linear().transpose() * direction;
  RTCRayHit hit{};
  hit.ray.org_x = static_cast<float>(from.x());
  hit.ray.org_y = static_cast<float>(from.y());
  hit.ray.org_z = static_cast<float>(from.z());
  hit.ray.dir_x = static_cast<float>(along.x());
  hit.ray.dir_y = static_cast<float>(along.y());
  hit.ray.dir_z = static_cast<float>(along.z());
  hit.ray.tfar = static_cast<float>(nearest.distance);
  hit.ray.mask = ~0U;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(target.tree, &context, &hit);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
  nearest = {static_cast<double>(hit.ray.tfar), target.body};
}

}  // namespace

class RayCaster::Implementation {
 public:
  explicit Implementation(const RenderScene& scene) : device_(rendering::newRayDevice()) {
    rendering::BodyTrees trees(device_, scene, rendering::Contents::kEverything);
    for (int body = 0; body < rendering::bodyCount(scene); ++body) {
      const RTCScene tree = trees.treeOf(body);
      if (tree == nullptr) continue;
      const rendering::Sphere bound = boundOf(tree);
      targets_.push_back({body, tree, bound, Pose3::Identity(), bound.center, instancesOf(scene, body)});
    }
    rememberReaches();
  }
  ~Implementation() {
    for (const Target& target : targets_) rtcReleaseScene(target.tree);
    rtcReleaseDevice(device_);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void setPoses(std::span<const Pose3> bodyInWorld) {
    for (Target& target : targets_) {
      const auto body = static_cast<std::size_t>(target.body);
      if (body == 0 || body >= bodyInWorld.size()) continue;
      target.pose = bodyInWorld[body];
      target.center = target.pose * target.bound.center;
    }
    rememberReaches();
  }

  std::optional<Hit> firstHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction, double maximum,
                              std::span<const int> excluded) const {
    Hit nearest{maximum, -1};
    for (const Target& target : targets_) {
      if (!meets(target.center - origin, direction, target.bound.radius, nearest.distance)) continue;
      if (std::find(excluded.begin(), excluded.end(), target.body) != excluded.end()) continue;
      trace(target, origin, direction, nearest);
    }
    return nearest.body < 0 ? std::nullopt : std::optional(nearest);
  }

  void castFan(const RayFan& fan, const Pose3& frameInWorld, double maximum, BodyRange excluded,
               std::span<FanHit> hits) const {
    std::ranges::fill(hits, FanHit{maximum, 1});
    rendering::FanView view(fan, frameInWorld);
    // The world comes first, because it hides most bodies. Most bodies are too far away and are skipped
    // quickly.
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      if (!view.mayMeet(reaches_[i], maximum)) continue;
      const Target& target = targets_[i];
      if (target.body >= excluded.first && target.body < excluded.last) continue;
      if (!view.look(reaches_[i])) continue;
      const rendering::LocalFan local(fan, target.pose.inverse(Eigen::Isometry) * frameInWorld);
      view.forRays([&](int first, int last) {
        rendering::traceFan(target.tree, local, first, last, view.nearest(), hits);
      });
    }
  }

  void castBundle(const RayBundle& bundle, const Pose3& frameInWorld, double maximum, BodyRange excluded,
                  std::span<BundleHit> hits) const {
    std::vector<rendering::BundleTarget> targets;
    targets.reserve(targets_.size());
    const Eigen::Vector3d origin = frameInWorld.translation();
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const Target& target = targets_[i];
      const Eigen::Vector3d away = reaches_[i].center - origin;
      const double farthest = maximum + reaches_[i].radius;
      if (away.squaredNorm() > farthest * farthest) continue;
      if (target.body >= excluded.first && target.body < excluded.last) continue;
      targets.emplace_back(target.tree, frameInWorld.linear().transpose() * away, reaches_[i].radius,
                           target.pose, frameInWorld, target.instances);
    }
    rendering::traceBundle(bundle, targets, static_cast<float>(maximum), hits);
  }

 private:
  void rememberReaches() {
    reaches_.clear();
    for (const Target& target : targets_) reaches_.push_back({target.center, target.bound.radius});
  }

  RTCDevice device_;
  std::vector<Target> targets_;
  // The targets' bounds in the world, contiguous in memory.
  std::vector<rendering::Sphere> reaches_;
};

RayCaster::RayCaster(const std::shared_ptr<const RenderScene>& scene)
    : implementation_(std::make_unique<Implementation>(*scene)) {}
RayCaster::~RayCaster() = default;

void RayCaster::setPoses(std::span<const Pose3> bodyInWorld) {
  implementation_->setPoses(bodyInWorld);
}

std::optional<RayCaster::Hit> RayCaster::firstHit(const Eigen::Vector3d& origin,
                                                  const Eigen::Vector3d& direction, double maximum,
                                                  std::span<const int> excluded) const {
  return implementation_->firstHit(origin, direction.normalized(), maximum, excluded);
}

void RayCaster::castFan(const RayFan& fan, const Pose3& frameInWorld, double maximum, BodyRange excluded,
                        std::span<FanHit> hits) const {
  implementation_->castFan(fan, frameInWorld, maximum, excluded, hits);
}

void RayCaster::castBundle(const RayBundle& bundle, const Pose3& frameInWorld, double maximum,
                           BodyRange excluded, std::span<BundleHit> hits) const {
  implementation_->castBundle(bundle, frameInWorld, maximum, excluded, hits);
}

}  // namespace simcore
