// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/OdeRays.h"

#include <algorithm>
#include <utility>

#include "simcore/physics/Contacts.h"
#include "simcore/physics/OdeGeoms.h"

namespace simcore {
namespace {

/// In m: what is as good as standing on the ground, also where a model sinks in.
constexpr double kNoGap = 0.001;

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

void lower(OdeWorld& ode, const OdeModel& model, double down) {
  for (std::size_t i = model.firstBody; i < model.firstBody + model.bodyCount; ++i) {
    if (!ode.hasBody(i)) continue;
    const dBodyID body = ode.bodies[i].id;
    const dReal* at = dBodyGetPosition(body);
    dBodySetPosition(body, at[0], at[1], at[2] - down);
  }
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

double gapBelow(OdeWorld& ode, int model) {
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
  return down;
}

void comeDown(OdeWorld& ode, int model) {
  const OdeModel& entry = ode.models[static_cast<std::size_t>(model)];
  const double down = gapBelow(ode, model);
  if (down < kNoGap || down >= kGroundDepth) return;
  const double before = deepestOverlap(ode, model).depth;
  auto fitsAt = [&, at = 0.0](double lowered, double most) mutable {
    lower(ode, entry, lowered - std::exchange(at, lowered));
    return deepestOverlap(ode, model).depth <= most;
  };
  if (fitsAt(down, std::max(kNoGap, before))) return;
  // There is an edge below it, but not below the middle of any of its solids.
  double free = 0, inside = down;
  while (inside - free > kNoGap) {
    const double between = (free + inside) / 2;
    (fitsAt(between, before) ? free : inside) = between;
  }
  fitsAt(free, before);
}

}  // namespace simcore
