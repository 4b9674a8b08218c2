// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "colortool/training/TrainingOptions.h"

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace widgets {

class ColorBench;

/// Edits how the table is trained: method, options, and what is done before and after training. Changes
/// apply at once; dragging a slider is one step of the history. GUI thread.
class TrainingPanel final : public QWidget {
  Q_OBJECT
 public:
  /// The bench must outlive the panel.
  explicit TrainingPanel(ColorBench& bench, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted with the result of estimating the corrections, or with what is missing for it.
  void reported(const QString& text);

 private:
  /// The widgets of one option: slider and field for a number, check box for a switch.
  struct Control {
    /// Never null; lives as long as the program.
    const colortool::TrainingOption* option;
    QString title;
    QLabel* label = nullptr;
    QSlider* slider = nullptr;
    QDoubleSpinBox* field = nullptr;
    QCheckBox* box = nullptr;
  };
  void createViews();
  /// Adds a row with slider and field.
  void addNumber(QGridLayout& grid, Control control, const QString& toolTip);
  /// Adds a check box.
  QCheckBox* addSwitch(const char* name, const QString& title, const QString& toolTip);
  void connectSignals();
  /// Connects a control with its option.
  void connectControl(const Control& control);
  /// Shows the settings of the bench's samples.
  void showSettings();
  /// Changes an option in the bench's samples.
  void set(const Control& control, double value);
  /// Changes the method.
  void setMethod(int index);
  /// Estimates the corrections of cameras and vignetting from the samples, and switches them on.
  void estimate();
  /// The next change is a step of its own.
  void endGesture() { ++gesture_; }

  ColorBench& bench_;
  std::vector<Control> controls_;
  QComboBox* method_ = nullptr;
  QAction* defaults_ = nullptr;
  QAction* estimate_ = nullptr;
  /// Number of the gesture that is in progress.
  std::uint64_t gesture_ = 0;
  /// Whether showSettings() is changing the controls, not the user.
  bool showing_ = false;
};

}  // namespace widgets
