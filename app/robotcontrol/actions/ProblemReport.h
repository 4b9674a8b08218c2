// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QJsonObject>
#include <QString>

class QPlainTextEdit;

namespace widgets {
class CommandLog;
}

namespace app {

class Workbench;

/// Returns a problem report as Markdown: versions, the open platform with its layout,
/// the last messages, what was typed, and how the window is arranged. The user's home folder is written as ~.
QString problemReport(Workbench& workbench, const widgets::CommandLog& log, const QJsonObject& window);

/// Asks the user what happened, shows everything that the report has, and saves or copies it. Nothing is sent
/// anywhere.
class ProblemDialog final : public QDialog {
  Q_OBJECT
 public:
  /// `report` as problemReport() returns it.
  ProblemDialog(QString report, QWidget* window);
  /// The report with what the user wrote.
  QString text() const;

 private:
  void createWidgets();
  void save();

  const QString report_;
  QPlainTextEdit* story_ = nullptr;
};

}  // namespace app
