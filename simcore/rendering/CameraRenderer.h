// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "simcore/world/CameraModel.h"
#include "simcore/world/LightAdjustment.h"
#include "simcore/world/RenderScene.h"

namespace simcore {

/// Renders a RenderScene on the CPU: a visibility buffer (AVX2 if the processor has it, otherwise the same
/// arithmetic without it), lighting per pixel, shadows by Embree rays. It needs no GPU and no display. The
/// same inputs give the same bytes; only where a processor without AVX2 traces the rays, edges of shadows may
/// differ.
///
/// Only the outer sides of triangles are visible, so a camera inside a closed mesh sees through it. There is
/// no near plane. Coplanar surfaces of different instances must be at least 1 mm apart. A point on a triangle
/// that faces away from a lamp is in its own shadow; other casters shade it if they cut the line to the lamp,
/// up to 0.02 % of its length before the point. Where the shadow rays of four neighboring pixels agree, the
/// pixels between them take their result, so a shadow narrower than two pixels may have gaps.
///
/// One thread at a time may use a renderer; several renderers may share a scene, or with another() also the
/// poses. render() allocates nothing once it has drawn an image of the same size.
class CameraRenderer {
 public:
  /// Selects the instructions to use; for tests.
  enum class Arithmetic {
    /// The widest instructions that both program and processor support.
    kFastest,
    /// No special instructions; gives the same bytes.
    kPortable,
  };
  /// Fixed for the life of a renderer.
  struct Options {
    /// Without shadows, rendering is faster.
    bool shadows = true;
    Arithmetic arithmetic = Arithmetic::kFastest;
    /// Round shapes are lit triangle by triangle instead of smoothly.
    bool flat = false;
  };
  CameraRenderer(std::shared_ptr<const RenderScene> scene, Options options);
  ~CameraRenderer();
  CameraRenderer(const CameraRenderer&) = delete;
  CameraRenderer& operator=(const CameraRenderer&) = delete;

  /// Makes a renderer of the same scene that shares all but light and image with this one: setPoses() of
  /// either is for both. After place(), each may render in a thread of its own until the next setPoses().
  std::unique_ptr<CameraRenderer> another() const;
  /// Computes what follows from the poses, which otherwise the next image does.
  void place();

  /// Sets the present poses of the bodies by body index; initially all are at the origin. Body 0, the world,
  /// stays there. Derived data are computed once, by the next render(), for all images until the next call.
  void setPoses(std::span<const Pose3> bodyInWorld);

  /// Modifies the scene's light from the next image on.
  void setLighting(const LightAdjustment& lighting);

  /// Renders an image from a pose in the world. `image` gets the size of `camera` and the format (kYuyv or
  /// kRgb8). Chroma is the mean of a pair of pixels; a kYuyv image of odd width lacks the last column,
  /// because its width must be even.
  void render(const Pose3& cameraInWorld, const CameraModel& camera, robotlink::PixelFormat format,
              const ImageNoise& noise, robotlink::Image& image);

  /// Draws without light: sets depth[y * width + x] to the depth of what the center of a pixel sees along the
  /// optical axis, m, infinity if there is nothing; `depth` has width * height elements. The lens has no
  /// influence. Afterwards label() and labelValues() label this image.
  void renderDepth(const Pose3& cameraInWorld, const CameraModel& camera, std::span<float> depth);
  /// Works like label(), but with any numbers, into an array like that of renderDepth().
  void labelValues(std::span<const float> labels, float background, std::span<float> image);
  /// Adds noise to an image that was made of rendered ones, as render() does.
  void addNoise(const ImageNoise& noise, robotlink::Image& image) const;

  /// Labels the last image: a kMono8 image of its size with labels[i] where the center of a pixel sees
  /// instance i of the scene, otherwise `background`; also `background` for instances beyond the end of
  /// `labels`. Light, noise and lens have no influence. Cheap, because nothing is rendered again; empty
  /// before the first image.
  void label(std::span<const std::uint8_t> labels, std::uint8_t background, robotlink::Image& image);

 private:
  class Implementation;
  explicit CameraRenderer(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace simcore
