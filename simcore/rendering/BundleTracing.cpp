// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/BundleTracing.h"

#include <algorithm>
#include <cmath>

namespace simcore::rendering {
namespace {

constexpr std::size_t kRays = 8;

/// The targets that rays of a group may meet, nearest first, laid out so that they are compared with a cone
/// several at a time.
class Candidates {
 public:
  void clear() {
    for (auto* column : {&x_, &y_, &z_, &along_, &radius_}) column->clear();
    targets_.clear();
  }
  void add(BundleTarget& target) {
    targets_.push_back(&target);
    // A target around the origin is all zero, and so passes each comparison.
    const float distance = target.around ? 0 : target.nearest + target.radius;
    x_.push_back(target.around ? 0 : target.center.x());
    y_.push_back(target.around ? 0 : target.center.y());
    z_.push_back(target.around ? 0 : target.center.z());
    along_.push_back(distance * target.cosSeen);
    radius_.push_back(distance * target.sinSeen);
  }
  std::size_t size() const { return targets_.size(); }
  BundleTarget& operator[](std::size_t i) const { return *targets_[i]; }

  /// Sets which of them a ray of a cone may meet: the angle between the axis and the center is at most the
  /// sum of both half angles, each below 90 degrees.
  void compare(const RayBundle::Cone& cone) {
    meets_.resize(size());
    if (cone.wide) {
      std::ranges::fill(meets_, std::int32_t{1});
      return;
    }
    const float ax = cone.axis.x(), ay = cone.axis.y(), az = cone.axis.z();
    const float cosHalf = cone.cosHalf, sinHalf = cone.sinHalf;
    const float *x = x_.data(), *y = y_.data(), *z = z_.data(), *along = along_.data(),
                *radius = radius_.data();
    std::int32_t* meets = meets_.data();
    for (std::size_t i = 0, end = size(); i < end; ++i)
      meets[i] = ax * x[i] + ay * y[i] + az * z[i] >= cosHalf * along[i] - sinHalf * radius[i] ? 1 : 0;
  }
  bool meets(std::size_t i) const { return meets_[i] != 0; }

 private:
  std::vector<BundleTarget*> targets_;
  // Keyed by target: the center, and the distance to it times cosine and sine of the angle at which its bound
  // is seen.
  std::vector<float> x_, y_, z_, along_, radius_;
  std::vector<std::int32_t> meets_;
};

/// Eight rays at a time with their hits so far.
class PacketTrace {
 public:
  PacketTrace() {
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      rays_.ray.tnear[lane] = rays_.ray.time[lane] = 0;
      rays_.ray.mask[lane] = ~0U;
      rays_.ray.flags[lane] = 0;
      rays_.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
      rays_.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }

  void begin(const RayBundle::Packet& packet, float maximum) {
    packet_ = &packet;
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      const bool isRay = static_cast<int>(lane) < packet.count;
      rays_.ray.tfar[lane] = isRay ? maximum : 0;
      valid_[lane] = isRay ? -1 : 0;
      instance_[lane] = -1;
      rays_.hit.primID[lane] = 0;
      rays_.hit.u[lane] = rays_.hit.v[lane] = 0;
    }
  }

  /// Returns whether something nearer was hit.
  bool meet(BundleTarget& target) {
    target.prepare();
    const Eigen::Matrix3f& r = target.rotation;
    const auto& [x, y, z] = packet_->direction;
    const float ox = target.origin.x(), oy = target.origin.y(), oz = target.origin.z();
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      rays_.ray.org_x[lane] = ox;
      rays_.ray.org_y[lane] = oy;
      rays_.ray.org_z[lane] = oz;
    }
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      rays_.ray.dir_x[lane] = r(0, 0) * x[lane] + r(0, 1) * y[lane] + r(0, 2) * z[lane];
      rays_.ray.dir_y[lane] = r(1, 0) * x[lane] + r(1, 1) * y[lane] + r(1, 2) * z[lane];
      rays_.ray.dir_z[lane] = r(2, 0) * x[lane] + r(2, 1) * y[lane] + r(2, 2) * z[lane];
    }
    rtcIntersect8(valid_, target.tree, &context_, &rays_);
    unsigned none = RTC_INVALID_GEOMETRY_ID;
    for (std::size_t lane = 0; lane < kRays; ++lane) none &= rays_.hit.geomID[lane];
    if (none == RTC_INVALID_GEOMETRY_ID) return false;
    for (std::size_t lane = 0; lane < kRays; ++lane) {
      if (rays_.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
      instance_[lane] = (*target.instances)[rays_.hit.geomID[lane]];
      rays_.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    }
    return true;
  }

  /// Beyond this, nothing can be hit anymore.
  float farthest() const { return *std::max_element(std::begin(rays_.ray.tfar), std::end(rays_.ray.tfar)); }

  void write(std::span<BundleHit> hits) const {
    for (std::size_t lane = 0; static_cast<int>(lane) < packet_->count; ++lane) {
      hits[static_cast<std::size_t>(packet_->ray[lane])] = {rays_.ray.tfar[lane], instance_[lane],
                                                            rays_.hit.primID[lane], rays_.hit.u[lane],
                                                            rays_.hit.v[lane]};
    }
  }

 private:
  const RayBundle::Packet* packet_ = nullptr;
  alignas(32) int valid_[kRays];
  // Distances and points of hits stay here from target to target.
  RTCRayHit8 rays_;
  std::int32_t instance_[kRays];
  RTCIntersectContext context_;
};

}  // namespace

BundleTarget::BundleTarget(RTCScene of, const Eigen::Vector3d& centerInBundle, double radiusOf,
                           const robotlink::Pose3& treeInWorldOf, const robotlink::Pose3& bundleInWorldOf,
                           const std::vector<std::int32_t>& instancesOf)
    : tree(of),
      center(centerInBundle.cast<float>()),
      radius(static_cast<float>(radiusOf)),
      instances(&instancesOf),
      treeInWorld(&treeInWorldOf),
      bundleInWorld(&bundleInWorldOf) {
  const double distance = centerInBundle.norm();
  around = distance <= radiusOf * (1 + 1e-6);
  if (around) return;
  nearest = static_cast<float>(distance - radiusOf);
  sinSeen = static_cast<float>(radiusOf / distance);
  cosSeen = std::sqrt(1 - sinSeen * sinSeen);
}

void BundleTarget::prepare() {
  if (isPrepared) return;
  const robotlink::Pose3 bundleInTree = treeInWorld->inverse(Eigen::Isometry) * *bundleInWorld;
  rotation = bundleInTree.linear().cast<float>();
  origin = bundleInTree.translation().cast<float>();
  isPrepared = true;
}

void traceBundle(const RayBundle& bundle, std::vector<BundleTarget>& targets, float maximum,
                 std::span<BundleHit> hits) {
  std::vector<BundleTarget*> sorted;
  sorted.reserve(targets.size());
  for (BundleTarget& target : targets) sorted.push_back(&target);
  std::ranges::stable_sort(sorted, {}, [](const BundleTarget* target) { return target->nearest; });
  Candidates all, near;
  for (BundleTarget* target : sorted) {
    if (target->nearest < maximum) all.add(*target);
  }
  PacketTrace trace;
  for (const RayBundle::Group& group : bundle.groups()) {
    near.clear();
    all.compare(group.cone);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all.meets(i)) near.add(all[i]);
    }
    for (std::size_t i = group.first; i < group.last; ++i) {
      trace.begin(bundle.packets()[i], maximum);
      near.compare(bundle.cones()[i]);
      float farthest = maximum;
      for (std::size_t k = 0; k < near.size() && near[k].nearest < farthest; ++k) {
        if (near.meets(k) && trace.meet(near[k])) farthest = trace.farthest();
      }
      trace.write(hits);
    }
  }
}

}  // namespace simcore::rendering
