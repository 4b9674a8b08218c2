// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/physics/OdeWorld.h"

namespace simcore {

/// Creates a solid of a model, in a space unless that is null. `pose` (in the world) is used only for planes,
/// which ODE cannot move.
dGeomID addGeom(OdeWorld& ode, dSpaceID space, const CollisionDescription& collision, int model,
                const Pose3& pose);
/// Creates a solid that moves with a body.
void addBodyGeom(OdeWorld& ode, const OdeBody& body, const CollisionDescription& collision, int model,
                 dSpaceID space);

/// The data that addGeom() has attached to a solid.
inline OdeGeom& infoOf(dGeomID geom) {
  return *static_cast<OdeGeom*>(dGeomGetData(geom));
}

/// Calls `callback` with `data` for each pair of geoms of two spaces, or of a space and a geom, which belong
/// to different models; never for pairs within a space. Returns false, without a call, if neither of the two
/// is a space.
template <typename Data>
bool descend(Data* data, dGeomID a, dGeomID b, dNearCallback* callback) {
  if (dGeomIsSpace(a) == 0 && dGeomIsSpace(b) == 0) return false;
  dSpaceCollide2(a, b, data, callback);
  return true;
}

/// Calls `set` with a pose in the form of ODE: a position and a rotation.
template <typename Set>
void withOdePose(const Pose3& pose, Set set) {
  const Vector3& p = pose.translation();
  const auto& m = pose.linear();
  const dReal position[3] = {p.x(), p.y(), p.z()};
  const dMatrix3 rotation = {m(0, 0), m(0, 1), m(0, 2), 0,       m(1, 0), m(1, 1),
                             m(1, 2), 0,       m(2, 0), m(2, 1), m(2, 2), 0};
  set(position, rotation);
}

}  // namespace simcore
