// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "widgets/scene/render/SceneFrame.h"

namespace robotcontrol {
class WorldObject;
}

namespace widgets {

class SceneObjects;
class SceneState;

/// A predicate that selects the objects that get markers.
using ObjectFilter = std::function<bool(const std::string& path)>;

/// Joints, frames and centers of mass of a simulated scene, as bodies that nothing hides. Their size follows
/// the mass of the model. Shapes are made once and shared. GUI thread.
class SceneMarkers {
 public:
  /// The maximum number of objects with markers.
  static constexpr std::size_t kMaxMarkers = 3000;

  /// An arrow along the axis about which a joint turns or along which it slides, a sphere for balls, a box
  /// for fixed joints.
  std::vector<SceneBody> joints(const SceneObjects& objects, const SceneState& scene,
                                const ObjectFilter& isShown);
  /// The axes of models and links: x red, y green, z blue.
  std::vector<SceneBody> frames(const SceneObjects& objects, const SceneState& scene,
                                const ObjectFilter& isShown);
  /// A sphere at the center of mass of each link, the larger the heavier.
  std::vector<SceneBody> centers(const SceneObjects& objects, const SceneState& scene,
                                 const ObjectFilter& isShown);

 private:
  enum class Kind : std::uint8_t { kAxis, kSlide, kBall, kFixed, kFrame, kCenter };
  using Shape = std::shared_ptr<const SceneShape>;
  /// `size` in meters; rounded, so that few shapes are made.
  const Shape& shape(Kind kind, double size);
  /// A suitable size for markers of a model, m.
  static double sizeFor(const SceneObjects& objects, const std::string& model);
  /// Adds the marker of a joint.
  void addJoint(const robotcontrol::WorldObject& joint, const robotlink::Pose3& inField, double size,
                std::vector<SceneBody>& bodies);

  /// Keyed by kind and size in millimeters.
  std::map<std::pair<Kind, int>, Shape> shapes_;
};

/// The names of joints at their places.
std::vector<SceneLabel> jointNames(const SceneObjects& objects, const SceneState& scene,
                                   const ObjectFilter& isNamed);
/// The names of models that are no robots, at their places; of at most kMaxNames.
std::vector<SceneLabel> modelNames(const SceneObjects& objects, const SceneState& scene,
                                   const ObjectFilter& isNamed);
inline constexpr std::size_t kMaxNames = 300;

}  // namespace widgets
