// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace widgets {
class ParameterEdits;
class ParameterSweep;
}  // namespace widgets

namespace app {

/// Sweeps a parameter and shows what was measured at each value as a table, which can be saved. The sweep
/// continues when the dialog is closed. GUI thread; its arguments must outlive it.
class SweepDialog final : public QDialog {
  Q_OBJECT
 public:
  SweepDialog(widgets::ParameterSweep& sweep, widgets::ParameterEdits& parameters, QWidget* parent);

 private:
  void createWidgets();
  void connectSignals();
  void start();
  void save();
  /// Shows the rows and how far it is.
  void showProgress();

  widgets::ParameterSweep& sweep_;
  widgets::ParameterEdits& parameters_;
  QComboBox *task_ = nullptr, *path_ = nullptr;
  QLineEdit *values_ = nullptr, *figure_ = nullptr;
  QDoubleSpinBox* seconds_ = nullptr;
  QTableWidget* table_ = nullptr;
  QPushButton *start_ = nullptr, *save_ = nullptr;
  QLabel* state_ = nullptr;
};

}  // namespace app
