// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <string>
#include <vector>

#include "logplayer/base/StreamFilter.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;

namespace widgets {

/// A dialog that selects the streams of a new log by patterns or by check boxes; a change of either updates
/// the other. At first all are selected. GUI thread.
class CutStreams final : public QDialog {
  Q_OBJECT
 public:
  /// `paths`: the streams of the open logs.
  CutStreams(std::vector<std::string> paths, QWidget* parent);

  /// The selection; valid if the dialog was accepted.
  const logplayer::StreamFilter& filter() const { return filter_; }

 private:
  void createWidgets();
  void connectSignals();
  /// Applies the text of the pattern field, if it is valid.
  void takePatterns();
  /// Writes patterns that stand for the check boxes.
  void takeChecks();
  /// Shows the selection in the check boxes.
  void showFilter();

  std::vector<std::string> paths_;
  logplayer::StreamFilter filter_;
  QLineEdit* patterns_ = nullptr;
  /// What is wrong with the patterns; then the dialog cannot be accepted.
  QLabel* problem_ = nullptr;
  QListWidget* list_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace widgets
