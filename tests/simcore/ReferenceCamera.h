// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "simcore/rendering/CameraRenderer.h"

namespace simcore::test {

/// The reference for CameraRenderer, implemented with Embree: one ray per pixel, in packets of eight, and one
/// from each lamp to the point that it hits. It shares no code with the renderer except for the scene. Images
/// are RGB.
class ReferenceCamera {
 public:
  ReferenceCamera(std::shared_ptr<const RenderScene> scene, bool shadows);
  ~ReferenceCamera();
  ReferenceCamera(const ReferenceCamera&) = delete;
  ReferenceCamera& operator=(const ReferenceCamera&) = delete;

  void setPoses(std::span<const Pose3> bodyInWorld);
  void render(const Pose3& cameraInWorld, const CameraModel& camera, robotlink::Image& image);

 private:
  struct Hits;
  RTCScene newMeshScene(const Mesh& mesh);
  void trace(const Pose3& cameraInWorld, const CameraModel& camera, int x, int y, Hits& hits);
  void retraceBackFaces(Hits& hits);
  void fetchNormals(Hits& hits) const;
  void addLamp(const Lamp& lamp, Hits& hits);

  std::shared_ptr<const RenderScene> scene_;
  bool shadows_;
  RTCDevice device_;
  RTCScene seen_;
  RTCScene casting_;
  std::vector<RTCScene> meshScenes_;
  /// Indexed by instance; the latter may be null.
  std::vector<RTCGeometry> seenInstances_, castingInstances_;
  std::vector<Eigen::Matrix3f> rotations_;
};

}  // namespace simcore::test
