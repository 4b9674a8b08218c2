// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <functional>
#include <string>
#include <vector>

#include "robotlink/base/Image.h"
#include "robotlink/debugging/drawing/Drawings.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

/// A bench with the soccer robot "red1" on the field of 2002: images, drawings, a scene, poses. Requests are
/// answered at once.
class FieldBench : public Bench {
 public:
  using FramePart = std::function<void(robotcontrol::DebugQueue&)>;

  FieldBench() : Bench({.robots = {"red1"}, .answers = true, .field = true}) {}

  /// An image of uniform color, with one pixel of another color.
  void pushImage(const std::string& path, QSize size, robotlink::YCbCr color, QPoint spot = {},
                 robotlink::YCbCr spotColor = {});
  /// A frame of the process "cognition" with these drawings, which replaces the previous ones.
  void pushFrame(const std::vector<FramePart>& parts);
  /// The scene: ground, a wall, the robot (a box) and the ball.
  void pushScene();
  void pushPoses(const robotlink::Pose2& robot, const robotlink::Vector2& ball);
  void pushEstimates(const robotlink::Pose2& robot, const robotlink::Vector2& ballInRobot);

 private:
  std::uint64_t frame_ = 0;
};

/// Parts of a frame: the drawing of a debug key with this name.
FieldBench::FramePart imageDrawing(const std::string& key,
                                   const std::function<void(robotlink::ImageDrawing&)>& draw);
/// `kind` is "field" or "robot"; `frame` is the frame of the coordinates.
FieldBench::FramePart worldDrawing(const std::string& kind, const std::string& key, const std::string& frame,
                                   const std::function<void(robotlink::SceneDrawing&)>& draw);

/// A drawing of the field that no correct program makes: indices past the end, and NaN.
FieldBench::FramePart damagedDrawing(const std::string& key, const std::string& frame);

}  // namespace widgets::test
