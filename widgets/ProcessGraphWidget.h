// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>
#include <QWidget>

#include "widgets/models/ProcessGraph.h"

namespace widgets {

/// Draws a ProcessGraph and lets one look at it: wheel zooms at the cursor, dragging pans, F or a double
/// click fits, + and - zoom, the arrows pan; a click chooses a process. Solid edges block their receiver,
/// dashed ones do not; where a process does not keep up with what it waits for it is orange, a process that
/// failed is red and says why.
class ProcessGraphWidget final : public QWidget {
  Q_OBJECT
 public:
  /// What paint() needs beside the graph.
  struct Look {
    QTransform sceneToWidget;
    QString selected;
  };

  explicit ProcessGraphWidget(QWidget* parent = nullptr);
  void setGraph(ProcessGraph graph);
  const ProcessGraph& graph() const { return graph_; }
  void setSelected(const QString& process);
  void fit();
  void zoom(double factor);
  double scale() const { return look_.sceneToWidget.m11(); }
  /// Where a node is drawn now.
  QRectF nodeRect(const QString& process) const;
  static void paint(QPainter& painter, const ProcessGraph& graph, const Look& look, const QPalette& palette);

 Q_SIGNALS:
  void selected(const QString& process);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void zoomAt(const QPointF& point, double factor);
  void pan(const QPointF& by);
  QString toolTipAt(const QPointF& point) const;
  const ProcessGraph::Node* nodeAt(const QPointF& point) const;

  ProcessGraph graph_;
  Look look_;
  QPointF dragged_;
  bool fitted_ = true;  // follows the size until somebody zooms or pans
};

}  // namespace widgets
