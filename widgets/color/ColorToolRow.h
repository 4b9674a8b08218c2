// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QWidget>

#include "robotlink/base/Image.h"
#include "widgets/color/ColorGesture.h"

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

/// What strokes are made with: the class, the tool, its size, undo and redo. Digits choose the class, letters
/// the tool, [ and ] its size, anywhere within `owner`.
class ColorToolRow final : public QWidget {
  Q_OBJECT
 public:
  ColorToolRow(ColorBench& bench, QWidget* owner);

  ColorTool tool() const;
  double radius() const;  ///< of brush and eraser, pixels
  ColorGesture::Options options() const;
  /// How strongly the classes are laid over the image, 0 to 1.
  double opacity() const;
  void scaleRadius(double factor);
  /// A place for a sentence in the row: whether the robot uses the table.
  QLabel* note() { return note_; }

  QJsonObject saveState() const;
  void restoreState(const QJsonObject& state);

 Q_SIGNALS:
  void toolChanged();
  void opacityChanged();

 private:
  void createTools(QWidget* owner);
  void createControls();
  void createShortcuts(QWidget* owner);
  void update();
  void updateClass();

  ColorBench& bench_;
  QActionGroup* tools_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *careful_ = nullptr;
  QToolButton* class_ = nullptr;
  QMenu* classMenu_ = nullptr;
  QDoubleSpinBox* radius_ = nullptr;
  QSpinBox* tolerance_ = nullptr;
  QSlider* opacity_ = nullptr;
  QLabel* note_ = nullptr;
};

/// A small square of a class's colour, grey for the background.
QIcon classSwatch(const ColorBench& bench, int colorClass);
/// "background" or the class's name.
QString className(const ColorBench& bench, int colorClass);

}  // namespace widgets
