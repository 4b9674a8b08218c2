// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "widgets/scene/render/SceneFrame.h"
#include "widgets/sceneedit/SceneEdits.h"

class QAction;
class QMenu;
class QPoint;
class QWidget;

namespace robotcontrol {
class Request;
class SimulationStatus;
}  // namespace robotcontrol

namespace widgets {

class SceneCanvas;
class ScenePalette;
class SceneState;
struct ViewContext;

/// Manipulates the objects of a scene view by mouse and keys: the handles at the selected object, the
/// menu of an object, throwing, pinning, adding, deleting, and one history of all of it (SceneEdits).
///
/// What moves in the simulation is moved there, by requests; what is fixed, such as a wall or a lamp, is
/// moved in the text of the scene, in which the simulation then continues. GUI thread.
class SceneHands final : public QObject {
  Q_OBJECT
 public:
  /// The canvas, the state and the view, which gets the actions, must outlive it.
  SceneHands(ViewContext& context, SceneCanvas& canvas, const SceneState& scene, QWidget& view);
  ~SceneHands() override;

  /// Shows the handles where the object is now, and sends what was moved. Called 30 times a second.
  void tick();
  /// The actions for the tools of the view.
  QAction* handles() const { return handles_; }
  QAction* ownAxes() const { return ownAxes_; }
  QAction* undo() const { return undo_; }
  QAction* redo() const { return redo_; }
  QAction* palette() const { return showPalette_; }
  /// Fills the menu of what is at a place of the canvas, and selects it.
  void fillMenu(QMenu& menu, const QPoint& at);
  /// The bodies of the object whose handle is dragged, at the place where it is dragged.
  std::vector<SceneBody> ghosts(const std::vector<SceneBody>& bodies) const;
  /// Says why the last action could not be done, or that it takes some time; empty: there is nothing to say.
  /// Cleared after some seconds.
  QString notice() const;

  /// A model is about to be dragged on the ground; then it was, to a pose, with the velocity (m/s) of the
  /// hand: while the simulation runs, what is let go of in motion is thrown.
  void beginDrag(const std::string& model);
  void endDrag(const std::string& model, const robotlink::Pose2& wanted, const robotlink::Vector2& velocity);
  void cancelDrag(const std::string& model);

 Q_SIGNALS:
  /// The camera is to follow a robot.
  void followWanted(const QString& robot);

 private:
  /// The selected object, as something that can be moved.
  struct Target {
    /// A model's name, or the path of a lamp.
    std::string object;
    robotlink::Pose3 pose;
    /// Whether the simulation moves it; else its text is changed.
    bool isLive = false;
  };
  std::optional<Target> target() const;
  void createActions(QWidget& view);
  void createMoreActions(QWidget& view);
  void connectSignals();
  void moveGizmo(const robotlink::Pose3& pose);
  void endGizmo(const robotlink::Pose3& pose);
  void cancelGizmo();
  /// Ends showing what was moved in the text there once the simulation has it there, or does not.
  void settle();
  /// Sends a request, and shows why it was refused.
  void ask(robotcontrol::Request request);
  /// Adds a step to the history that places a model.
  void addMove(const std::string& model, const robotlink::Pose3& before, const robotlink::Pose3& after);
  /// Reports why a change was not made; `done` is called if it was. Nothing happens once this is destroyed.
  SceneEdits::Told told(std::function<void(const std::string& object)> done);
  /// Selects the object.
  std::function<void(const std::string& object)> selecting();
  void insert(const QString& kind, double x, double y);
  void insertInView(const QString& kind);
  void duplicate();
  void erase();
  void rename();
  void write();
  /// Pins the selected object, or lets it go if it is pinned.
  void pin();
  /// Null: there is no simulation.
  const robotcontrol::SimulationStatus* status() const;
  void walk(bool isUndo);
  void showHistory();
  /// Runs a command of the window.
  void run(const char* command, const std::string& word);
  void report(const QString& text);
  SceneEdits& edits() const;

  ViewContext& context_;
  SceneCanvas& canvas_;
  const SceneState& scene_;
  ScenePalette* palette_ = nullptr;
  QAction *handles_ = nullptr, *ownAxes_ = nullptr, *undo_ = nullptr, *redo_ = nullptr;
  QAction *duplicate_ = nullptr, *erase_ = nullptr, *rename_ = nullptr, *write_ = nullptr, *pin_ = nullptr;
  QAction *goToText_ = nullptr, *properties_ = nullptr, *showPalette_ = nullptr;
  /// The object dragged by a handle, since its press.
  std::optional<Target> dragged_;
  /// The fixed object that was dragged, until its text is changed.
  std::optional<Target> settling_;
  robotlink::Pose3 wanted_ = robotlink::Pose3::Identity();
  bool unsent_ = false;
  /// The pose of the model that is dragged on the ground, before the drag.
  std::optional<robotlink::Pose3> ground_;
  QString notice_;
  int noticeTicks_ = 0;
  int settlingTicks_ = 0;
  /// For how long a change was not made yet.
  int busyTicks_ = 0;
};

}  // namespace widgets
