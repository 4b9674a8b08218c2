// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "colortool/ColorTable.h"
#include "colortool/Regions.h"
#include "modules/perception/BodyPosture.h"
#include "modules/perception/CameraView.h"
#include "modules/perception/FieldLandmarks.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/rendering/CameraRenderer.h"

namespace modules {

/// Images of the real scene resources/scenes/field2002.sdf from any place, without physics: the ball and a
/// camera, which has no robot around it, are put where a test wants them. Light, shadows and noise are the
/// scene's.
class FieldCamera {
 public:
  FieldCamera();

  const robotlink::FieldDescription& field() const { return field_; }
  const colortool::ColorClasses& classes() const { return classes_; }
  const colortool::ColorTable& table() const { return table_; }

  /// m, in the field.
  void putBall(const robotlink::Vector2& place, double height = 0.042);
  /// Shows the robot of the scene at a place; it is hidden at first.
  void putRobot(const robotlink::Pose2& place);
  /// The camera of a robot in its stance.
  static CameraView view(const NeckAngles& neck);
  /// Kept until the next call.
  const robotlink::Image& look(const robotlink::Pose2& robotInField, const CameraView& view);
  /// The regions of the last image; of one class only, if it is named.
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
