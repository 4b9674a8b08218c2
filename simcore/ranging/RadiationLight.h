// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "simcore/rendering/BodyTree.h"
#include "simcore/rendering/RayBundle.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// Computes the radiation of classes that surfaces hit by rays send back; see RadiationClass. Lamps and
/// emitters cast shadows of all instances that cast any. One thread at a time.
class RadiationLight {
 public:
  explicit RadiationLight(std::shared_ptr<const RenderScene> scene);

  /// Sets the present poses of the bodies, which must stay valid until the last shade().
  void setPoses(std::span<const Pose3> bodyInWorld);
  /// Writes what each ray of a bundle senses, with the classes side by side: values has hits.size() *
  /// classes.size() elements. Rays without a hit sense the ambient intensity of declared classes, and of
  /// derived ones the color of the background.
  void shade(const RayBundle& rays, std::span<const BundleHit> hits, const Pose3& frameInWorld,
             const std::vector<std::string>& classes, std::span<float> values);

 private:
  /// A sensed class: a channel of the color, or an index of the declared classes, or both.
  struct Sensed {
    /// Coefficients for red, green and blue, and offset; without a channel all are 0.
    Eigen::Vector3f color = Eigen::Vector3f::Zero();
    float offset = 0;
    bool derived = false;
    int declared = -1;
  };
  /// A point on a surface, in the world.
  struct Point {
    Eigen::Vector3f position, normal;
  };
  /// The light that arrives from one place.
  struct Source {
    Eigen::Vector3f position;
    float attenuation = 0;
    /// Red, green and blue.
    Eigen::Vector3f intensity = Eigen::Vector3f::Zero();
    const std::vector<float>* intensities = nullptr;
    /// Null if it emits in all directions.
    const Lamp* lamp = nullptr;
  };
  Sensed sensedClass(const std::string& name) const;
  Point pointOf(const BundleHit& hit, const Eigen::Vector3d& direction, const Pose3& frame) const;
  /// Computes the light that arrives from each source, as a factor of its intensity.
  void light(const Point& point);
  bool isVisible(const Source& source, const Eigen::Vector3f& point) const;
  float valueOf(const Sensed& sensed, const RenderInstance* instance, std::size_t index) const;

  std::shared_ptr<const RenderScene> scene_;
  rendering::BodyTree tree_;
  RTCScene shadows_ = nullptr;
  std::span<const Pose3> poses_;
  std::vector<Source> sources_;
  /// Keyed by source, for the present point.
  std::vector<float> arriving_;
  /// How much of a color is seen at the present point, 0 to 1.
  Eigen::Vector3f brightness_ = Eigen::Vector3f::Ones();
  std::vector<Eigen::Vector3d> directions_;
};

}  // namespace simcore
