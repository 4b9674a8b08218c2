// SPDX-License-Identifier: GPL-3.0-or-later
// ODE's representation of a world; only for Physics and its benchmark. ODE is private to simcore.
#pragma once

#include <ode/ode.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "simcore/physics/ObstacleTouch.h"
#include "simcore/physics/OdeDrive.h"
#include "simcore/physics/OdeFollower.h"
#include "simcore/physics/shapes/StaticGrid.h"
#include "simcore/physics/threads/IslandThreads.h"
#include "simcore/physics/threads/OdeThread.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// A force and a torque.
struct OdeWrench {
  Vector3 force = Vector3::Zero(), torque = Vector3::Zero();
};

/// The reference of a hinge's angle: directions at right angles to its axis that are the same at 0.
struct OdeHingeZero {
  Vector3 axisInParent = Vector3::UnitZ(), inParent = Vector3::UnitX(), inChild = Vector3::UnitX();
};

/// The data attached to each ODE geom.
struct OdeGeom {
  dGeomID id = nullptr;
  /// In OdeWorld::geoms.
  std::uint32_t index = 0;
  /// Null unless it is a mesh. The mesh itself is that of the description.
  dTriMeshDataID triangles = nullptr;
  int model = 0;
  /// An index of OdeWorld::bodies; kNoBody for static solids.
  std::size_t body = kNoBody;
  static constexpr std::size_t kNoBody = static_cast<std::size_t>(-1);
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
  /// For a wheel, the body that carries it; links that fixed joints connect share one.
  dBodyID id = nullptr;
  /// An index of OdeWorld::wheels; -1 if it is not a wheel.
  int wheel = -1;
  /// The link whose body it is a part of, an index of OdeWorld::bodies; its own if it has one.
  std::size_t carrier = 0;
  /// The center of mass of the body, which is ODE's origin of it.
  Vector3 centerInLink = Vector3::Zero();
  /// Only if it is a part of another link's body.
  Pose3 linkInBody = Pose3::Identity();
  /// The index of its first geom; its geoms are consecutive in OdeWorld::geoms.
  std::size_t firstGeom = 0;
  /// Whether it is held, so that nothing moves it.
  bool pinned = false;
};

/// Two geoms that touch, for the contact joints of a step.
struct OdePair {
  OdeGeom* first = nullptr;
  OdeGeom* second = nullptr;
  /// A range of OdeWorld::found.
  std::size_t firstContact = 0, count = 0;
  /// The first one is a driven wheel.
  bool rolls = false;
  /// Orders the pairs, whatever the order in which ODE finds them.
  std::uint64_t key() const {
    const auto low = std::min(first->index, second->index), high = std::max(first->index, second->index);
    return (std::uint64_t{low} << 32U) | high;
  }
};

/// A contact whose force is read.
struct OdeContactRecord {
  const OdeGeom* first = nullptr;
  const OdeGeom* second = nullptr;
  Vector3 point = Vector3::Zero(), normal = Vector3::Zero();
  double depth = 0;
  /// 1 if ODE's force is that on the first geom, -1 if it is that on the second one.
  double sign = 1;
  const dJointFeedback* exerted = nullptr;
};

/// A contact of a sleeping model, as it was when the model fell asleep.
struct OdeAsleepContact {
  /// The solids, indices of OdeWorld::geoms.
  std::uint32_t first = 0, second = 0;
  /// See OdeModel::group.
  int group = 0;
  /// The contacts of a pair follow each other.
  bool isFirstOfPair = false;
  /// The force is that on the first solid, N.
  Vector3 point = Vector3::Zero(), normal = Vector3::Zero(), force = Vector3::Zero();
  double depth = 0;
};

/// The data attached to each body that no joint holds, and to those of models that may sleep.
struct OdeFreeBody {
  dBodyID id = nullptr;
  /// A joint holds it; it is only watched whether it rests.
  bool isJointed = false;
  /// Whether its moments of inertia differ, so that it wobbles while it turns.
  bool wobbles = false;
  /// How many contacts it has in this step.
  int contacts = 0;
  // How it stood before this step.
  dVector3 position = {};
  dQuaternion rotation = {};
  /// For how many steps it has stayed where it was then; see Sleeping.h.
  int quietSteps = 0;
  dVector3 quietPosition = {};
  dQuaternion quietRotation = {};
};

/// A fixed joint whose forces are measured, about its anchor in the frame of ODE's body of the child. Without
/// a joint where the two links are one body anyway.
struct OdeMeasuredJoint {
  dJointID id = nullptr;
  Vector3 anchorInBody = Vector3::Zero();
  dJointFeedback force{};
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
  /// Follows its odometry, or what it is commanded, instead of forces.
  bool kinematic = false;
  /// Whether a model with a drive has settled on the ground since it was placed.
  bool hasGround = false;
  /// The index in OdeWorld::followers of a model that pushes what it touches; -1 for other models.
  int follower = -1;
  /// Whether it touched anything but a floor in the last step.
  bool touchesObstacle = false;
  /// The bodies of the model, if it may sleep.
  std::vector<OdeFreeBody*> sleepers;
  /// While it sleeps: the first of the models that fell asleep with it, because they touch.
  int group = kAwake;
  static constexpr int kAwake = -1;
  bool isAsleep() const { return group != kAwake; }
  bool maySleep() const { return !sleepers.empty(); }
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
  /// Whether there are so many static geoms that the grid is used for finding contacts.
  bool usesGrid = false;
  /// Whether a static plane is steeper than a floor; then the drives cannot use their footprints.
  bool hasSteepPlanes = false;
  /// The contact joints of a step.
  dJointGroupID contacts = nullptr;
  /// Used for distance sensors; in no space.
  dGeomID ray = nullptr;
  /// ODE's threading of this world: none.
  dThreadingImplementationID threading = nullptr;
  /// The threads that step the islands.
  std::unique_ptr<IslandThreads> islands;
  /// A deque because ODE keeps pointers to its elements.
  std::deque<OdeGeom> geoms;
  /// Links of all moving models, in order.
  std::vector<OdeBody> bodies;
  /// Hinges and sliders of all moving models, in order.
  std::vector<dJointID> hinges;
  /// Keyed as `hinges`; those of sliders mean nothing.
  std::vector<OdeHingeZero> hingeZeros;
  /// Whether a motor drives each of them, and the models that they are of.
  std::vector<bool> hingeHasMotor;
  /// Whether that is a servo which turns it to a position as fast as it can, rather than by gains.
  std::vector<bool> hingeIsStiff;
  std::vector<int> hingeModels;
  /// The reactions of the hinges in the last step. A deque because ODE keeps pointers to its elements.
  std::deque<dJointFeedback> hingeForces;
  /// In the order of the models and their joints.
  std::deque<OdeMeasuredJoint> measuredJoints;
  /// The mean reactions of the hinges since their model was last seen to move.
  std::vector<OdeWrench> restForces;
  std::vector<OdeModel> models;
  /// Bodies that no joint holds, and those that may sleep. A deque because ODE keeps pointers to its
  /// elements.
  std::deque<OdeFreeBody> freeBodies;
  /// Whether models sleep that rest, and what these touch.
  bool sleeps = false;
  std::vector<OdeAsleepContact> asleepContacts;
  /// Joints that resist.
  std::vector<OdeResistance> resistances;
  /// The places of all moving models, updated only when they are needed.
  std::vector<OdePlace> places;
  /// Whether there are models of either kind.
  bool hasKinematic = false, hasDynamic = false;
  /// Each has two of `wheelSides`; each wheel of a vehicle has one of its own.
  std::vector<OdeDrive> drives;
  std::vector<OdeWheel> wheels;
  std::vector<OdeWheelSide> wheelSides;
  /// The sides of the wheels of all vehicles, in order.
  std::vector<std::size_t> vehicleSides;
  /// Models that move as they are commanded; see FollowingModels.h.
  std::vector<OdeFollower> followers;
  /// A deque because ODE keeps pointers to its elements; those of this step come first.
  std::deque<OdeWheelContact> wheelContacts;
  std::size_t wheelContactCount = 0;
  /// The pairs of geoms that touch in a step, and their contacts.
  std::vector<OdePair> pairs;
  std::vector<dContact> found;
  /// Whether the forces of contacts are read; they are recorded then, and ODE writes them to the elements of
  /// a deque because it keeps pointers to these.
  bool readsContacts = false;
  std::vector<OdeContactRecord> contactRecords;
  std::deque<dJointFeedback> contactForces;
  /// Bodies that touched anything but a floor in the last step, some of them several times.
  std::vector<ObstacleTouch> obstacleTouches;
  /// The joints of all contacts of this step.
  int contactCount = 0;
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
  /// A side of the drives: 2 i is the left one of drive i, 2 i + 1 the right one.
  OdeWheelSide& driveSide(std::size_t side) { return wheelSides[drives[side / 2].firstSide + side % 2]; }
  /// Has a model that forces do not move find out again how it stands, after it was moved by others.
  void forgetGround(OdeModel& model) {
    model.hasGround = false;
    if (model.follower >= 0) followers[static_cast<std::size_t>(model.follower)].known = false;
  }
  /// Whether a link has a body of its own: it is neither a wheel nor a part of another link's body.
  bool hasBody(std::size_t body) const { return bodies[body].carrier == body; }
  /// A contact of this step, reused from an earlier one if possible.
  OdeWheelContact& nextWheelContact();
  /// The pose of a link in the world.
  Pose3 linkPose(std::size_t body) const;
  /// The pose of a wheel's link, rotated by the travel of its side.
  Pose3 wheelLinkPose(const OdeWheel& wheel) const;
};

/// Converts a position and a rotation matrix of ODE.
Pose3 poseOf(const dReal* position, const dReal* rotation);

}  // namespace simcore
