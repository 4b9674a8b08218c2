// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"

namespace robotcontrol {
class WorldObject;
class WorldObjects;
class WorldProperty;
}  // namespace robotcontrol
namespace robotlink {
class StreamStore;
}

namespace widgets {

class SceneState;

/// The objects of a simulated scene by their paths, from the stream "objects": who belongs to whom, and where
/// they are. Pointers are valid until the next update(). GUI thread.
class SceneObjects {
 public:
  /// Reads the newest message. Returns whether it is another one.
  bool update(const robotlink::StreamStore& store);
  /// Null while there is none.
  const robotcontrol::WorldObjects* all() const;
  /// Null if there is none of this path.
  const robotcontrol::WorldObject* find(const std::string& path) const;
  /// The path itself, then those of all objects that it belongs to, up to the model. Paths of parts that are
  /// not listed, as those of large maps, have their link and model.
  std::vector<std::string> lineage(const std::string& path) const;
  bool isWithin(const std::string& path, const std::string& ancestor) const;
  /// In the field's frame; that of the nearest object above that has one; unset: it has no place.
  std::optional<robotlink::Pose3> pose(const std::string& path, const SceneState& scene) const;
  /// The camera to look out of an object: the object itself, else the first camera below it; null: there is
  /// none.
  const robotcontrol::WorldObject* cameraOf(const std::string& path) const;

 private:
  robotlink::PackagePtr message_;
  std::map<std::string, const robotcontrol::WorldObject*> byPath_;
};

/// A property of an object by its name; null if it has none, or it is no number.
const robotcontrol::WorldProperty* numbersOf(const robotcontrol::WorldObject& object, const char* name);
/// The same as a vector; unset if it has not exactly three finite values.
std::optional<robotlink::Vector3> vectorOf(const robotcontrol::WorldObject& object, const char* name);
/// A value of a property; unset if it has no such value.
std::optional<double> numberOf(const robotcontrol::WorldObject& object, const char* name, int index = 0);

}  // namespace widgets
