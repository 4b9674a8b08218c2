// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QProgressBar;
class QToolButton;

namespace widgets {

class ViewExport;

/// Shows the progress of a view's export, with a button that cancels it, and then the result, with one that
/// shows the folder. Hidden without an export. Object name "exportBar". GUI thread.
class ExportBar final : public QWidget {
  Q_OBJECT
 public:
  /// The export must outlive the bar's last tick.
  ExportBar(ViewExport& exporting, QWidget* parent);
  /// Shows the progress or the outcome; call this once per tick.
  void tick();

 private:
  void showFolder();

  ViewExport& export_;
  QLabel* text_;
  QProgressBar* progress_;
  QToolButton *cancel_, *folder_, *dismiss_;
  /// The result of the last export; empty: none.
  QString target_;
};

}  // namespace widgets
