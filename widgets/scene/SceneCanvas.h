// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/scene/RenderThread.h"
#include "widgets/world/SceneEvent.h"

namespace widgets {

/// Shows pictures of a scene, and turns mouse and keys into movements of the camera and of models. It knows
/// no session: the view sets what is shown and applies what the signals say. Pictures are drawn by a
/// RenderThread whenever something changed. Object name "sceneCanvas". GUI thread.
///
/// Mouse: drag to orbit, right or middle button or Shift to pan, wheel to zoom; dragging a movable model
/// moves it, and the wheel turns it then. While events are sent, the left button and the keys are those of
/// the scene's controllers instead.
class SceneCanvas final : public QWidget {
  Q_OBJECT
 public:
  /// `makeRenderer` is called in the drawing thread; tests replace it.
  explicit SceneCanvas(RenderThread::MakeRenderer makeRenderer = SceneRenderer::create,
                       QWidget* parent = nullptr);
  /// Waits for the picture that is being drawn.
  ~SceneCanvas() override;

  /// To be called 30 times a second even if nothing changed: after a call without a change a picture with
  /// smooth edges is requested.
  void setContents(VisibleScene contents);
  /// The models that can be dragged; without `always` only while Control is held.
  void setMovable(std::vector<std::string> models, bool always);
  /// Whether keys and the left button are reported by eventHappened() instead of moving camera and models.
  void setSendsEvents(bool sends) { sends_ = sends; }
  bool sendsEvents() const { return sends_; }
  /// Highlights a model while no other one is under the cursor; empty: none.
  void setSelected(const std::string& model);
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
  bool wireFrame() const { return wireFrame_; }
  void setWireFrame(bool wireFrame);
  void setGrid(bool grid);
  void setLabels(bool labels);

  /// What is shown, with labels but without axes and sentences; null until the first picture.
  QImage rendered() const;
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
  void dragMoved(double x, double y);
  void dragTurned(double angle);
  void dragEnded();
  /// The user pressed and released the left button on a model without moving it.
  void modelClicked(const QString& model);
  /// Only with setSendsEvents(): a key, or the left button with a ray in the field's frame, m.
  void eventHappened(const widgets::SceneEvent& event);

 protected:
  /// Shows what is drawn under the cursor as a tool tip.
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  /// What the pressed button does.
  enum class Mode : std::uint8_t { kIdle, kOrbiting, kPanning, kDragging, kSending };

  /// Requests a picture; `smooth`: with several samples per pixel.
  void request(bool smooth = false);
  /// Requests a smooth picture once nothing changes any more.
  void smoothen();
  /// Takes the thread's newest picture; called in the GUI thread.
  void takePicture();
  /// Colors for the palette in use.
  SceneFrame::Colors colors() const;
  /// What a press begins; begins a drag if it is on a movable model.
  Mode modeFor(const QMouseEvent& event);
  /// False: there is no movable model.
  bool startDrag(const QPointF& at, Qt::KeyboardModifiers modifiers);
  /// Highlights a model; empty: none.
  void highlight(const std::string& model);
  /// Emits eventHappened() for the left button or for a key.
  void sendMouse(SceneEvent::Kind kind, const QPointF& at);
  void sendKey(SceneEvent::Kind kind, const QKeyEvent& event);
  /// Emits modelClicked() if a model is at the point.
  void click(const QPointF& at);
  /// The model that a drag from here would move; empty: none. `point` gets the point that is hit, in the
  /// field's frame.
  std::string movableAt(const QPointF& at, Qt::KeyboardModifiers modifiers,
                        robotlink::Vector3* point = nullptr) const;

  VisibleScene contents_;
  std::vector<std::string> movable_;
  bool sends_ = false, moveAlways_ = true, wireFrame_ = false, grid_ = true, labels_ = true;
  QString notice_, hint_;
  SceneCamera camera_;
  /// Unset: the camera was moved.
  std::optional<SceneBox> overview_;
  std::string highlighted_, selected_;
  Mode mode_ = Mode::kIdle;
  /// Whether the mouse has moved since the press by more than a hand does during a click.
  bool moved_ = false;
  QPointF pressed_;
  /// Height of the point that was grabbed, m.
  double dragHeight_ = 0;
  QPointF last_;
  /// The newest request, and the picture that is shown.
  std::shared_ptr<const SceneFrame> requested_;
  RenderThread::Picture shown_;
  std::unique_ptr<RenderThread> thread_;
};

}  // namespace widgets
