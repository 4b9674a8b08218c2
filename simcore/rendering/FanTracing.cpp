// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/FanTracing.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

constexpr int kPacket = 8;

/// Intersects up to eight rays from `first` on with a tree; rays with a hit before `nearest` are skipped.
void tracePacket(RTCScene tree, const LocalFan& fan, int first, int count, double nearest,
                 std::span<FanHit> hits) {
  alignas(32) int valid[kPacket];
  RTCRayHit8 packet;
  bool any = false;
  for (int lane = 0; lane < kPacket; ++lane) {
    // Lanes beyond the last ray repeat it and are switched off.
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

}  // namespace

void traceFan(RTCScene tree, const LocalFan& fan, int first, int last, double nearest,
              std::span<FanHit> hits) {
  for (int ray = first; ray <= last; ray += kPacket) {
    tracePacket(tree, fan, ray, std::min(kPacket, last - ray + 1), nearest, hits);
  }
}

FanView::FanView(const RayFan& fan, const Pose3& frameInWorld)
    : fan_(fan), frame_(frameInWorld), origin_(frameInWorld.translation()) {
  const Eigen::Vector2d start = fan.directions().front(), end = fan.directions().back();
  const Eigen::Vector3d x = frameInWorld.linear().col(0), y = frameInWorld.linear().col(1);
  pastStart_ = -start.y() * x + start.x() * y;
  beforeEnd_ = end.y() * x - end.x() * y;
  // The edges of half a turn may be rounded to slightly more.
  narrow_ = fan.step() * static_cast<double>(fan.size() - 1) <= robotlink::kPi + 1e-9;
}

bool FanView::look(const Sphere& sphere) {
  const Eigen::Vector3d seen = frame_.linear().transpose() * (sphere.center - origin_);
  const double square = sphere.radius * sphere.radius - seen.z() * seen.z();
  if (square <= 0) return false;
  const double around = std::sqrt(square), distance = seen.head<2>().norm();
  nearest_ = std::max(0.0, distance - around);
  half_ = distance > around ? std::asin(around / distance) : robotlink::kPi;
  middle_ = std::atan2(seen.y(), seen.x());
  return true;
}

}  // namespace simcore::rendering
