// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTransform>
#include <QWidget>

#include "widgets/processes/ProcessGraph.h"

namespace widgets {

/// Draws a ProcessGraph. The wheel zooms at the cursor, dragging pans, F or a double click fits, + and -
/// zoom, the arrow keys pan, and a click selects a process. Edges are solid if they block their receiver and
/// dashed if not; an edge is orange where the receiving process does not keep up with the sender, and a
/// process that failed is red and shows why. Object name "processGraph". GUI thread.
class ProcessGraphWidget final : public QWidget {
  Q_OBJECT
 public:
  /// All that paint() needs in addition to the graph.
  struct Look {
    /// From pixels at zoom 1 (the graph's coordinates) to widget pixels.
    QTransform sceneToWidget;
    /// Name of the selected process; its edges are thicker. Empty: none.
    QString selected;
  };

  explicit ProcessGraphWidget(QWidget* parent = nullptr);
  /// Replaces the graph. The zoom is kept unless the whole graph was fitted and its bounds changed.
  void setGraph(ProcessGraph graph);
  const ProcessGraph& graph() const { return graph_; }
  /// Selects a process by its name without emitting selected(); empty: none.
  void setSelected(const QString& process);
  /// Shows the whole graph, at most at zoom 1.5, and keeps it so until the user zooms or pans.
  void fit();
  /// Zooms around the middle; the zoom is limited to 0.1 to 4.
  void zoom(double factor);
  /// The current zoom.
  double scale() const { return look_.sceneToWidget.m11(); }
  /// The rectangle in which a process is drawn, in widget pixels; empty if there is no such process.
  QRectF nodeRect(const QString& process) const;
  /// Pure. Defined in ProcessGraphPaint.cpp.
  static void paint(QPainter& painter, const ProcessGraph& graph, const Look& look, const QPalette& palette);

 Q_SIGNALS:
  /// The user clicked a process; empty: the background.
  void selected(const QString& process);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  /// Shows the tooltip of the process or port under the cursor.
  bool event(QEvent* event) override;

 private:
  /// Zooms; what is at `point` (widget pixels) stays there.
  void zoomAt(const QPointF& point, double factor);
  /// Moves the graph, by widget pixels.
  void pan(const QPointF& by);
  /// Rich text about the port or process at a point; empty: there is none.
  QString toolTipAt(const QPointF& point) const;
  /// Null if there is none. Valid until the next setGraph().
  const ProcessGraph::Node* nodeAt(const QPointF& point) const;

  ProcessGraph graph_;
  Look look_;
  /// Position of the last mouse event of a drag.
  QPointF dragged_;
  /// Whether the whole graph is kept in sight; false once the user zooms or pans.
  bool fitted_ = true;
};

}  // namespace widgets
