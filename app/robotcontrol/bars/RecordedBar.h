// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

class QLabel;

namespace robotcontrol {
class RecordingStatus;
}

namespace app {

class CommandActions;
class Workbench;

/// Shows where a recording was saved when it has ended, or the last seconds when they were saved, with
/// buttons that open the file or show its folder. Hidden until then, and after it was dismissed or the next
/// recording began. GUI thread; the workbench must outlive its use.
class RecordedBar : public QWidget {
  Q_OBJECT
 public:
  RecordedBar(Workbench& workbench, CommandActions& actions, QWidget* parent);
  /// Updates the bar; called after each tick.
  void refresh();

 private:
  void createWidgets();
  /// Shows the bar when a recording ends.
  void noticeRecording(const robotcontrol::RecordingStatus& status);
  /// Shows the bar when the last seconds were saved.
  void noticeSaved(const robotcontrol::RecordingStatus& status);
  /// `text` makes the sentence of the words for where the file is.
  void showFile(const QString& file, const std::function<QString(const QString& place)>& text);
  void open();
  void showFolder();

  Workbench& workbench_;
  CommandActions& actions_;
  QLabel* text_ = nullptr;
  /// The file that is shown.
  QString file_;
  /// The files of the current or the last recording.
  std::vector<std::string> files_;
  /// Whether a recording was running at the last refresh.
  bool recording_ = false;
  /// The path of the last saved seconds at the last refresh.
  std::string saved_;
};

}  // namespace app
