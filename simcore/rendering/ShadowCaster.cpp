// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/ShadowCaster.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

constexpr int kWidth = 8;
/// Rays end before the surface that they light, so that it does not shade itself by rounding.
constexpr float kEnd = 1 - 2e-4F;

/// Whether a pixel is one of the four whose ray is always traced.
bool isLeader(const RayList& rays, int ray) {
  return ((rays.pixel[ray] | rays.row[ray]) & 1) == 0;
}

}  // namespace

/// Rays on their way from a lamp; they are traced whenever there are eight.
class ShadowCaster::Packet {
 public:
  Packet(RTCScene tree, const Eigen::Vector3f& lamp, const RayList& rays, std::int32_t* traced, float* light)
      : tree_(tree), list_(rays), traced_(traced), light_(light) {
    for (int lane = 0; lane < kWidth; ++lane) {
      rays_.org_x[lane] = lamp.x();
      rays_.org_y[lane] = lamp.y();
      rays_.org_z[lane] = lamp.z();
      rays_.mask[lane] = ~0U;
    }
  }

  void add(int ray) {
    rays_.dir_x[count_] = list_.direction[0][ray];
    rays_.dir_y[count_] = list_.direction[1][ray];
    rays_.dir_z[count_] = list_.direction[2][ray];
    rays_.tfar[count_] = kEnd;
    valid_[count_] = -1;
    index_[count_++] = ray;
    if (count_ == kWidth) trace();
  }

  void trace() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid_, tree_, &context, &rays_);
    for (int lane = 0; lane < count_; ++lane) {
      const int ray = index_[lane], pixel = list_.pixel[ray];
      const bool arrived = rays_.tfar[lane] >= 0;
      if (arrived) light_[pixel] += list_.light[ray];
      traced_[pixel] = 2 * list_.self[ray] + 2 + (arrived ? 1 : 0);
      valid_[lane] = 0;
    }
    count_ = 0;
  }

 private:
  RTCScene tree_;
  const RayList& list_;
  std::int32_t* traced_;
  float* light_;
  int count_ = 0;
  int index_[kWidth] = {};
  alignas(32) int valid_[kWidth] = {};
  RTCRay8 rays_ = {};
};

ShadowCaster::ShadowCaster(const RenderScene& scene, std::span<const DrawableMesh> meshes)
    : scene_(scene), meshes_(meshes), tree_(scene) {
  for (const Lamp& lamp : scene.lamps) {
    LampGrid& grid = grids_.emplace_back(lamp.position.cast<double>());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
      const RenderInstance& instance = scene.instances[i];
      if (instance.body != 0 || !instance.castsShadow) continue;
      grid.addStatic(scene.meshes[static_cast<std::size_t>(instance.mesh)], instance.meshInBody,
                     static_cast<int>(i));
    }
  }
}

void ShadowCaster::setPoses(std::span<const Pose3> bodyInWorld) {
  tree_.setPoses(bodyInWorld);
  for (LampGrid& grid : grids_) grid.beginMoving();
  for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
    const RenderInstance& instance = scene_.instances[i];
    if (instance.body == 0 || !instance.castsShadow) continue;
    const Pose3 meshInWorld = bodyInWorld[static_cast<std::size_t>(instance.body)] * instance.meshInBody;
    for (const Sphere& sphere : meshes_[static_cast<std::size_t>(instance.mesh)].cover()) {
      const Sphere inWorld{meshInWorld * sphere.center, sphere.radius};
      for (LampGrid& grid : grids_) grid.addMoving(inWorld, static_cast<int>(i));
    }
  }
}

/// What the neighbours with rays of their own say of a pixel if they agree, else 0.
int ShadowCaster::witness(const RayList& rays, int ray, int stride) const {
  if (rays.self[ray] < 0) return 0;
  const std::int32_t* const at = traced_.data() + stride + rays.pixel[ray];
  const bool oddColumn = (rays.pixel[ray] & 1) != 0, oddRow = (rays.row[ray] & 1) != 0;
  const int across = oddColumn ? 1 : 0, down = oddRow ? stride : 0;
  const std::int32_t first = at[-across - down];
  if (first / 2 - 1 != rays.self[ray] || at[across + down] != first) return 0;
  if (oddColumn && oddRow && (at[across - down] != first || at[down - across] != first)) return 0;
  return first;
}

void ShadowCaster::addUnshadowed(std::size_t lamp, const RayList& rays, int stride, int pixels,
                                 float* light) {
  traced_.assign(static_cast<std::size_t>(pixels + 2 * stride), 0);
  Packet packet(tree_.scene(), scene_.lamps[lamp].position, rays, traced_.data() + stride, light);
  for (int ray = 0; ray < rays.count; ++ray) {
    if (isLeader(rays, ray)) packet.add(ray);
  }
  packet.trace();
  for (int ray = 0; ray < rays.count; ++ray) {
    if (isLeader(rays, ray)) continue;
    const int said = witness(rays, ray, stride);
    if (said == 0) {
      packet.add(ray);
    } else if (said % 2 != 0) {
      light[rays.pixel[ray]] += rays.light[ray];
    }
  }
  packet.trace();
}

}  // namespace simcore::rendering
