// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QLabel;
class QSpinBox;
namespace robotlink {
class Session;
}

namespace widgets {

/// Asks how much of what live robots have sent is kept, in memory and on disk, and says what is taken now and
/// how far back that reaches. Deletes itself when it is closed. GUI thread.
class HistoryLimits final : public QDialog {
  Q_OBJECT
 public:
  explicit HistoryLimits(robotlink::Session& session, QWidget* parent);

  int memoryMib() const;
  int diskMib() const;

 private:
  QSpinBox* makeBox(const char* name, const QString& text, const QString& tip, int least, int value);
  QString usedText(robotlink::Session& session) const;

  QSpinBox* memory_;
  QSpinBox* disk_;
};

}  // namespace widgets
