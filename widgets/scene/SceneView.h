// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "widgets/picture/PictureView.h"
#include "widgets/scene/CameraRide.h"
#include "widgets/scene/OwnModels.h"
#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/SceneLayers.h"
#include "widgets/scene/ShownParts.h"
#include "widgets/scene/render/SceneCamera.h"
#include "widgets/world/ModelDrag.h"
#include "widgets/world/RobotBeliefs.h"
#include "widgets/world/SceneState.h"
#include "widgets/world/StreamFigures.h"

class QAction;
class QLabel;
class QMenu;

namespace robotcontrol {
class GroundMap;
}

namespace widgets {

class RobotChoice;
class SceneCanvas;
class SceneModes;
class SceneHands;
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
  /// The poses of the models: their paths, positions and angles.
  std::optional<QString> numbers() override;

  /// The way in which a camera follows an object.
  enum class Following : std::uint8_t { kOff, kPosition, kHeading, kFirstPerson };
  /// Hides an object with all that belongs to it. Fails if the scene has none of this path; so do the others.
  robotlink::Result<void> hideObject(const std::string& path);
  /// Shows it again; empty: everything.
  robotlink::Result<void> showObject(const std::string& path);
  /// Draws an object as a surface (shaded, ...), or as the view does ("view"); of an empty path the view.
  robotlink::Result<void> drawObject(const std::string& path, const std::string& surface);
  /// 1: not seen through.
  robotlink::Result<void> setOpacity(const std::string& path, double opacity);
  /// Shows or leaves out a layer by its name.
  robotlink::Result<void> showLayer(const std::string& layer, bool shown);
  /// Moves the camera with an object, or looks out of it; empty: with the robot of the view.
  robotlink::Result<void> followObject(const std::string& path, Following how);
  /// Looks at an object and follows it; `alone`: everything else is left out. Empty: ends that.
  robotlink::Result<void> showOnly(const std::string& path, bool alone);
  /// The paths of all objects, for completion.
  std::vector<std::string> objectPaths() const;
  /// The paths of those that showObject() would change: what is hidden, and what has hidden parts.
  std::vector<std::string> hiddenPaths() const;

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
  void showSelection(const std::vector<SceneBody>& bodies, std::vector<SceneLabel>& labels);
  /// The selected object or, where it has no shape, the nearest one above that has.
  std::string highlighted(const std::vector<SceneBody>& bodies) const;
  void addNames(const std::vector<RobotBelief>& beliefs, std::vector<SceneLabel>& labels) const;
  /// Moves the camera along with the robot.
  void follow();
  /// Chooses how the camera follows: next to or behind the robot.
  void ride();
  /// Pose of the chosen robot; unset: unknown.
  std::optional<robotlink::Pose2> robotPose() const;
  /// The field or the map, as a box.
  SceneBox box() const;
  /// Looks once at how large the scene is.
  void measure(const std::vector<SceneBody>& bodies);
  /// Reads the map that is shown.
  void followMap();
  /// Stops following the robot, because the user chose another camera.
  void letGo();
  void showContextMenu(const QPoint& at);

  // SceneViewObjects.cpp:
  /// Adds what can be done with an object below the mouse, and with what it belongs to.
  void addObjectMenus(QMenu& menu, const std::string& path);
  QMenu* makeObjectMenu(const std::string& path, QWidget* parent);
  /// Fails if there is no such object.
  robotlink::Result<void> require(const std::string& path) const;
  /// The subject that the camera follows; unset: its pose is unknown.
  std::optional<CameraRide::Subject> subject();
  /// Looks out of what is followed.
  void lookOut();
  /// Ends that, as the camera was before.
  void endLookingOut();
  /// Shows only an object; empty: all. Says so in the title.
  void limitTo(const std::string& path);
  void keepObjects();

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
  /// The box around the bodies of a scene that has neither field nor map; unset: not known yet.
  std::optional<SceneBox> sceneBox_;
  bool isMeasured_ = false;
  /// The robots in the last tick.
  std::vector<RobotBelief> beliefs_;
  CameraRide ride_;
  ShownParts parts_;
  SceneLayers layers_;
  SceneModes* modes_ = nullptr;
  /// The object that the camera follows; empty: the robot that is chosen.
  std::string followed_;
  /// Its size; unset: not measured yet.
  std::optional<ShownParts::Extent> extent_;
  /// The camera before the first person.
  std::optional<SceneCamera> before_;
  SceneCanvas* canvas_ = nullptr;
  SceneHands* hands_ = nullptr;
  RobotChoice* robots_ = nullptr;
  QLabel* state_ = nullptr;
  QAction *reset_ = nullptr, *fromAbove_ = nullptr, *behind_ = nullptr, *follow_ = nullptr;
  QAction *firstPerson_ = nullptr, *grid_ = nullptr, *labels_ = nullptr, *move_ = nullptr;
  QAction *sensors_ = nullptr, *send_ = nullptr;
};

}  // namespace widgets
