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
class StreamSelector;

/// All joints of the selected robot: what is requested and measured, with limits, as numbers, bars and curves
/// of the last seconds. With manual control (ManualSteering) single joints are turned, or all are limp; a
/// pose becomes a key frame of the motion in the editor. Without a robot that has joints, any stream of
/// joints is shown, such as those of logs of other programs.
///
/// Registered as "joints". GUI thread.
class JointsView final : public View {
  Q_OBJECT
 public:
  explicit JointsView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  /// Also saves the table as .csv.
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
  /// Whether the joints are those of the selected robot's description.
  bool isOfRobot() const;
  /// Shows the selected robot's joints, or those of a stream.
  void showJoints();
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
  /// The joints of other programs, while there are any and the robot has none.
  StreamSelector* streams_ = nullptr;
  bool hasStreams_ = false;
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
