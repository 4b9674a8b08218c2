// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/color/quality/ConfusionModel.h"

class QLabel;
class QScrollArea;
class QTableView;

namespace widgets {

class EmptyHint;

/// Shows an evaluation: mean recall and false colors in a line, the confusion matrix shaded by share, and a
/// note. GUI thread.
class ConfusionPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `name` begins the object names: "strokes" gives "strokesMatrix", "strokesSummary", "strokesNote".
  ConfusionPanel(const char* name, const QString& title, QWidget* parent = nullptr);

  /// `alone`: classes whose figures mean nothing, see ConfusionModel. `note`: what the user should know about
  /// the figures; may be empty.
  void show(const colortool::ColorClasses& classes, const colortool::Evaluation& evaluation,
            const std::vector<std::uint8_t>& alone, const QString& note);
  /// Shows why there are no figures, and what to do, instead of the table.
  void showNothing(const QString& why);

 private:
  void setNote(const QString& note);

  ConfusionModel model_;
  QTableView* table_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* note_ = nullptr;
  /// Scrolls a long note.
  QScrollArea* noteArea_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
