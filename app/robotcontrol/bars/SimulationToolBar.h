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
  /// Call this when a scene, log or layout was loaded or refused: shows what is open now. The simulation's
  /// buttons are hidden for logs and real robots.
  void showLoaded();
  /// Call this when robots were added or removed.
  void showRobots();
  /// Shows the layout that a robot runs.
  void showLayoutOf(const std::string& robot);

  /// Start, pause, rewind, step, reset.
  const QList<QAction*>& simulationActions() const { return simulationActions_; }
  /// The STOP of all robots.
  QAction* stopAction() const { return stop_; }
  /// Says which color table is in use; its menu is for what gives the robot another one.
  ColorTableButton& colorTableButton() { return *colorTable_; }
  /// The speeds to choose from, times real time; 0 is as fast as possible.
  static std::vector<double> speeds() { return {0.1, 0.25, 0.5, 1, 2, 5, 10, 0}; }
  /// A speed for display; 0 or less is as fast as possible.
  static QString speedText(double speed);

 protected:
  /// Hides the captions of the boxes where the window is narrow.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createBoxes();
  void connectSignals();
  /// Lists the layouts that fit at least one robot.
  void showLayouts(const LoadedPlatform& loaded);
  /// Shows the requested speed, unless the user has opened the list.
  void refreshSpeed(double requested);
  void showStop(bool isEngaged);

  Workbench& workbench_;
  CommandActions& actions_;
  /// Items have the path of their file as data; robot_ has names only.
  QComboBox* scene_ = nullptr;
  QComboBox* layout_ = nullptr;
  /// The robot of showLayoutOf().
  std::string layoutShownOf_;
  QComboBox* robot_ = nullptr;
  QComboBox* speed_ = nullptr;
  ColorTableButton* colorTable_ = nullptr;
  QAction* ofColors_ = nullptr;
  QAction* start_ = nullptr;
  QAction* pause_ = nullptr;
  QAction* rewind_ = nullptr;
  QAction* step_ = nullptr;
  QAction* reset_ = nullptr;
  QAction* stop_ = nullptr;
  QList<QAction*> simulationActions_;
  /// The captions before the boxes.
  QList<QAction*> captions_;
  /// The actions of the toolbar that make sense for simulations only: simulationActions_ and the speed.
  QList<QAction*> ofSimulation_;
};

}  // namespace app
