// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/LogFilter.h"

#include "widgets/log/LogModel.h"

namespace widgets {

void LogFilter::setMinimumLevel(int level) {
  minimumLevel_ = level;
  invalidateFilter();
}

void LogFilter::setRobot(const QString& robot) {
  robot_ = robot;
  invalidateFilter();
}

QString LogFilter::setPattern(const QString& text, bool regularExpression) {
  if (regularExpression) {
    const QRegularExpression expression(text, QRegularExpression::CaseInsensitiveOption);
    if (!expression.isValid()) {
      return tr("%1 at character %2").arg(expression.errorString()).arg(expression.patternErrorOffset() + 1);
    }
    expression_ = expression;
  }
  part_ = text;
  usesExpression_ = regularExpression && !text.isEmpty();
  invalidateFilter();
  return {};
}

bool LogFilter::holds(const QAbstractItemModel& model, int row, const QString& text) {
  const QModelIndex index = model.index(row, LogModel::kText);
  return index.data().toString().contains(text, Qt::CaseInsensitive) ||
         index.siblingAtColumn(LogModel::kSource).data().toString().contains(text, Qt::CaseInsensitive);
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  const LogEntry& entry = static_cast<const LogModel*>(sourceModel())->entry(row);
  if (static_cast<int>(entry.level) < minimumLevel_) return false;
  if (!robot_.isEmpty() && entry.robot != robot_) return false;
  if (part_.isEmpty()) return true;
  if (usesExpression_) {
    return expression_.match(entry.text).hasMatch() || expression_.match(entry.source).hasMatch();
  }
  return entry.text.contains(part_, Qt::CaseInsensitive) || entry.source.contains(part_, Qt::CaseInsensitive);
}

}  // namespace widgets
