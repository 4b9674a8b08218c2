// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to the sources that include libsdformat, whose headers take seconds to compile.
#pragma once

#include <optional>
#include <sdf/sdf.hh>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/meshes/MeshFiles.h"
#include "simcore/sdf/ModelSearch.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Palette.h"
#include "simcore/world/WorldDescription.h"

namespace simcore {

/// Converts vectors and poses of libsdformat.
inline Vector3 toEigen(const ignition::math::Vector3d& v) {
  return {v.X(), v.Y(), v.Z()};
}

inline Pose3 toEigen(const ignition::math::Pose3d& pose) {
  const auto& q = pose.Rot();
  return Eigen::Translation3d(toEigen(pose.Pos())) *
         Eigen::Quaterniond(q.W(), q.X(), q.Y(), q.Z()).normalized();
}

/// Whether a text of libsdformat is missing in the file.
inline bool isNoText(const std::string& text) {
  return text.empty() || text == "__default__";
}

/// The environment for converting one file, and where its errors go. A bundle of references.
struct SdfContext {
  const std::string& file;
  /// The whole tree, to find the lines of names in messages of libsdformat.
  const sdf::ElementPtr& root;
  const Palette& palette;
  robotlink::Errors& errors;
  LeftOuts& leftOut;
  MeshFiles& meshes;
  const ModelSearch& search;
  /// Whether the model that is being converted never moves.
  bool isStatic = false;

  /// The same with another place for errors.
  SdfContext reportingTo(robotlink::Errors& other) const {
    return {file, root, palette, other, leftOut, meshes, search, isStatic};
  }
  /// The file and the line of an element.
  robotlink::FilePosition placeOf(const sdf::ElementPtr& element) const;
  /// The path of the object that an element is, or is in: "lift/cabin".
  static std::string pathOf(sdf::ElementPtr element);
  /// Adds an error at an element: its file and line, and the path of the object.
  void fail(const sdf::ElementPtr& element, std::string id, std::string text) const;
  /// Calls `read` with a context whose errors only say why `what` is left out. Returns whether there were
  /// none.
  template <typename Read>
  bool orLeaveOut(const sdf::ElementPtr& element, const std::string& what, Read read) const {
    robotlink::Errors own;
    read(reportingTo(own));
    omit(element, what, own);
    return own.empty();
  }
  /// Notes what the simulator does not have, at an element.
  void omit(const sdf::ElementPtr& element, std::string what, std::string why) const;
  /// The same for each error, at its place.
  void omit(const sdf::ElementPtr& element, const std::string& what, const robotlink::Errors& why) const;
  /// Adds the errors of libsdformat; returns true if there are none.
  bool take(const sdf::Errors& found, const sdf::ElementPtr& element) const;
  /// Returns `value` if it is in [minimum, maximum]; otherwise adds an error and returns `minimum`. NaN is
  /// never in range.
  double within(double value, double minimum, double maximum, const std::string& what,
                const sdf::ElementPtr& element) const;
};

/// Resolves a pose to a frame and checks that it is finite and near.
Pose3 resolvedPose(const sdf::SemanticPose& semantic, const std::string& frame,
                   const sdf::ElementPtr& element, const SdfContext& context);
/// Reads a link: its mass, solids and visuals.
LinkDescription readLink(const sdf::Link& link, const SdfContext& context);
/// A shape with its place in the frame of its <geometry>; there are several if a mesh has several colors.
struct PlacedShape {
  Shape shape;
  Pose3 poseInGeometry = Pose3::Identity();
  /// The color that a mesh's file gives it.
  std::optional<Rgb> color;
};
/// Reads the shapes of a <geometry>; none if the simulator has none for it, which is noted, or after an
/// error. Solids of moving models are never meshes.
std::vector<PlacedShape> readVisibleShapes(const sdf::Geometry& geometry, const SdfContext& context);
std::vector<PlacedShape> readSolidShapes(const sdf::Geometry& geometry, const SdfContext& context);

/// Reads the joints of a model and of those in it; its links must have been read before. Their links' names
/// in `model` begin with `prefix`. Joints are ordered from parents to children; those that close a cycle come
/// last.
void readJoints(const sdf::Model& source, const Pose3& sourceInModel, const std::string& prefix,
                ModelDescription& model, const SdfContext& context);
void orderJoints(ModelDescription& model, const sdf::ElementPtr& element, const SdfContext& context);

/// Reads the lights of a world.
void readLamps(const sdf::World& world, WorldDescription& result, const SdfContext& context);
/// Reads the sensors of a link; kinds that this simulator does not know are left out, and so are those with
/// values that they cannot have.
void readSensors(const sdf::Link& link, int linkIndex, ModelDescription& model, const SdfContext& context);
/// The update_rate of a sensor, Hz, from `slowest` on; the fastest possible one if it is higher, which is
/// noted.
double updateRate(const sdf::Sensor& sensor, double slowest, const SdfContext& context);
/// Reads a lidar: a laser or, if it has one ray, a distance sensor.
void readLidar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context);
void readSonar(const sdf::Sensor& sensor, SensorDescription& result, const SdfContext& context);

/// Reads the model's <robotcontrol:drive>, if it has one; its links and joints must have been read before.
void readDrive(const sdf::Model& source, ModelDescription& model, const SdfContext& context);

}  // namespace simcore
