// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "simcore/world/CameraModel.h"
#include "simcore/world/Lighting.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// Draws a RenderScene on the CPU: a visibility buffer (AVX2 where the processor has it, the same arithmetic
/// without), lighting per pixel, shadows by Embree rays. No GPU, no display. The same inputs give the same
/// bytes.
///
/// Triangles are seen from their outer sides only, so a camera inside of a closed mesh looks out of it. There
/// is no near plane. Coplanar surfaces of different instances must be 1 mm or more apart. A point on a
/// triangle that faces away from a lamp is in its own shadow; other casters shade it where they cut the line
/// to the lamp, up to 0.02 % of its length before the point. Where the shadow rays of four neighbouring
/// pixels agree, those between take their word, so that a shadow narrower than two pixels may have gaps.
///
/// One thread at a time may use a renderer; several renderers may share a scene. Nothing is allocated by
/// render() once it has drawn an image of the same size.
class CameraRenderer {
 public:
  enum class Arithmetic {
    kFastest,   ///< the widest instructions that both program and processor know
    kPortable,  ///< the same without special instructions, and so the same bytes
  };
  struct Options {
    bool shadows = true;
    Arithmetic arithmetic = Arithmetic::kFastest;
  };
  CameraRenderer(std::shared_ptr<const RenderScene> scene, Options options);
  ~CameraRenderer();
  CameraRenderer(const CameraRenderer&) = delete;
  CameraRenderer& operator=(const CameraRenderer&) = delete;

  /// Where the bodies are now, by body index; at first all are at the origin. The world, body 0, stays there.
  /// What follows from the poses is worked out once, by the next render(), for all images until the next
  /// call.
  void setPoses(std::span<const Pose3> bodyInWorld);

  /// Another light than the scene's, from the next image on.
  void setLighting(const Lighting& lighting);

  /// Draws into `image`, whose size and format (kYuyv or kRgb8) are made those of `camera` and `format`.
  /// Chroma is the mean of a pair's; a Yuyv image of odd width lacks the last column, as such images have
  /// none.
  void render(const Pose3& cameraInWorld, const CameraModel& camera, robotlink::PixelFormat format,
              const ImageNoise& noise, robotlink::Image& image);

  /// What the last image shows, whatever its light, noise and lens: a kMono8 image of its size with
  /// labels[i] where the pixel's centre sees instance i of the scene, else `background`. Instances past the
  /// end of `labels` are background, too. Little work, as nothing is drawn anew; empty before the first
  /// image.
  void label(std::span<const std::uint8_t> labels, std::uint8_t background, robotlink::Image& image);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
