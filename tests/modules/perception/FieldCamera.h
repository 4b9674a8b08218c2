// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "colortool/image/Regions.h"
#include "colortool/table/ColorTable.h"
#include "modules/perception/BodyPosture.h"
#include "modules/perception/CameraView.h"
#include "modules/perception/FieldLandmarks.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraRenderer.h"

namespace modules {

/// Images of the scene resources/scenes/field2002.sdf from any place, without physics: the test places the
/// ball and a camera, which has no robot around it. Light, shadows and noise are those of the scene.
class FieldCamera {
 public:
  FieldCamera();

  const robotlink::FieldDescription& field() const { return field_; }
  const colortool::ColorClasses& classes() const { return classes_; }
  const colortool::ColorTable& table() const { return table_; }

  /// In m, in the field's frame.
  void putBall(const robotlink::Vector2& place, double height = 0.042);
  /// Shows the robot of the scene at a place; initially it is hidden.
  void putRobot(const robotlink::Pose2& place);
  /// The camera of a standing robot.
  static CameraView view(const NeckAngles& neck);
  /// Renders an image, which is valid until the next call.
  const robotlink::Image& look(const robotlink::Pose2& robotInField, const CameraView& view);
  /// The regions of the last image, optionally of one class only.
  std::vector<colortool::Region> regions(std::string_view className = {});

 private:
  std::size_t body(const std::string& name) const;

  robotlink::FieldDescription field_;
  colortool::ColorClasses classes_;
  colortool::ColorTable table_;
  std::unique_ptr<simcore::Simulation> simulation_;
  std::shared_ptr<const simcore::RenderScene> scene_;
  std::vector<robotlink::Pose3> poses_;
  std::unique_ptr<simcore::CameraRenderer> renderer_;
  robotlink::Image image_;
  std::uint64_t frame_ = 0;
};

}  // namespace modules
