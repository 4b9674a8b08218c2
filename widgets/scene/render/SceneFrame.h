// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QSize>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/drawings/DrawingTip.h"
#include "widgets/scene/render/SceneCamera.h"
#include "widgets/scene/render/SceneLight.h"
#include "widgets/scene/render/SceneMesh.h"

namespace widgets {

/// The way in which the surfaces of a body are drawn.
enum class Surface : std::uint8_t {
  /// Lit, smooth where its triangles meet at small angles.
  kShaded,
  /// Lit, each triangle in one color.
  kFlat,
  /// Its edges, as far as no surface hides them.
  kHiddenLines,
  /// All its edges.
  kWire
};

/// A shape with its pose in the field's frame.
struct SceneBody {
  std::shared_ptr<const SceneShape> shape;
  robotlink::Pose3 inField = robotlink::Pose3::Identity();
  /// The model that it belongs to; empty: it cannot be moved and casts no shadow.
  std::string model;
  /// Below 1 for drawings of earlier frames, and for bodies that are to be seen through.
  float opacity = 1;
  /// The text of a tooltip about a drawing, besides what is under the cursor.
  DrawingHit drawing = {};
  /// Only of bodies.
  Surface surface = Surface::kShaded;
  /// The path of the object of the scene that it shows ("red1/link:head/visual:nose"); null: not known.
  std::shared_ptr<const std::string> object = {};

  /// Whether both look alike.
  bool operator==(const SceneBody& other) const {
    return shape == other.shape && model == other.model && opacity == other.opacity &&
           surface == other.surface && inField.matrix() == other.inField.matrix();
  }
};

/// Whether a body belongs to an object of the scene, or is part of its model.
inline bool isPartOf(const SceneBody& body, const std::string& object) {
  if (object.empty()) return false;
  if (body.model == object) return true;
  return body.object && body.object->starts_with(object) &&
         (body.object->size() == object.size() || (*body.object)[object.size()] == '/');
}

/// A text at a place, painted over the finished picture.
struct SceneLabel {
  robotlink::Vector3 inField = robotlink::Vector3::Zero();
  QString text;
  QColor color;
  /// Height of the font: positive in pixels, negative in meters.
  double size = 11;
  /// Whether it is centered on a dark rectangle, as names are.
  bool boxed = false;

  bool operator==(const SceneLabel&) const = default;
};

/// Everything that is visible in the world.
struct VisibleScene {
  /// The world and the models in it.
  std::vector<SceneBody> bodies;
  /// Drawings of the robots, lowest first.
  std::vector<SceneBody> drawings;
  /// The collision shapes, as edges over everything: faint where they are hidden.
  std::vector<SceneBody> solids;
  /// Axes, arrows and the like, which nothing hides.
  std::vector<SceneBody> markers;
  /// Whether models cast shadows onto the ground.
  bool shadows = true;
  /// Models where the user wants to place them, shown translucent.
  std::vector<SceneBody> ghosts;
  /// Whether the ghosts cannot be placed there.
  bool refused = false;
  /// The light that falls on bodies; drawings have their own.
  SceneLight light;
  /// Texts, painted over the picture.
  std::vector<SceneLabel> labels;

  bool operator==(const VisibleScene&) const = default;
};

/// A request for a picture: everything that the renderer needs; immutable once its thread has it.
struct SceneFrame {
  /// Colors that depend on the palette.
  struct Colors {
    QColor skyTop, skyBottom;
    QColor grid;
    /// Contrasts with the sky.
    QColor ink;
    QColor highlight;
    /// The edges of what is highlighted and cannot be moved, on surfaces of any color.
    QColor outline;
    QColor ghost, refused;
  };

  /// Size of the picture in device pixels.
  QSize pixels;
  /// Device pixels per logical pixel.
  double pixelRatio = 1;
  SceneCamera camera;
  Colors colors;
  bool grid = true;
  VisibleScene contents;
  /// The path of an object, with all that belongs to it; empty: none. What can be moved is tinted, the rest
  /// gets an outline: floors and walls keep their colors.
  std::string highlighted;
  /// Whether the picture is drawn with several samples per pixel, which takes more than three times as long
  /// in software; else the edges of the finished picture are smoothed.
  bool smooth = false;
  /// Whether the user is moving the camera or a model, so that more processor time may be used.
  bool hurry = false;
};

}  // namespace widgets
