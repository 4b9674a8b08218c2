// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "colortool/TrainingOptions.h"

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QSlider;

namespace widgets {

class ColorBench;

/// How the table is made of the samples: the method and its options, live, and what is done before and after.
/// Each drag of a slider is one step of the history. The bench must outlive it.
class TrainingPanel final : public QWidget {
  Q_OBJECT
 public:
  explicit TrainingPanel(ColorBench& bench, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// What was found out, or what is missing for it.
  void told(const QString& text);

 private:
  /// A number with a slider and a field, or a switch.
  struct Control {
    const colortool::TrainingOption* option;
    QString title;
    QLabel* label = nullptr;
    QSlider* slider = nullptr;
    QDoubleSpinBox* field = nullptr;
    QCheckBox* box = nullptr;
  };
  void createViews();
  void addNumber(QGridLayout& grid, Control control, const QString& toolTip);
  QCheckBox* addSwitch(const char* name, const QString& title, const QString& toolTip);
  void connectSignals();
  void connectControl(const Control& control);
  void showSettings();
  void set(const Control& control, double value);
  void setMethod(int index);
  void estimate();
  void endGesture() { ++gesture_; }

  ColorBench& bench_;
  std::vector<Control> controls_;
  QComboBox* method_ = nullptr;
  QAction* defaults_ = nullptr;
  QAction* estimate_ = nullptr;
  std::uint64_t gesture_ = 0;
  bool showing_ = false;  ///< what changes is not of the user
};

}  // namespace widgets
