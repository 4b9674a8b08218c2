// SPDX-License-Identifier: GPL-3.0-or-later
// ODE's representation of a world; only for Physics and its benchmark. ODE is private to simcore.
#pragma once

#include <ode/ode.h>

#include <deque>
#include <vector>

#include "simcore/physics/OdeDrive.h"
#include "simcore/physics/StaticGrid.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// The data attached to each ODE geom.
struct OdeGeom {
  dGeomID id = nullptr;
  /// Null unless it is a mesh. The mesh itself is that of the description.
  dTriMeshDataID triangles = nullptr;
  int model = 0;
  // Coulomb's friction coefficient, and restitution, 0 to 1.
  double friction = 1;
  double restitution = 0;
  /// An index of OdeWorld::wheels; -1 if it is not a wheel.
  int wheel = -1;
  /// In the last step, by anything.
  bool touched = false;
};

/// A link of a moving model.
struct OdeBody {
  /// For a wheel, the body that carries it.
  dBodyID id = nullptr;
  /// An index of OdeWorld::wheels; -1 if it is not a wheel.
  int wheel = -1;
  /// The center of mass, which is ODE's origin of the body.
  Vector3 centerInLink = Vector3::Zero();
  /// Its geoms are consecutive in OdeWorld::geoms.
  std::size_t firstGeom = 0;
};

/// The data attached to each body that no joint holds.
struct OdeFreeBody {
  dBodyID id = nullptr;
  /// Whether its moments of inertia differ, so that it wobbles while it turns.
  bool wobbles = false;
  /// How many contacts it has in this step.
  int contacts = 0;
  // How it stood before this step.
  dVector3 position = {};
  dQuaternion rotation = {};
};

/// A passive joint that resists being moved.
struct OdeResistance {
  dJointID joint = nullptr;
  double damping = 0, friction = 0;
};

/// The data attached to the space of each moving model.
struct OdeModel {
  /// Null for a static model.
  dSpaceID space = nullptr;
  // A range of OdeWorld::bodies.
  std::size_t firstBody = 0, bodyCount = 0;
  // A range of OdeWorld::hinges.
  std::size_t firstHinge = 0, hingeCount = 0;
  /// The motors between the world and the first body of a guided model; null for others.
  dJointID push = nullptr, turn = nullptr;
  /// Follows its odometry instead of forces.
  bool kinematic = false;
  /// Whether it touched anything but a floor in the last step.
  bool touchesObstacle = false;
};

/// Bounds of a moving model seen from above: a circle around its first body; for one with a drive also a
/// rectangle.
struct OdePlace {
  int model = 0;
  // Center and radius of the circle, m.
  double x = 0, y = 0, radius = 0;
  bool hasFootprint = false;
  Footprint footprint = {};
};

/// All ODE objects of one world; it owns them. One thread at a time.
struct OdeWorld {
  /// Creates an empty world; buildOdeWorld() fills it. The description must outlive it.
  explicit OdeWorld(const WorldDescription& description);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  const WorldDescription& description;
  dWorldID world = nullptr;
  /// The space that contains all others.
  dSpaceID top = nullptr;
  /// All static geoms; if the grid is used, only unbounded ones.
  dSpaceID statics = nullptr;
  /// All static geoms.
  StaticGrid grid;
  /// Whether there are so many static geoms that contacts are found by the grid.
  bool usesGrid = false;
  /// Whether a static plane is steeper than a floor; then the drives cannot use their footprints.
  bool hasSteepPlanes = false;
  /// The contact joints of a step.
  dJointGroupID contacts = nullptr;
  /// Used for distance sensors; in no space.
  dGeomID ray = nullptr;
  /// ODE's threading of this world: none.
  dThreadingImplementationID threading = nullptr;
  /// A deque because ODE keeps pointers to its elements.
  std::deque<OdeGeom> geoms;
  /// Links of all moving models, in order.
  std::vector<OdeBody> bodies;
  /// Hinges and sliders of all moving models, in order.
  std::vector<dJointID> hinges;
  /// Whether a motor drives each of them.
  std::vector<bool> hingeHasMotor;
  /// What each of them exerted in the last step. A deque because ODE keeps pointers to its elements.
  std::deque<dJointFeedback> hingeForces;
  std::vector<OdeModel> models;
  /// Bodies that no joint holds. A deque because ODE keeps pointers to its elements.
  std::deque<OdeFreeBody> freeBodies;
  /// Joints that resist.
  std::vector<OdeResistance> resistances;
  /// The places of all moving models, updated only when they are needed.
  std::vector<OdePlace> places;
  /// Whether there are models of either kind.
  bool hasKinematic = false, hasDynamic = false;
  /// Drive i has the wheelSides 2 i (left) and 2 i + 1 (right).
  std::vector<OdeDrive> drives;
  std::vector<OdeWheel> wheels;
  std::vector<OdeWheelSide> wheelSides;
  /// A deque because ODE keeps pointers to its elements; those of this step come first.
  std::deque<OdeWheelContact> wheelContacts;
  std::size_t wheelContactCount = 0;
  /// Pairs of moving models that touched in the last step, lower index first.
  std::vector<std::pair<int, int>> touches;

  /// In the last step.
  std::vector<OdeGeom*> touchedGeoms;
  /// A buffer for queries of the grid.
  std::vector<dGeomID> nearby;

  /// Records that a geom touched something in this step.
  void touch(OdeGeom& geom) {
    if (!geom.touched) touchedGeoms.push_back(&geom);
    geom.touched = true;
  }
  /// A contact of this step, reused from an earlier one if possible.
  OdeWheelContact& nextWheelContact();
  /// The pose of a link in the world.
  Pose3 linkPose(std::size_t body) const;
  /// The pose of a wheel's link, rotated by the travel of its side.
  Pose3 wheelLinkPose(const OdeWheel& wheel) const;
};

/// Prepares ODE for use by the calling thread; cheap after the first call.
void prepareOdeForThread();

/// Converts a position and a rotation matrix of ODE.
Pose3 poseOf(const dReal* position, const dReal* rotation);

}  // namespace simcore
