// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QElapsedTimer>
#include <QFileInfo>
#include <string>
#include <vector>

#include "app/core/recordings/RecordingJobs.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace widgets {
class EmptyHint;
}

namespace app {

class CommandActions;
class Workbench;

/// The recordings in the storage of remote robots: begin and end one, fetch, open and delete them. A fetch
/// survives cuts of the line, and continues where it was after it was canceled. Not modal; its owner calls
/// tick() in each tick of the session. GUI thread; workbench and actions must outlive it.
class RecordingsDialog final : public QDialog {
  Q_OBJECT
 public:
  RecordingsDialog(Workbench& workbench, CommandActions& actions, QWidget* parent = nullptr);
  void tick();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void createTop();
  void createList();
  void createTarget();
  void createProgress();
  void createButtons();
  void connectSignals();

  /// The robot that is chosen; null if none is connected.
  RecordingJobs* jobs() const;
  void listRobots();
  /// Asks the robot for its recordings from time to time, and shows what it has.
  void showRecordings(RecordingJobs& jobs);
  void showRecording(QTreeWidgetItem& row, const RecordingFetch::Entry& entry) const;
  void showOutcomes(RecordingJobs& jobs);
  void showOutcome(const RecordingJobs::Outcome& outcome);
  void showProgress(RecordingJobs& jobs);
  void showHint();
  void enableButtons();

  QFileInfo fileOf(const QString& name) const;
  QStringList selected() const;
  /// Whether it is here as a whole.
  bool isHere(const RecordingFetch::Entry& entry) const;
  const RecordingFetch::Entry* entryOf(const QString& name) const;
  void chooseFolder();
  void fetch();
  void openSelected();
  void remove();

  Workbench& workbench_;
  CommandActions& actions_;
  QComboBox* robot_ = nullptr;
  QPushButton *start_ = nullptr, *stop_ = nullptr;
  QTreeWidget* list_ = nullptr;
  widgets::EmptyHint* hint_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QPushButton* browse_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
  QLabel* state_ = nullptr;
  QPushButton *fetch_ = nullptr, *open_ = nullptr, *delete_ = nullptr;
  /// The recordings that the chosen robot had when it was last asked.
  std::vector<RecordingFetch::Entry> entries_;
  bool isListed_ = false;
  QElapsedTimer sinceAsked_;
};

}  // namespace app
