// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/ShadowCaster.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

constexpr int kPacket = 8;
/// Rays end before the surface that they light, so that it does not shade itself by rounding.
constexpr float kEnd = 1 - 2e-4F;

struct Packet {
  alignas(32) int valid[kPacket] = {};
  RTCRay8 rays = {};
};

void fill(Packet& packet, const RayList& rays, int first, const Eigen::Vector3f& lamp) {
  for (int lane = 0; lane < kPacket; ++lane) {
    const int ray = std::min(first + lane, rays.count - 1);
    packet.valid[lane] = first + lane < rays.count ? -1 : 0;
    packet.rays.org_x[lane] = lamp.x();
    packet.rays.org_y[lane] = lamp.y();
    packet.rays.org_z[lane] = lamp.z();
    packet.rays.dir_x[lane] = rays.direction[0][ray];
    packet.rays.dir_y[lane] = rays.direction[1][ray];
    packet.rays.dir_z[lane] = rays.direction[2][ray];
    packet.rays.tnear[lane] = 0;
    packet.rays.tfar[lane] = kEnd;
    packet.rays.mask[lane] = ~0U;
  }
}

}  // namespace

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

void ShadowCaster::addUnshadowed(std::size_t lamp, const RayList& rays, float* light) {
  const RTCScene tree = tree_.scene();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  Packet packet;
  for (int first = 0; first < rays.count; first += kPacket) {
    fill(packet, rays, first, scene_.lamps[lamp].position);
    rtcOccluded8(packet.valid, tree, &context, &packet.rays);
    for (int lane = 0; lane < std::min(kPacket, rays.count - first); ++lane) {
      if (packet.rays.tfar[lane] >= 0) light[rays.pixel[first + lane]] += rays.light[first + lane];
    }
  }
}

}  // namespace simcore::rendering
