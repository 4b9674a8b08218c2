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

/// Chooses what is recorded: by patterns, and by ticking the streams that there are now; each shows what the
/// other means. GUI thread.
class StreamChooser : public QDialog {
  Q_OBJECT
 public:
  StreamChooser(const robotcontrol::StreamSelection& selection, std::vector<std::string> streams,
                QWidget* parent);

  const robotcontrol::StreamSelection& selection() const { return selection_; }

 private:
  void createWidgets();
  void connectSignals();
  void showSelection();
  void takePatterns();
  void takeTick(const QListWidgetItem& item);

  robotcontrol::StreamSelection selection_;
  std::vector<std::string> streams_;
  QLineEdit* patterns_ = nullptr;
  QLabel* problem_ = nullptr;
  QListWidget* list_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

/// The selection in which one stream more, or one less, is recorded; of the others that are known, those that
/// were.
robotcontrol::StreamSelection withStream(const robotcontrol::StreamSelection& selection,
                                         const std::string& path, bool recorded,
                                         const std::vector<std::string>& known);

}  // namespace app
