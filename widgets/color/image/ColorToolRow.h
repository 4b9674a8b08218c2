// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QWidget>

#include "robotlink/base/Image.h"
#include "widgets/color/image/ColorGesture.h"

class QAction;
class QActionGroup;
class QDoubleSpinBox;
class QLabel;
class QMenu;
class QSlider;
class QSpinBox;
class QToolButton;

namespace widgets {

class ColorBench;

/// The row of controls for drawing strokes: class, tool, its size, undo and redo, and the opacity of the
/// classes. Digits choose the class, letters the tool, [ and ] its size, while the focus is anywhere within
/// `owner`. GUI thread.
class ColorToolRow final : public QWidget {
  Q_OBJECT
 public:
  /// The bench must outlive the row; `owner` is the view.
  ColorToolRow(ColorBench& bench, QWidget* owner);

  ColorTool tool() const;
  /// Radius of brush and eraser in pixels.
  double radius() const;
  /// Tool, radius and tolerances for a gesture.
  ColorGesture::Options options() const;
  /// Opacity of the classes over the image, 0 to 1.
  double opacity() const;
  /// Multiplies the radius, within its limits.
  void scaleRadius(double factor);
  /// A label in the row for the view's use: whether the robot uses the table.
  QLabel* note() { return note_; }

  /// Tool, radius, careful brush, tolerance and opacity.
  QJsonObject saveState() const;
  void restoreState(const QJsonObject& state);

 Q_SIGNALS:
  /// Tool, radius or tolerance changed.
  void toolChanged();
  void opacityChanged();

 private:
  /// The tools with their letters.
  void createTools(QWidget* owner);
  void createControls();
  void createShortcuts(QWidget* owner);
  /// Enables the controls that the tool uses and emits toolChanged().
  void update();
  void updateClass();

  ColorBench& bench_;
  QActionGroup* tools_ = nullptr;
  /// `careful_`: the brush leaves out other colors.
  QAction *undo_ = nullptr, *redo_ = nullptr, *careful_ = nullptr;
  QToolButton* class_ = nullptr;
  QMenu* classMenu_ = nullptr;
  QDoubleSpinBox* radius_ = nullptr;
  /// Color tolerance of the wand.
  QSpinBox* tolerance_ = nullptr;
  QSlider* opacity_ = nullptr;
  QLabel* note_ = nullptr;
};

/// A small square in a class's color, gray for the background.
QIcon classSwatch(const ColorBench& bench, int colorClass);
/// The class's name, or "background".
QString className(const ColorBench& bench, int colorClass);

}  // namespace widgets
