// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/BundleTracing.h"

#include <algorithm>
#include <cmath>

namespace simcore::rendering {
namespace {

constexpr std::size_t kRays = 8;

/// Whether a ray of a cone may meet the bounding sphere of a target.
bool mayMeet(const RayBundle::Cone& cone, const BundleTarget& target) {
  if (target.around || cone.wide) return true;
  // The angle between the axis and the center is at most the sum of both half angles, each below 90 degrees.
  const float limit = cone.cosHalf * target.cosSeen - cone.sinHalf * target.sinSeen;
  return cone.axis.dot(target.center) >= limit * (target.nearest + target.radius);
}

/// Eight rays with their hits so far.
class PacketTrace {
 public:
  PacketTrace(const RayBundle::Packet& packet, float maximum) : packet_(packet) {
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      distance_[lane] = maximum;
      valid_[lane] = static_cast<int>(lane) < packet.count ? -1 : 0;
    }
  }
  /// Beyond this, nothing can be hit anymore.
  float farthest() const { return *std::max_element(std::begin(distance_), std::end(distance_)); }

  void meet(const BundleTarget& target) {
    RTCRayHit8 rays;
    const Eigen::Matrix3f& r = target.rotation;
    const auto& d = packet_.direction;
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      rays.ray.org_x[lane] = target.origin.x();
      rays.ray.org_y[lane] = target.origin.y();
      rays.ray.org_z[lane] = target.origin.z();
      rays.ray.dir_x[lane] = r(0, 0) * d[0][lane] + r(0, 1) * d[1][lane] + r(0, 2) * d[2][lane];
      rays.ray.dir_y[lane] = r(1, 0) * d[0][lane] + r(1, 1) * d[1][lane] + r(1, 2) * d[2][lane];
      rays.ray.dir_z[lane] = r(2, 0) * d[0][lane] + r(2, 1) * d[1][lane] + r(2, 2) * d[2][lane];
      rays.ray.tnear[lane] = 0;
      rays.ray.tfar[lane] = distance_[lane];
      rays.ray.time[lane] = 0;
      rays.ray.mask[lane] = ~0U;
      rays.ray.flags[lane] = 0;
      rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect8(valid_, target.tree, &context, &rays);
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      if (valid_[lane] == 0 || rays.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
      distance_[lane] = rays.ray.tfar[lane];
      hits_[lane] = {distance_[lane], (*target.instances)[rays.hit.geomID[lane]], rays.hit.primID[lane],
                     rays.hit.u[lane], rays.hit.v[lane]};
    }
  }

  void write(std::span<BundleHit> hits) const {
    for (std::size_t lane = 0; static_cast<int>(lane) < packet_.count; ++lane) {
      BundleHit& hit = hits[static_cast<std::size_t>(packet_.ray[lane])];
      hit = hits_[lane];
      hit.distance = distance_[lane];
    }
  }

 private:
  const RayBundle::Packet& packet_;
  alignas(32) int valid_[kRays];
  float distance_[kRays];
  BundleHit hits_[kRays];
};

}  // namespace

BundleTarget::BundleTarget(RTCScene of, const Eigen::Vector3d& centerInBundle, double radiusOf,
                           const robotlink::Pose3& bundleInTree, const std::vector<std::int32_t>& instancesOf)
    : tree(of),
      center(centerInBundle.cast<float>()),
      radius(static_cast<float>(radiusOf)),
      rotation(bundleInTree.linear().cast<float>()),
      origin(bundleInTree.translation().cast<float>()),
      instances(&instancesOf) {
  const double distance = centerInBundle.norm();
  around = distance <= radiusOf * (1 + 1e-6);
  if (around) return;
  nearest = static_cast<float>(distance - radiusOf);
  sinSeen = static_cast<float>(radiusOf / distance);
  cosSeen = std::sqrt(1 - sinSeen * sinSeen);
}

void traceBundle(const RayBundle& bundle, std::vector<BundleTarget>& targets, float maximum,
                 std::span<BundleHit> hits) {
  std::ranges::sort(targets, {}, &BundleTarget::nearest);
  std::vector<const BundleTarget*> candidates;
  for (const RayBundle::Group& group : bundle.groups()) {
    candidates.clear();
    for (const BundleTarget& target : targets) {
      if (target.nearest < maximum && mayMeet(group.cone, target)) candidates.push_back(&target);
    }
    for (std::size_t i = group.first; i < group.last; ++i) {
      PacketTrace trace(bundle.packets()[i], maximum);
      float farthest = maximum;
      for (const BundleTarget* target : candidates) {
        if (target->nearest >= farthest) break;
        if (!mayMeet(bundle.cones()[i], *target)) continue;
        trace.meet(*target);
        farthest = trace.farthest();
      }
      trace.write(hits);
    }
  }
}

}  // namespace simcore::rendering
