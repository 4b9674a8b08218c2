// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <filesystem>
#include <string>
#include <vector>

#include "app/core/deploy/RobotSet.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;
namespace robotlink::dds {
struct AnnouncedRobots;
}

namespace app {

class CommandActions;
class FoundRobots;
class Workbench;

/// Sets of robots (app/core/deploy/ROBOT_SETS.md): edited as a table, saved as a file, connected as a whole;
/// and the files that each robot should have: compared by checksums, and sent. Not modal; its owner calls
/// tick() in each tick of the session. GUI thread; workbench and actions must outlive it.
class RobotsDialog final : public QDialog {
  Q_OBJECT
 public:
  RobotsDialog(Workbench& workbench, CommandActions& actions, QWidget* parent = nullptr);
  void tick();

  /// The file of the set; empty: it has none yet.
  QString file() const { return file_; }
  /// Opens a set; says what is wrong with it.
  void openSet(const QString& file);
  /// The robots that announce themselves, which can be added to the set.
  FoundRobots& found() { return *found_; }

 private:
  void createTop();
  void createTable();
  void createFound();
  void createButtons();
  void createReport();
  void connectSignals();

  // The set, and its rows.
  RobotSet set() const;
  void show(const RobotSet& set);
  QTreeWidgetItem* addRow(const RobotSet::Robot& robot);
  std::filesystem::path folder() const;
  void setChanged(bool changed);
  /// Asks before changes would be lost; returns whether to continue.
  bool mayDiscard();
  void newSet();
  void askForFile();
  void save();
  void saveAs();
  void addRobots();
  /// Adds those robots of a program that are not in the set; those that are get its address.
  void addFound(const robotlink::dds::AnnouncedRobots& robots);
  void removeRobot();
  /// Asks for what the current cell names: a file or a folder.
  void chooseFile();

  // The robots that are ticked.
  std::vector<RobotSet::Robot> chosen() const;
  void connectAll();
  void disconnectAll();
  enum class Deploy { kCheck, kSend, kRestart };
  void deploy(Deploy what);
  /// Begins what is to be done with a robot; returns why that is not possible, empty if it is.
  QString deployTo(const RobotSet::Robot& robot, Deploy what);
  void cancelDeploying();
  void showStates();
  void showReport();
  void enableButtons();

  Workbench& workbench_;
  CommandActions& actions_;
  QString file_;
  bool isChanged_ = false, isShowing_ = false;
  QLineEdit* name_ = nullptr;
  QTreeWidget *table_ = nullptr, *report_ = nullptr;
  FoundRobots* found_ = nullptr;
  QPushButton *add_ = nullptr, *remove_ = nullptr, *choose_ = nullptr, *connect_ = nullptr,
              *disconnect_ = nullptr, *check_ = nullptr, *deploy_ = nullptr, *restart_ = nullptr,
              *cancel_ = nullptr;
  QLabel* state_ = nullptr;
  /// The robots that were compared or sent to, in the order of the report.
  std::vector<RobotSet::Robot> reported_;
};

}  // namespace app
