// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/RayCaster.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/DrawableMesh.h"

namespace simcore {
namespace {

/// A body that has something to hit.
struct Target {
  int body = 0;
  RTCScene tree = nullptr;
  rendering::Sphere bound;  ///< in the body's frame
  Pose3 pose = Pose3::Identity();
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< of the bound, in the world
};

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

constexpr int kPacket = 8;

/// A fan in the frame of the tree that it meets.
struct LocalFan {
  const RayFan& fan;
  Eigen::Vector3d origin, x, y;

  LocalFan(const RayFan& rays, const Pose3& frameInTree)
      : fan(rays),
        origin(frameInTree.translation()),
        x(frameInTree.linear().col(0)),
        y(frameInTree.linear().col(1)) {}
  Eigen::Vector3d direction(int ray) const {
    const Eigen::Vector2d& d = fan.directions()[static_cast<std::size_t>(ray)];
    return d.x() * x + d.y() * y;
  }
};

/// Lets those of up to eight rays from `first` on meet a tree that have not met anything before `nearest`.
void tracePacket(RTCScene tree, const LocalFan& fan, int first, int count, double nearest,
                 std::span<RayCaster::FanHit> hits) {
  alignas(32) int valid[kPacket];
  RTCRayHit8 packet;
  bool any = false;
  for (int lane = 0; lane < kPacket; ++lane) {
    // Lanes past the last ray repeat it, switched off.
    const int ray = first + std::min(lane, count - 1);
    const double farthest = hits[static_cast<std::size_t>(ray)].distance;
    const Eigen::Vector3f along = fan.direction(ray).cast<float>();
    const bool on = lane < count && farthest > nearest;
    valid[lane] = on ? -1 : 0;
    any = any || on;
    packet.ray.org_x[lane] = static_cast<float>(fan.origin.x());
    packet.ray.org_y[lane] = static_cast<float>(fan.origin.y());
    packet.ray.org_z[lane] = static_cast<float>(fan.origin.z());
    packet.ray.dir_x[lane] = along.x();
    packet.ray.dir_y[lane] = along.y();
    packet.ray.dir_z[lane] = along.z();
    packet.ray.tnear[lane] = 0;
    packet.ray.tfar[lane] = static_cast<float>(farthest);
    packet.ray.time[lane] = 0;
    packet.ray.mask[lane] = ~0U;
    packet.ray.flags[lane] = 0;
    packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }
  if (!any) return;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect8(valid, tree, &context, &packet);
  for (int lane = 0; lane < count; ++lane) {
    if (valid[lane] == 0 || packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID) continue;
    const Eigen::Vector3d normal(packet.hit.Ng_x[lane], packet.hit.Ng_y[lane], packet.hit.Ng_z[lane]);
    const double cosine = std::abs(normal.dot(fan.direction(first + lane))) / normal.norm();
    hits[static_cast<std::size_t>(first + lane)] = {static_cast<double>(packet.ray.tfar[lane]),
                                                    std::min(1.0, cosine)};
  }
}

void traceRays(RTCScene tree, const LocalFan& fan, int first, int last, double nearest,
               std::span<RayCaster::FanHit> hits) {
  for (int ray = first; ray <= last; ray += kPacket) {
    tracePacket(tree, fan, ray, std::min(kPacket, last - ray + 1), nearest, hits);
  }
}

/// Where a sphere is, seen from a fan: which of its rays may meet it, and from which distance on.
class FanView {
 public:
  FanView(const RayFan& fan, const Pose3& frameInWorld) : fan_(fan), frame_(frameInWorld) {}

  /// False if no ray can meet the sphere before `maximum`.
  bool look(const Eigen::Vector3d& center, double radius, double maximum) {
    const Eigen::Vector3d toCenter = center - frame_.translation();
    if (toCenter.squaredNorm() > (maximum + radius) * (maximum + radius)) return false;
    const Eigen::Vector3d seen = frame_.linear().transpose() * toCenter;
    const double square = radius * radius - seen.z() * seen.z();
    if (square <= 0) return false;
    const double around = std::sqrt(square);
    distance_ = std::hypot(seen.x(), seen.y());
    nearest_ = std::max(0.0, distance_ - around);
    half_ = distance_ > around ? std::asin(around / distance_) : robotlink::kPi;
    middle_ = std::atan2(seen.y(), seen.x());
    return true;
  }

  double nearest() const { return nearest_; }

  /// Calls with the first and last ray of each stretch that may meet what was looked at.
  template <typename Trace>
  void forRays(Trace trace) const {
    const int last = static_cast<int>(fan_.size()) - 1;
    if (half_ >= robotlink::kPi) return trace(0, last);
    for (int turn = -1; turn <= 1; ++turn) {
      const double middle = middle_ + turn * 2 * robotlink::kPi - fan_.start();
      if (fan_.step() <= 0) {
        if (std::abs(middle) <= half_) trace(0, 0);
        continue;
      }
      const double low = std::ceil((middle - half_) / fan_.step()),
                   high = std::floor((middle + half_) / fan_.step());
      if (high < 0 || low > last) continue;
      const int from = static_cast<int>(std::max(low, 0.0)),
                to = static_cast<int>(std::min<double>(high, last));
      if (from <= to) trace(from, to);
    }
  }

 private:
  const RayFan& fan_;
  const Pose3& frame_;
  double distance_ = 0, nearest_ = 0, half_ = 0, middle_ = 0;
};

}  // namespace

RayFan::RayFan(double start, double end, int count)
    : start_(start), step_(count > 1 ? (end - start) / (count - 1) : 0) {
  for (int i = 0; i < std::max(1, count); ++i) {
    const double angle = start + step_ * i;
    directions_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

class RayCaster::Implementation {
 public:
  explicit Implementation(const RenderScene& scene) : device_(rendering::newRayDevice()) {
    rendering::BodyTrees trees(device_, scene, rendering::Contents::kEverything);
    for (int body = 0; body < rendering::bodyCount(scene); ++body) {
      const RTCScene tree = trees.treeOf(body);
      if (tree == nullptr) continue;
      const rendering::Sphere bound = boundOf(tree);
      targets_.push_back({body, tree, bound, Pose3::Identity(), bound.center});
    }
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
    FanView view(fan, frameInWorld);
    // The world comes first, as it hides most of the bodies.
    for (const Target& target : targets_) {
      if (target.body >= excluded.first && target.body < excluded.last) continue;
      if (!view.look(target.center, target.bound.radius, maximum)) continue;
      const LocalFan local(fan, target.pose.inverse(Eigen::Isometry) * frameInWorld);
      view.forRays(
          [&](int first, int last) { traceRays(target.tree, local, first, last, view.nearest(), hits); });
    }
  }

 private:
  RTCDevice device_;
  std::vector<Target> targets_;
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

}  // namespace simcore
