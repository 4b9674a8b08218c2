// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeRays.h"

#include <algorithm>

#include "simcore/physics/OdeGeoms.h"

namespace simcore {
namespace {

/// In m: how far below a model the ground is searched, and what is as good as standing on it.
constexpr double kGroundDepth = 1000, kNoGap = 0.001;

struct RayQuery {
  int ownModel = 0;
  double distance = 0;
};

void hitByRay(void* data, dGeomID a, dGeomID b) {
  auto& query = *static_cast<RayQuery*>(data);
  if (descend(&query, a, b, &hitByRay)) return;
  const dGeomID other = dGeomGetClass(a) == dRayClass ? b : a;
  if (infoOf(other).model == query.ownModel) return;
  dContactGeom contact;
  if (dCollide(a, b, 1, &contact, sizeof contact) == 1)
    query.distance = std::min(query.distance, contact.depth);
}

}  // namespace

double castRay(OdeWorld& ode, const Vector3& origin, const Vector3& direction, double length, int ownModel) {
  dGeomRaySetLength(ode.ray, length);
  dGeomRaySet(ode.ray, origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
  RayQuery query{ownModel, length};
  dSpaceCollide2(ode.ray, reinterpret_cast<dGeomID>(ode.top), &query, &hitByRay);
  if (ode.usesGrid) {
    StaticGrid::Bounds bounds;
    dGeomGetAABB(ode.ray, bounds.data());
    ode.grid.near(bounds, ode.nearby);
    for (const dGeomID geom : ode.nearby) hitByRay(&query, ode.ray, geom);
  }
  return query.distance;
}

void comeDown(OdeWorld& ode, int model) {
  const OdeModel& entry = ode.models[static_cast<std::size_t>(model)];
  double down = kGroundDepth;
  for (const OdeGeom& geom : ode.geoms) {
    if (geom.model != model || dGeomGetBody(geom.id) == nullptr) continue;
    dReal bounds[6];
    dGeomGetAABB(geom.id, bounds);
    // From the middle, which is outside of other solids where the bottom may be inside of a slope.
    const Vector3 middle((bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
                         (bounds[4] + bounds[5]) / 2);
    const double ground = castRay(ode, middle, -Vector3::UnitZ(), kGroundDepth, model);
    if (ground < kGroundDepth) down = std::min(down, ground - (middle.z() - bounds[4]));
  }
  if (down < kNoGap || down >= kGroundDepth) return;
  for (std::size_t i = entry.firstBody; i < entry.firstBody + entry.bodyCount; ++i) {
    if (!ode.hasBody(i)) continue;
    const dBodyID body = ode.bodies[i].id;
    const dReal* at = dBodyGetPosition(body);
    dBodySetPosition(body, at[0], at[1], at[2] - down);
  }
}

}  // namespace simcore
