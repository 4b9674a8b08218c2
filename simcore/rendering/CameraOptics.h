// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "simcore/rendering/CameraRenderer.h"
#include "simcore/world/CameraModel.h"

namespace simcore {

/// Takes the images of a camera whose lens distorts them, or whose shutter takes time: what moves during the
/// exposure is blurred, and rows that are exposed later show a later instant. It renders the pinhole image of
/// several instants, at most kMaxInstants and one per millisecond, and mixes them row by row; what is
/// overexposed is so in each of them. For other cameras it calls the renderer only, with the same result.
///
/// One per camera, since it keeps the map of the lens from image to image. One thread at a time.
class CameraOptics {
 public:
  static constexpr int kMaxInstants = 16;

  /// The mounting of the camera on a body of the scene.
  struct Mount {
    int body = 0;
    Pose3 cameraInBody = Pose3::Identity();
  };
  /// Sets the poses of all bodies that many seconds before the instant of the image.
  using PosesAt = std::function<void(double age, std::vector<Pose3>& poses)>;

  /// Renders an image as CameraRenderer::render() does. The renderer is left with poses of the image.
  void render(CameraRenderer& renderer, const PosesAt& posesAt, const Mount& mount, const CameraModel& camera,
              const ShutterModel& shutter, robotlink::PixelFormat format, const ImageNoise& noise,
              robotlink::Image& image);

  /// Makes an image of labels (CameraRenderer::label) of the last image show what the lens shows,
  /// `background` where nothing is, with `width` columns.
  void distortLabels(std::uint8_t background, int width, robotlink::Image& labels) const;

  /// Returns where the lens shows what a pinhole camera shows at (x, y), in tangents; see LensDistortion.
  static Eigen::Vector2d distorted(const LensDistortion& lens, const Eigen::Vector2d& pinhole);
  /// The reverse; it is found by iteration, to 1e-9 where the lens does not fold the image.
  static Eigen::Vector2d undistorted(const LensDistortion& lens, const Eigen::Vector2d& seen);

 private:
  /// The origin of a pixel's color in the pinhole image: coordinates of pixels' centers; negative if
  /// nothing is there.
  struct Source {
    float x = 0, y = 0;
  };
  void prepareLens(const CameraModel& camera);
  /// Adds an image of one instant to the rows with the given weights.
  void accumulate(const robotlink::Image& pinhole, const std::vector<float>& weights);
  void finish(const CameraModel& camera, robotlink::PixelFormat format, robotlink::Image& image);

  /// The camera for which the map was made, and the pinhole camera that sees all that its lens shows.
  CameraModel camera_, pinhole_;
  bool prepared_ = false;
  std::vector<Source> sources_;
  // Buffers.
  std::vector<Pose3> poses_;
  std::vector<float> sums_;
  robotlink::Image instant_;
};

}  // namespace simcore
