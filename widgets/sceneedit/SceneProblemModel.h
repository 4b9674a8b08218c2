// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPalette>

#include "widgets/RowModel.h"
#include "widgets/sceneedit/SceneLanguage.h"

namespace widgets {

/// A table of the problems in a scene file, with a row for each. GUI thread.
class SceneProblemModel final : public RowModel<SceneProblem> {
  Q_OBJECT
 public:
  enum Column { kLine, kText };

  explicit SceneProblemModel(QObject* parent = nullptr);

  /// `palette`: for the colors of errors and warnings.
  void show(const std::vector<SceneProblem>& problems, const QPalette& palette);
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

 private:
  QPalette palette_;
};

}  // namespace widgets
