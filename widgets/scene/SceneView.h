// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "widgets/picture/PictureView.h"
#include "widgets/scene/CameraRide.h"
#include "widgets/scene/OwnModels.h"
#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/SceneCamera.h"
#include "widgets/world/ModelDrag.h"
#include "widgets/world/RobotBeliefs.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/StreamFigures.h"

class QAction;
class QLabel;

namespace robotcontrol {
class GroundMap;
}

namespace widgets {

class RobotChoice;
class SceneCanvas;
struct SceneCamera;

/// The world in three dimensions, with the robots' drawings. The camera orbits, pans, zooms and follows a
/// robot; robots and ball of a simulation can be placed with the mouse. Follows the session's timeline.
///
/// Registered as "scene". GUI thread.
class SceneView final : public PictureView {
  Q_OBJECT
 public:
  explicit SceneView(ViewContext& context, QWidget* parent = nullptr);
  ~SceneView() override;

  /// Shows the world at the shown instant and moves the camera along with a robot.
  void tick() override;
  /// Whether the drawing thread has drawn what the last tick has read.
  bool isPictureReady() const override;

 private:
  void createActions();
  /// Actions for the camera: reset, from above, behind, follow.
  void createCameraActions();
  void createViews();
  /// Adds the user's choices to the saved state.
  void keepChoices();
  /// `showDrawings` is its last button.
  QWidget* createToolRow(QAction* showDrawings);
  void connectSignals();
  void connectCamera();
  /// Sends keys and clicks to the simulation.
  void connectEvents();
  /// Connects dragging of models with ModelDrag.
  void connectDrag();

  /// Everything that the canvas shows.
  VisibleScene contents(const std::vector<RobotBelief>& beliefs);
  /// The dragged model at the pose to which it is dragged.
  std::vector<SceneBody> ghosts(const std::vector<SceneBody>& bodies) const;
  void showState(bool faded);
  /// Highlights the selected object of the scene tree, and adds its name where it is.
  void showSelection(std::vector<SceneLabel>& labels);
  void addNames(const std::vector<RobotBelief>& beliefs, std::vector<SceneLabel>& labels) const;
  /// Moves the camera along with the robot.
  void follow();
  /// Chooses how the camera follows: beside or behind the robot.
  void ride();
  /// Pose of the chosen robot; unset: unknown.
  std::optional<robotlink::Pose2> robotPose() const;
  /// The field or the map, as a box.
  SceneBox box() const;
  /// Reads the map that is shown.
  void followMap();
  /// Stops following the robot, because the user chose another camera.
  void letGo();
  void showContextMenu(const QPoint& at);

  SceneState scene_;
  StreamFigures streamFigures_;
  SceneAssembly assembly_;
  /// The robots that the scene does not show.
  OwnModels ownModels_;
  ModelDrag drag_;
  /// Null: the world has none.
  std::shared_ptr<const robotcontrol::GroundMap> map_;
  /// Extent of map_.
  std::optional<SceneBox> mapBox_;
  /// The robots in the last tick.
  std::vector<RobotBelief> beliefs_;
  CameraRide ride_;
  SceneCanvas* canvas_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel* state_ = nullptr;
  QAction *reset_ = nullptr, *fromAbove_ = nullptr, *behind_ = nullptr, *follow_ = nullptr;
  QAction *wireFrame_ = nullptr, *grid_ = nullptr, *labels_ = nullptr, *move_ = nullptr;
  QAction *sensors_ = nullptr, *send_ = nullptr;
};

}  // namespace widgets
