// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "widgets/models/ConfusionModel.h"

class QLabel;
class QScrollArea;
class QTableView;

namespace widgets {

class EmptyHint;

/// Figures of one evaluation: mean recall and false colours, the matrix of what was found for what, shaded by
/// share, and what there is too little of to judge by.
class ConfusionPanel final : public QWidget {
  Q_OBJECT
 public:
  /// `name` begins the names of its widgets: "strokes" makes "strokesMatrix", "strokesSummary",
  /// "strokesNote".
  ConfusionPanel(const char* name, const QString& title, QWidget* parent = nullptr);

  /// `note`: what is to be known about these figures; may be empty.
  void show(const colortool::ColorClasses& classes, const colortool::Evaluation& evaluation,
            const std::vector<std::uint8_t>& alone, const QString& note);
  /// There are no figures: why, and what to do.
  void showNothing(const QString& why);

 private:
  void setNote(const QString& note);

  ConfusionModel model_;
  QTableView* table_ = nullptr;
  QLabel* summary_ = nullptr;
  QLabel* note_ = nullptr;
  QScrollArea* noteArea_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
