// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/joints/JointsModel.h"

class QComboBox;
class QLabel;
class QSpinBox;
class QTableView;
class QToolButton;

namespace widgets {

class EmptyHint;
class JointSlider;
class ManualSteering;
class SteeringBar;

/// All joints of the selected robot: what is requested and measured, with limits, as numbers, bars and curves
/// of the last seconds. With manual control (ManualSteering) single joints are turned, or all are limp; a
/// pose becomes a key frame of the motion in the editor.
///
/// Registered as "joints". GUI thread.
class JointsView final : public View {
  Q_OBJECT
 public:
  explicit JointsView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  /// Also as .csv: the table.
  robotlink::Result<void> saveTo(const QString& file) override;

 private:
  void createActions();
  QWidget* createTop();
  QWidget* createTeaching();
  void createViews();
  void connectSignals();
  /// Replaces the sliders, which belong to the rows.
  void createSliders();
  void turn(const QString& joint, double angle);
  void capture();
  /// Shows why nothing can be steered, or that it can.
  void showState();
  QString hint() const;

  ManualSteering& manual_;
  JointsModel model_;
  PackageSubscription subscription_;
  QAction* take_ = nullptr;
  QAction* limp_ = nullptr;
  QAction* stand_ = nullptr;
  QAction* capture_ = nullptr;
  QLabel* robotName_ = nullptr;
  QLabel* state_ = nullptr;
  SteeringBar* steering_ = nullptr;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QSpinBox* duration_ = nullptr;
  QComboBox* source_ = nullptr;
  QLabel* outcome_ = nullptr;
  /// A slider for each row.
  std::vector<JointSlider*> sliders_;
};

}  // namespace widgets
