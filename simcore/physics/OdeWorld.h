// SPDX-License-Identifier: GPL-3.0-or-later
// ODE's view of a world; for Physics and its benchmark only. ODE is private to simcore.
#pragma once

#include <ode/ode.h>

#include <deque>
#include <vector>

#include "simcore/physics/OdeDrive.h"
#include "simcore/physics/StaticGrid.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// What a geom's data points to.
struct OdeGeom {
  dGeomID id = nullptr;
  int model = 0;
  double friction = 1;
  double restitution = 0;
  int wheel = -1;  ///< of OdeWorld::wheels; -1: no wheel
  bool touched = false;
};

struct OdeBody {
  dBodyID id = nullptr;  ///< of a wheel: that of the body that carries it
  int wheel = -1;        ///< of OdeWorld::wheels; -1: no wheel
  Vector3 centerInLink = Vector3::Zero();
  std::size_t firstGeom = 0;  ///< of its geoms, which follow each other
};

/// What a space's data points to, but for that of statics.
struct OdeModel {
  dSpaceID space = nullptr;  ///< null: static
  std::size_t firstBody = 0, bodyCount = 0;
  bool kinematic = false;        ///< moved by its odometry, not by forces
  bool touchesObstacle = false;  ///< anything but a floor, in the last step
};

/// Where a moving model is at most, seen from above: in a circle about its first body; one with a drive also
/// in a rectangle.
struct OdePlace {
  int model = 0;
  double x = 0, y = 0, radius = 0;
  bool hasFootprint = false;
  Footprint footprint = {};
};

/// Owns everything that ODE made for one world.
struct OdeWorld {
  /// An empty world: see buildOdeWorld().
  explicit OdeWorld(const WorldDescription& description);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  const WorldDescription& description;
  dWorldID world = nullptr;
  dSpaceID top = nullptr;
  dSpaceID statics = nullptr;  ///< of a world with a grid, only what has no end
  StaticGrid grid;             ///< of all static geoms
  bool usesGrid = false;       ///< there are so many of them that contacts are found by the grid
  bool hasSteepPlanes = false;
  dJointGroupID contacts = nullptr;
  dGeomID ray = nullptr;  ///< in no space
  dThreadingImplementationID threading = nullptr;
  std::deque<OdeGeom> geoms;  ///< a deque: ODE keeps pointers to its elements
  std::vector<OdeBody> bodies;
  std::vector<dJointID> hinges;
  std::vector<OdeModel> models;
  std::vector<OdePlace> places;  ///< of all moving models; where they are is looked up where it is needed
  bool hasKinematic = false, hasDynamic = false;  ///< models
  std::vector<OdeDrive> drives;                   ///< the i-th has the wheelSides 2 i (left) and 2 i + 1
  std::vector<OdeWheel> wheels;
  std::vector<OdeWheelSide> wheelSides;
  std::deque<OdeWheelContact> wheelContacts;  ///< those of this step come first; a deque: ODE keeps pointers
  std::size_t wheelContactCount = 0;
  std::vector<std::pair<int, int>> touches;  ///< pairs of moving models, lower index first, of the last step

  std::vector<OdeGeom*> touchedGeoms;  ///< in the last step
  std::vector<dGeomID> nearby;         ///< reused by whoever asks the grid

  void touch(OdeGeom& geom) {
    if (!geom.touched) touchedGeoms.push_back(&geom);
    geom.touched = true;
  }
  OdeWheelContact& nextWheelContact();
  Pose3 linkPose(std::size_t body) const;
  /// The link of a wheel that has rolled as far as its side has.
  Pose3 wheelLinkPose(const OdeWheel& wheel) const;
};

/// Makes ODE ready to be used by the calling thread.
void prepareOdeForThread();

Pose3 poseOf(const dReal* position, const dReal* rotation);

}  // namespace simcore
