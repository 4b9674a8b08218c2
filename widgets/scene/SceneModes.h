// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QObject>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "widgets/scene/render/SceneFrame.h"

class QAction;
class QMenu;

namespace widgets {

/// The layers of a scene view that can be shown or hidden.
enum class SceneLayer : std::uint8_t {
  kVisuals,
  kSolids,
  kForces,
  kJoints,
  kFrames,
  kCenters,
  kSensors,
  kNames,
  kShadows
};
inline constexpr int kSceneLayers = 9;

/// The names of layers in commands and saved layouts: visuals, solids, forces, joints, frames, centers,
/// sensors, names, shadows.
const char* nameOfLayer(SceneLayer layer);
std::optional<SceneLayer> layerNamed(const std::string& name);

/// The modes in which a view shows its scene, as actions with menus: how surfaces are drawn, and which layers
/// are shown. GUI thread.
class SceneModes final : public QObject {
  Q_OBJECT
 public:
  /// The actions belong to `view`, within which their keys work.
  explicit SceneModes(QWidget* view);

  Surface surface() const;
  void setSurface(Surface surface);
  bool shows(SceneLayer layer) const;
  void setShown(SceneLayer layer, bool shown);

  /// Menus for buttons; they belong to the view.
  QMenu* surfaces() const { return surfaces_; }
  QMenu* layers() const { return layers_; }
  /// Toggles between wire frame and shaded.
  QAction* wireFrame() const { return surfaceActions_[3]; }

  /// For saved window layouts. Unknown and missing entries are as at the start.
  QJsonObject state() const;
  void restore(const QJsonObject& state);

 Q_SIGNALS:
  void changed();

 private:
  void createSurfaces(QWidget* view);
  void createLayers(QWidget* view);

  /// Keyed by Surface and by SceneLayer.
  std::array<QAction*, 4> surfaceActions_{};
  std::array<QAction*, kSceneLayers> layerActions_{};
  QMenu *surfaces_ = nullptr, *layers_ = nullptr;
};

}  // namespace widgets
