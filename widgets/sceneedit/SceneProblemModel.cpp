// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneProblemModel.h"

#include <filesystem>

#include "widgets/Theme.h"

namespace widgets {

SceneProblemModel::SceneProblemModel(QObject* parent)
    : RowModel<SceneProblem>({tr("Line"), tr("Problem")}, parent) {}

void SceneProblemModel::show(const std::vector<SceneProblem>& problems, const QPalette& palette) {
  palette_ = palette;
  replaceRows(problems, [](const SceneProblem& one, const SceneProblem& other) { return one == other; });
}

QVariant SceneProblemModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const SceneProblem& problem = row(index.row());
  const QString text = QString::fromStdString(problem.text);
  switch (role) {
    case Qt::DisplayRole:
      if (index.column() == kLine) return problem.line > 0 ? QVariant(problem.line) : QVariant();
      if (problem.file.empty()) return text;
      return QStringLiteral("%1: %2").arg(
          QString::fromStdString(std::filesystem::path(problem.file).filename().string()), text);
    case Qt::ToolTipRole:
      return (problem.isWarning ? tr("Warning: %1") : tr("Error: %1")).arg(text);
    case Qt::ForegroundRole:
      return colorOf(problem.isWarning ? Meaning::kWarning : Meaning::kBad, palette_);
    case Qt::TextAlignmentRole:
      return index.column() == kLine ? QVariant(kNumberAlignment) : QVariant();
    default:
      return {};
  }
}

}  // namespace widgets
