// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QLabel;

namespace robotcontrol {
class RecordingStatus;
}

namespace app {

class CommandActions;
class Workbench;

/// Says where a recording went when it has ended, or the last seconds when they were saved, with buttons that
/// open the file or show its folder. Hidden until then, and after it was dismissed or the next recording
/// began. GUI thread.
class RecordedBar : public QWidget {
  Q_OBJECT
 public:
  RecordedBar(Workbench& workbench, CommandActions& actions, QWidget* parent);
  /// Called after each tick.
  void refresh();

 private:
  void createWidgets();
  void noticeRecording(const robotcontrol::RecordingStatus& status);
  void noticeSaved(const robotcontrol::RecordingStatus& status);
  void showFile(const QString& file, const QString& text);
  void open();
  void showFolder();

  Workbench& workbench_;
  CommandActions& actions_;
  QLabel* text_ = nullptr;
  QString file_;                    // that is shown
  std::vector<std::string> files_;  // of the recording that runs, or ended just now
  bool recording_ = false;
  std::string saved_;
};

}  // namespace app
