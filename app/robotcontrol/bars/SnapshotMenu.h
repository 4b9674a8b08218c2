// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMenu>
#include <string>

namespace app {

class CommandActions;
class Workbench;

/// The menu of a simulation's snapshots: takes one, in memory or as a file, goes back to one, alone or with
/// the robots' programs, and rewinds the paused simulation. It shows what the simulation reports when it is
/// opened. GUI thread; the workbench must outlive it.
class SnapshotMenu final : public QMenu {
  Q_OBJECT
 public:
  SnapshotMenu(Workbench& workbench, CommandActions& actions, QWidget* parent);

 private:
  /// Adds what is always there, and the snapshots that there are.
  void fill();
  void addRewinding(bool isPaused, double rewindable);
  void addSnapshot(const std::string& name, const QString& title);
  QAction* addCommand(const QString& text, const char* name, const QString& tip, const QString& command,
                      const std::string& argument);
  /// Asks for a file, and takes a snapshot or goes back to one. The folder is remembered.
  void takeFile();
  void restoreFile();

  Workbench& workbench_;
  CommandActions& actions_;
};

}  // namespace app
