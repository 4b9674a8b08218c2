// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QSortFilterProxyModel>

namespace widgets {

/// Filters a LogModel: accepts rows of at least a level, of one robot or of all, and whose text or source
/// contains what was typed, either as a part in any case of letters or as a regular expression. GUI thread.
class LogFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  /// LogEntry::Level as int; 0: all levels.
  void setMinimumLevel(int level);
  /// Empty: all robots.
  void setRobot(const QString& robot);
  /// Sets what text or source must contain; empty: everything passes. Returns an empty text, or what is wrong
  /// with the regular expression, in which case the filter stays as it was.
  QString setPattern(const QString& text, bool regularExpression);
  /// Whether text or source of a row contain `text` in any case of letters; used by the search.
  static bool holds(const QAbstractItemModel& model, int row, const QString& text);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  int minimumLevel_ = 0;
  QString robot_;
  /// The pattern as it was typed.
  QString part_;
  /// The last valid expression, in use if usesExpression_.
  QRegularExpression expression_;
  bool usesExpression_ = false;
};

}  // namespace widgets
