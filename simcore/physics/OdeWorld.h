// SPDX-License-Identifier: GPL-3.0-or-later
// ODE's view of a world; for Physics and its benchmark only. ODE is private to simcore.
#pragma once

#include <ode/ode.h>

#include <deque>
#include <vector>

#include "simcore/WorldDescription.h"

namespace simcore {

/// What a geom's data points to.
struct OdeGeom {
  dGeomID id = nullptr;
  int model = 0;
  double friction = 1;
  double restitution = 0;
  bool touched = false;
};

struct OdeBody {
  dBodyID id = nullptr;
  Vector3 centerInLink = Vector3::Zero();
  std::size_t firstGeom = 0;  ///< of its geoms, which follow each other
};

struct OdeModel {
  dSpaceID space = nullptr;  ///< null: static
  std::size_t firstBody = 0, bodyCount = 0;
};

/// Owns everything that ODE made for one world.
struct OdeWorld {
  explicit OdeWorld(const WorldDescription& description);
  ~OdeWorld();
  OdeWorld(const OdeWorld&) = delete;
  OdeWorld& operator=(const OdeWorld&) = delete;

  const WorldDescription& description;
  dWorldID world = nullptr;
  dSpaceID top = nullptr;
  dSpaceID statics = nullptr;
  dJointGroupID contacts = nullptr;
  dGeomID ray = nullptr;  ///< in no space
  dThreadingImplementationID threading = nullptr;
  std::deque<OdeGeom> geoms;  ///< a deque: ODE keeps pointers to its elements
  std::vector<OdeBody> bodies;
  std::vector<dJointID> hinges;
  std::vector<OdeModel> models;
  std::vector<std::pair<int, int>> touches;  ///< pairs of moving models, lower index first, of the last step
};

/// Makes ODE ready to be used by the calling thread.
void prepareOdeForThread();

Pose3 poseOf(const dReal* position, const dReal* rotation);
Pose3 linkPose(const OdeBody& body);

}  // namespace simcore
