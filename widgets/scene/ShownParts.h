// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "widgets/scene/ObjectLooks.h"
#include "widgets/scene/SceneObjects.h"

namespace widgets {

/// The visibility of the parts of a scene in a view: the looks of objects, and the one object to which the
/// view may be limited. GUI thread.
class ShownParts {
 public:
  /// The middle of an object in its own frame, and the radius of a sphere around all of its shapes.
  struct Extent {
    robotlink::Vector3 middle = robotlink::Vector3::Zero();
    double radius = 0;
  };

  /// Reads the objects of the scene. Returns whether they are others.
  bool update(const robotlink::StreamStore& store);
  const SceneObjects& objects() const { return objects_; }
  const ObjectLooks& looks() const { return looks_; }
  /// Returns the looks in order to change them; the results for bodies are computed again.
  ObjectLooks& changeLooks();

  /// A number that changes whenever the objects, or which of them are shown, may have changed.
  int revision() const { return revision_; }
  /// The object to which the view is limited; empty: none.
  const std::string& only() const { return only_; }
  void setOnly(const std::string& path);

  /// Whether an object is shown.
  bool isShown(const std::string& path) const;
  /// Takes away what is not shown, and sets surfaces and opacities; `usual` is the view's.
  void apply(std::vector<SceneBody>& bodies, Surface usual);
  /// Unset if none of the bodies belongs to the object, or the object has no place.
  std::optional<Extent> extentOf(const std::string& path, const std::vector<SceneBody>& bodies,
                                 const SceneState& scene) const;
  /// The box on the ground around bodies, without flat ones, which are the ground; unset: there are none.
  static std::optional<SceneBox> boxAround(const std::vector<SceneBody>& bodies);

 private:
  void forgetFound();
  /// The look that counts for a body; unset: it is not shown.
  std::optional<ObjectLook> lookOf(const SceneBody& body);
  std::optional<ObjectLook> lookOf(const std::string& path) const;

  SceneObjects objects_;
  ObjectLooks looks_;
  std::string only_;
  int revision_ = 0;
  /// Keyed by the paths of bodies, which are kept so that no other has the same address.
  std::map<std::shared_ptr<const std::string>, std::optional<ObjectLook>> found_;
};

}  // namespace widgets
