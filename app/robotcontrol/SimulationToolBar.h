// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>
#include <vector>

class QComboBox;

namespace app {

class ColorTableButton;
class CommandActions;
class Workbench;
struct LoadedPlatform;

/// Scene, layout, robot and its color table; start, pause, step, reset, speed; the action of STOP. Shows what
/// the simulation reports, not what was clicked. GUI thread.
class SimulationToolBar : public QToolBar {
  Q_OBJECT
 public:
  SimulationToolBar(Workbench& workbench, CommandActions& actions, QWidget* parent);

  /// Shows the simulation's state; called after each tick.
  void refresh();
  /// A scene, log or layout was loaded or refused: shows what runs now, and the simulation's buttons unless
  /// it is a log or a real robot.
  void showLoaded();

  const QList<QAction*>& simulationActions() const { return simulationActions_; }
  QAction* stopAction() const { return stop_; }
  /// Says which color table is in use; its menu is for what gives the robot another one.
  ColorTableButton& colorTableButton() { return *colorTable_; }
  /// The speeds to choose from, times real time; 0 is as fast as possible.
  static std::vector<double> speeds() { return {0.1, 0.25, 0.5, 1, 2, 5, 10, 0}; }
  static QString speedText(double speed);

 private:
  void createActions();
  void createBoxes();
  void connectSignals();
  void showLayouts(const LoadedPlatform& loaded);
  void refreshSpeed(double requested);

  Workbench& workbench_;
  CommandActions& actions_;
  QComboBox* scene_ = nullptr;
  QComboBox* layout_ = nullptr;
  QComboBox* robot_ = nullptr;
  QComboBox* speed_ = nullptr;
  ColorTableButton* colorTable_ = nullptr;
  QAction* ofColors_ = nullptr;
  QAction* start_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* step_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* stop_ = nullptr;
  QList<QAction*> simulationActions_;
  QList<QAction*> ofSimulation_;  ///< these, and the speed
};

}  // namespace app
