// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "simcore/rendering/CameraRenderer.h"

namespace simcore::test {

/// A test scene with the poses of its bodies and some cameras.
struct CameraScene {
  std::shared_ptr<const RenderScene> scene;
  std::vector<Pose3> poses;
  std::vector<Pose3> cameras;
};

/// A pixel of an image of 8-bit RGB.
robotlink::Rgb pixel(const robotlink::Image& image, int x, int y);

/// A camera at a place that looks at another, upright.
Pose3 lookAt(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// The field of 2002 with lines, walls, goals, beacons, a ball and eight four-legged robots of 40 round parts
/// each, about 14,400 triangles; the cameras are those in the robots' heads.
CameraScene fieldScene();

/// Some boxes and round bodies on a floor under two lamps, with cameras around, above, and very close to
/// them.
CameraScene tableScene();

}  // namespace simcore::test
