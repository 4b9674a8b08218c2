// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>
#include <string>
#include <vector>

#include "robotcontrol/Logging.pb.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;

namespace widgets {

/// A dialog that selects streams by patterns or by check boxes for the streams that there are; a change of
/// either updates the other. Derived classes say what it is about. GUI thread.
class StreamPicker : public QDialog {
  Q_OBJECT
 public:
  using Selection = robotcontrol::StreamSelection;
  /// Whether a selection has a stream; its empty form means something else in each dialog.
  using Contains = std::function<bool(const Selection& selection, const std::string& path)>;

  /// The selection; valid if the dialog was accepted.
  const Selection& selection() const { return selection_; }

 protected:
  /// Object names, and what users read.
  struct Texts {
    const char *dialog, *patterns, *problem, *list;
    QString title, help, patternsName, placeholder, example, listName, listTip;
    /// Said if no stream is selected, which is refused; empty: that is all right.
    QString nothing = {};
  };
  StreamPicker(const Texts& texts, const Selection& selection, std::vector<std::string> streams,
               Contains contains, QWidget* parent);

 private:
  void createWidgets(const Texts& texts);
  void connectSignals();
  /// Shows the selection in the check boxes.
  void showSelection();
  /// Applies the text of the pattern field, if it is valid.
  void takePatterns();
  /// Applies a changed check box.
  void takeTick(const QListWidgetItem& item);

  const QString nothing_;
  const Contains contains_;
  Selection selection_;
  /// The paths in the list.
  const std::vector<std::string> streams_;
  QLineEdit* patterns_ = nullptr;
  /// The problem with the patterns; then the dialog cannot be accepted.
  QLabel* problem_ = nullptr;
  QListWidget* list_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

/// Returns the selection that has the stream `path`, or not, while all other streams in `known` stay as they
/// are.
StreamPicker::Selection withStream(const StreamPicker::Selection& selection, const std::string& path,
                                   bool isWanted, const std::vector<std::string>& known,
                                   const StreamPicker::Contains& contains);

}  // namespace widgets
