// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QSize>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/scene/SceneCamera.h"
#include "widgets/scene/SceneLight.h"
#include "widgets/scene/SceneMesh.h"

namespace widgets {

/// Something in the world: a shape and where it is.
struct SceneBody {
  std::shared_ptr<const SceneShape> shape;
  robotlink::Pose3 inField = robotlink::Pose3::Identity();
  std::string model;  ///< that it is part of; empty: it can not be moved and throws no shadow
  float opacity = 1;  ///< below 1 for drawings of earlier frames

  bool operator==(const SceneBody& other) const {
    return shape == other.shape && model == other.model && opacity == other.opacity &&
           inField.matrix() == other.inField.matrix();
  }
};

/// A text at a place, written over the finished picture.
struct SceneLabel {
  robotlink::Vector3 inField = robotlink::Vector3::Zero();
  QString text;
  QColor color;
  double size = 11;    ///< positive: pixels; negative: metres
  bool boxed = false;  ///< on a dark plate, centred: the name of something

  bool operator==(const SceneLabel&) const = default;
};

/// What there is to be seen.
struct SceneContents {
  std::vector<SceneBody> bodies;
  std::vector<SceneBody> drawings;
  std::vector<SceneBody> ghosts;  ///< where something is wanted; shown translucent
  bool refused = false;           ///< it cannot be there
  SceneLight light;               ///< that falls on the bodies; drawings shine by themselves
  std::vector<SceneLabel> labels;

  bool operator==(const SceneContents&) const = default;
};

/// A picture that is wanted: everything that the renderer needs to know, once handed over immutable.
struct SceneFrame {
  struct Colors {
    QColor skyTop, skyBottom;
    QColor grid;
    QColor ink;  ///< contrasts with the sky
    QColor highlight;
    QColor ghost, refused;
  };

  QSize pixels;           ///< of the device
  double pixelRatio = 1;  ///< of the device to Qt's logical pixels
  SceneCamera camera;
  Colors colors;
  bool wireFrame = false;
  bool grid = true;
  SceneContents contents;
  std::string highlighted;  ///< a model
  /// With several samples a pixel, which costs a processor more than three times as much; else the edges of
  /// the finished picture are smoothed.
  bool smooth = false;
  bool hurry = false;  ///< somebody moves the camera or a model: be quick rather than thrifty
};

}  // namespace widgets
