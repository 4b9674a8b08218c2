// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace app {

/// A dialog that selects the recorded streams by patterns or by check boxes for the current streams; a change
/// of either updates the other. GUI thread.
class StreamChooser : public QDialog {
  Q_OBJECT
 public:
  /// `streams`: the paths that exist now.
  StreamChooser(const robotcontrol::StreamSelection& selection, std::vector<std::string> streams,
                QWidget* parent);

  /// The selection; valid if the dialog was accepted.
  const robotcontrol::StreamSelection& selection() const { return selection_; }

 private:
  void createWidgets();
  void connectSignals();
  /// Shows the selection in the check boxes.
  void showSelection();
  /// Applies the text of the pattern field, if it is valid.
  void takePatterns();
  /// Applies a changed check box.
  void takeTick(const QListWidgetItem& item);

  robotcontrol::StreamSelection selection_;
  /// The paths in the list.
  std::vector<std::string> streams_;
  QLineEdit* patterns_ = nullptr;
  /// What is wrong with the patterns; then the dialog cannot be accepted.
  QLabel* problem_ = nullptr;
  QListWidget* list_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

/// Returns the selection in which the stream `path` is recorded, or not, while all other streams in `known`
/// stay as they are.
robotcontrol::StreamSelection withStream(const robotcontrol::StreamSelection& selection,
                                         const std::string& path, bool recorded,
                                         const std::vector<std::string>& known);

}  // namespace app
