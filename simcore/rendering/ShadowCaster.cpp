// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/ShadowCaster.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

constexpr int kWidth = 8;
/// Rays end in front of the surface that they light, so that it does not shade itself by rounding errors.
constexpr float kEnd = 1 - 2e-4F;
/// The rays of directional lamps are longer.
constexpr float kFarEnd = 1 - 1e-5F;

float endOf(const Lamp& lamp) {
  return lamp.kind == Lamp::Kind::kDirectional ? kFarEnd : kEnd;
}

}  // namespace

/// Collects rays from a lamp and traces them whenever there are eight.
class ShadowCaster::Packet {
 public:
  Packet(RTCScene tree, const Lamp& lamp, const UnsurePixels& pixels, float* light)
      : tree_(tree), pixels_(pixels), light_(light), end_(endOf(lamp)) {
    const Eigen::Vector3f place = placeOf(lamp);
    for (int lane = 0; lane < kWidth; ++lane) {
      rays_.org_x[lane] = place.x();
      rays_.org_y[lane] = place.y();
      rays_.org_z[lane] = place.z();
      rays_.mask[lane] = ~0U;
    }
  }

  void add(const UnsureGroup& group, unsigned lanes) {
    for (; lanes != 0; lanes &= lanes - 1) add(group.pixel + __builtin_ctz(lanes));
  }

  void trace() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded8(valid_, tree_, &context, &rays_);
    for (int lane = 0; lane < count_; ++lane) {
      const int pixel = pixel_[lane];
      const bool arrived = rays_.tfar[lane] >= 0;
      if (arrived) light_[pixel] += pixels_.light[pixel];
      pixels_.seen[pixel] = arrived ? 3 : 2;
      valid_[lane] = 0;
    }
    count_ = 0;
  }

 private:
  void add(int pixel) {
    rays_.dir_x[count_] = pixels_.direction[0][pixel];
    rays_.dir_y[count_] = pixels_.direction[1][pixel];
    rays_.dir_z[count_] = pixels_.direction[2][pixel];
    rays_.tfar[count_] = end_;
    valid_[count_] = -1;
    pixel_[count_++] = pixel;
    if (count_ == kWidth) trace();
  }

  RTCScene tree_;
  const UnsurePixels& pixels_;
  float* light_;
  float end_;
  int count_ = 0;
  int pixel_[kWidth] = {};
  alignas(32) int valid_[kWidth] = {};
  RTCRay8 rays_ = {};
};

ShadowCaster::ShadowCaster(const RenderScene& scene, std::span<const DrawableMesh> meshes,
                           const Kernels& kernels)
    : scene_(scene), meshes_(meshes), kernels_(kernels), tree_(scene) {
  for (const Lamp& lamp : scene.lamps) {
    LampGrid& grid = grids_.emplace_back(placeOf(lamp).cast<double>());
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
  placed_ = tree_.scene();
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

void ShadowCaster::addUnshadowed(std::size_t lamp, UnsurePixels& pixels, int stride, float* light) const {
  Packet packet(placed_, scene_.lamps[lamp], pixels, light);
  const auto groups = std::span(pixels.groups, static_cast<std::size_t>(pixels.count));
  for (const UnsureGroup& group : groups) {
    if (group.row % 2 == 0) packet.add(group, group.lanes & 0x55U);
  }
  packet.trace();
  kernels_.settle(pixels, stride, light);
  for (const UnsureGroup& group : groups) packet.add(group, group.lanes);
  packet.trace();
  for (const UnsureGroup& group : groups) std::fill_n(pixels.seen + group.pixel, 8, 0);
}

}  // namespace simcore::rendering
