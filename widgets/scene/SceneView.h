// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "widgets/View.h"
#include "widgets/models/ModelDrag.h"
#include "widgets/models/RobotBeliefs.h"
#include "widgets/models/SceneState.h"
#include "widgets/scene/CameraRide.h"
#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/SceneCamera.h"

class QAction;
class QLabel;
class QSplitter;

namespace robotcontrol {
class GroundMap;
}

namespace widgets {

class DrawingsModel;
class RobotChoice;
class SceneCanvas;
struct SceneCamera;

/// The world in three dimensions, with what the robots draw into it. The camera turns around, moves, zooms
/// and follows a robot; robots and ball of a simulation can be placed with the mouse. Follows the session's
/// time line.
class SceneView final : public View {
  Q_OBJECT
 public:
  explicit SceneView(ViewContext& context, QWidget* parent = nullptr);
  ~SceneView() override;

  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

  /// Writes what is seen as PNG. False, with a message shown, if that fails.
  bool savePicture(const QString& file);

 private:
  void createActions();
  void createCameraActions();
  void createViews();
  QWidget* createToolRow();
  void connectSignals();
  void connectCamera();
  void connectDrag();

  SceneContents contents(const std::vector<RobotBelief>& beliefs);
  std::vector<SceneBody> ghosts(const std::vector<SceneBody>& bodies) const;
  void showState(bool faded);
  void addNames(const std::vector<RobotBelief>& beliefs, std::vector<SceneLabel>& labels) const;
  /// Takes the camera along with the robot.
  void follow();
  void ride();
  std::optional<robotlink::Pose2> robotPose() const;
  SceneBox box() const;
  void followMap();
  void letGo();
  void showContextMenu(const QPoint& at);

  SceneState scene_;
  SceneAssembly assembly_;
  ModelDrag drag_;
  std::shared_ptr<const robotcontrol::GroundMap> map_;
  std::optional<SceneBox> mapBox_;  // of map_
  std::vector<RobotBelief> beliefs_;
  CameraRide ride_;
  DrawingsModel* drawings_ = nullptr;
  SceneCanvas* canvas_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel* state_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QAction *reset_ = nullptr, *fromAbove_ = nullptr, *behind_ = nullptr, *follow_ = nullptr;
  QAction *zoomIn_ = nullptr, *zoomOut_ = nullptr;
  QAction *wireFrame_ = nullptr, *grid_ = nullptr, *labels_ = nullptr, *move_ = nullptr,
          *showDrawings_ = nullptr;
  QAction *copy_ = nullptr, *save_ = nullptr;
};

}  // namespace widgets
