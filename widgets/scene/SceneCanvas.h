// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "widgets/scene/RenderThread.h"

namespace widgets {

/// Shows pictures of a scene and turns mouse and keys into movements of the camera and of models. It knows no
/// session: the view sets what there is and does what is wanted. Pictures are drawn in another thread,
/// whenever something changed. Object name "sceneCanvas".
class SceneCanvas final : public QWidget {
  Q_OBJECT
 public:
  explicit SceneCanvas(RenderThread::MakeRenderer makeRenderer = SceneRenderer::create,
                       QWidget* parent = nullptr);
  ~SceneCanvas() override;

  /// To be called 30 times a second, also when nothing changed.
  void setContents(SceneContents contents);
  /// The models that dragging moves; without `always` only with the Control key.
  void setMovable(std::vector<std::string> models, bool always);
  /// A sentence at the upper edge; empty: none. And what is said where there is no scene.
  void setNotice(const QString& text);
  void setHint(const QString& text);
  const QString& hint() const { return hint_; }

  const SceneCamera& camera() const { return camera_; }
  void setCamera(const SceneCamera& camera);
  /// Shows all of the field, also when this changes its size, until the camera is moved. The extent is that
  /// of a box around the field's centre.
  void setOverview(const SceneBox& box);
  bool overview() const { return overview_.has_value(); }
  void zoomBy(double factor);
  bool wireFrame() const { return wireFrame_; }
  void setWireFrame(bool wireFrame);
  void setGrid(bool grid);
  void setLabels(bool labels);

  /// What is seen; empty until the first picture.
  QImage rendered() const;
  /// The newest picture shows everything that was set.
  bool upToDate() const { return shown_.frame && shown_.frame == requested_; }
  std::string device() const { return thread_->device(); }
  QSize sizeHint() const override { return {640, 480}; }

 Q_SIGNALS:
  void pictureShown();
  void cameraMoved();
  /// Metres in the field's frame. `height` is that of what was grabbed: the plane in which the mouse moves
  /// it.
  void dragStarted(const QString& model, double x, double y);
  void dragMoved(double x, double y);
  void dragTurned(double angle);
  void dragEnded();
  /// Pressed and released without being moved.
  void modelClicked(const QString& model);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;

 private:
  enum class Mode : std::uint8_t { kIdle, kOrbiting, kPanning, kDragging };

  void request(bool smooth = false);
  /// Once nothing changes any more, the picture is worth some effort.
  void smoothen();
  void takePicture();
  SceneFrame::Colors colors() const;
  Mode modeFor(const QMouseEvent& event);
  bool startDrag(const QPointF& at, Qt::KeyboardModifiers modifiers);
  void highlight(const std::string& model);
  void click(const QPointF& at);
  /// The model that a drag would move from here; empty: none.
  std::string movableAt(const QPointF& at, Qt::KeyboardModifiers modifiers,
                        robotlink::Vector3* point = nullptr) const;

  SceneContents contents_;
  std::vector<std::string> movable_;
  bool moveAlways_ = true, wireFrame_ = false, grid_ = true, labels_ = true;
  QString notice_, hint_;
  SceneCamera camera_;
  std::optional<SceneBox> overview_;
  std::string highlighted_;
  Mode mode_ = Mode::kIdle;
  bool moved_ = false;
  QPointF pressed_;
  double dragHeight_ = 0;
  QPointF last_;
  std::shared_ptr<const SceneFrame> requested_;
  RenderThread::Picture shown_;
  std::unique_ptr<RenderThread> thread_;
};

}  // namespace widgets
