// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/scene/SceneAssembly.h"
#include "widgets/scene/gizmo/Gizmo.h"
#include "widgets/scene/gizmo/HandSpeed.h"
#include "widgets/scene/render/RenderThread.h"
#include "widgets/world/SceneEvent.h"

namespace widgets {

/// Shows pictures of a scene, and turns mouse and keys into movements of the camera and of models. It has
/// no session: the view sets what is shown and applies what the signals say. Pictures are drawn by a
/// RenderThread whenever something changed. Object name "sceneCanvas". GUI thread.
///
/// Mouse: drag to orbit, right or middle button or Shift to pan, wheel to zoom; dragging a movable model
/// moves it, and the wheel turns it then. A click selects, on the surroundings a double click; Esc selects
/// nothing. The handles of the gizmo move and turn what it is at; Control snaps
/// to a grid, Esc ends a drag as if there had been none. What is dragged from a ScenePalette is dropped.
/// While events are sent, the left button and the keys are those of the scene's controllers instead.
class SceneCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// `makeRenderer` is called in the drawing thread; tests replace it.
  explicit SceneCanvas(RenderThread::MakeRenderer makeRenderer = SceneRenderer::create,
                       QWidget* parent = nullptr);
  /// Waits for the picture that is being drawn.
  ~SceneCanvas() override;

  /// Call this 30 times a second even if nothing changed: after a call without a change a picture with
  /// smooth edges is requested.
  void setContents(VisibleScene contents);
  /// The models that can be dragged; without `always` only while Control is held.
  void setMovable(std::vector<std::string> models, bool always);
  /// Whether keys and the left button are reported by eventHappened() instead of moving camera and models.
  void setSendsEvents(bool sends) { sends_ = sends; }
  /// Highlights an object, with all that belongs to it, while nothing is under the cursor that a click would
  /// select; empty: none.
  void setSelected(const std::string& object);
  /// Shows the handles at an object; unset: none. While one is dragged its drag continues as it began.
  void setGizmo(const std::optional<Gizmo>& gizmo);
  /// Whether a handle or a model is being dragged.
  bool isDragging() const { return mode_ == Mode::kDragging || mode_ == Mode::kHandling; }
  /// The first thing at a place of the widget; unset: there is none.
  std::optional<SceneHit> hitAt(const QPointF& at) const;
  /// Whether what was hit belongs to the surroundings, see isSurroundings().
  bool isBackground(const SceneHit& hit) const;
  /// The place on the ground, or on an object there, at one of the widget; unset: there is none.
  std::optional<robotlink::Vector3> placeAt(const QPointF& at) const;
  /// A sentence at the upper edge; empty: none.
  void setNotice(const QString& text);
  /// A sentence in the middle while the scene is empty.
  void setHint(const QString& text);
  const QString& hint() const { return hint_; }

  const SceneCamera& camera() const { return camera_; }
  /// Ends the overview.
  void setCamera(const SceneCamera& camera);
  /// Shows the whole box, also when the widget's size changes, until the camera is moved.
  void setOverview(const SceneBox& box);
  /// Whether the camera shows the overview.
  bool overview() const { return overview_.has_value(); }
  /// Zooms around the middle.
  void zoomBy(double factor);
  void setGrid(bool grid);
  void setLabels(bool labels);

  /// The picture that is shown, with labels but without axes and sentences; null until the first picture.
  QImage rendered() const;
  /// The contents that were last set.
  const VisibleScene& contents() const { return contents_; }
  /// Whether the newest picture shows everything that was set.
  bool upToDate() const { return shown_.frame && shown_.frame == requested_; }
  /// Whether nothing can be drawn at all on this machine.
  bool hasFailed() const { return !thread_->error().empty(); }
  /// The name of the renderer; empty until it was created.
  std::string device() const { return thread_->device(); }
  QSize sizeHint() const override { return {640, 480}; }

 Q_SIGNALS:
  /// The user drags a model; positions are meters in the field's frame, in the horizontal plane through the
  /// point that was grabbed; turning is in rad, counterclockwise.
  void dragStarted(const QString& model, double x, double y);
  void dragMoved(double x, double y, bool isSnapping);
  void dragTurned(double angle);
  /// The velocity, m/s, is that of the mouse in that plane when the button was released; 0 if it was at rest.
  void dragEnded(double vx, double vy);
  void dragCanceled();
  /// A handle of the gizmo was dragged to a pose in the field's frame; then that ended.
  void gizmoMoved(const robotlink::Pose3& pose);
  void gizmoEnded(const robotlink::Pose3& pose);
  void gizmoCanceled();
  /// The user pressed and released the left button on a model without moving it. On the surroundings, such
  /// as a room, only a double click counts: they are below the mouse nearly always.
  void modelClicked(const QString& model);
  /// The user pressed Escape: nothing is to be selected.
  void nothingWanted();
  /// An object of a ScenePalette was dropped at a place of the ground, m.
  void dropped(const QString& kind, double x, double y);
  /// Only with setSendsEvents(): a key, or the left button with a ray in the field's frame, m.
  void eventHappened(const widgets::SceneEvent& event);

 protected:
  /// Shows what is drawn under the cursor as a tooltip.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// The action of the pressed button.
  enum class Mode : std::uint8_t { kIdle, kOrbiting, kPanning, kDragging, kHandling, kSending };

  /// Requests a picture; `smooth`: with several samples per pixel.
  void request(bool smooth = false);
  /// Requests a smooth picture when nothing changes any longer.
  void smoothen();
  /// Takes the thread's newest picture; called in the GUI thread.
  void takePicture();
  /// Colors for the palette in use.
  SceneFrame::Colors colors() const;
  /// The mode that a press begins; begins a drag if it is on a movable model.
  Mode modeFor(const QMouseEvent& event);
  /// False: there is no movable model.
  bool startDrag(const QPointF& at, Qt::KeyboardModifiers modifiers);
  /// Moves what is dragged after the mouse.
  void dragTo(const QPointF& at, Qt::KeyboardModifiers modifiers, std::uint64_t time);
  /// Ends the drag as if there had been none; false: there is none.
  bool cancelDrag();
  /// Paints the handles, and the numbers next to the mouse.
  void paintHand(QPainter& painter);
  /// Highlights an object instead of the selected one; empty: none.
  void highlight(const std::string& object);
  /// Highlights what a click would select here, with a hand where it can be dragged.
  void pointAt(const QPointF& at, Qt::KeyboardModifiers modifiers);
  /// Emits eventHappened() for the left button or for a key.
  void sendMouse(SceneEvent::Kind kind, const QPointF& at);
  void sendKey(SceneEvent::Kind kind, const QKeyEvent& event);
  /// Emits modelClicked() if a model is at the point that such a click selects.
  void click(const QPointF& at);
  /// Whether a drag of what is hit would move it.
  bool canDrag(const std::optional<SceneHit>& hit, Qt::KeyboardModifiers modifiers) const;

  VisibleScene contents_;
  /// The fixed models that are surroundings, as found since the last press or change of the scene: under a
  /// moving mouse they are not measured repeatedly.
  mutable std::map<std::string, bool> backgrounds_;
  std::vector<std::string> movable_;
  bool sends_ = false, moveAlways_ = true, grid_ = true, labels_ = true;
  QString notice_, hint_;
  SceneCamera camera_;
  /// Unset: the camera was moved.
  std::optional<SceneBox> overview_;
  std::string highlighted_, selected_;
  Mode mode_ = Mode::kIdle;
  /// Whether the mouse has moved since the press by more than a hand does during a click.
  bool moved_ = false;
  /// Whether the pressed button is that of a double click.
  bool isDoubleClick_ = false;
  QPointF pressed_;
  /// Height of the point that was grabbed, m.
  double dragHeight_ = 0;
  QPointF last_;
  std::optional<Gizmo> gizmo_;
  GizmoHandle hot_ = GizmoHandle::kNone;
  std::optional<GizmoDrag> gizmoDrag_;
  /// The speed of the mouse in the plane of a drag.
  HandSpeed speed_;
  /// Numbers of the drag; empty: none are shown.
  QString readout_;
  /// The newest request, and the picture that is shown.
  std::shared_ptr<const SceneFrame> requested_;
  RenderThread::Picture shown_;
  std::unique_ptr<RenderThread> thread_;
};

}  // namespace widgets
