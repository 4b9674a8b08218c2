// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QSortFilterProxyModel>

namespace widgets {

/// The rows of a LogModel that are severe enough, of one robot or of all, and whose text, source or robot
/// holds what was typed: a part of it in any case of letters, or a regular expression.
class LogFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void setMinimumLevel(int level);
  /// Empty: all robots.
  void setRobot(const QString& robot);
  /// Empty if it can be used, else what is wrong with the expression; then the filter stays as it was.
  QString setPattern(const QString& text, bool regularExpression);
  /// Whether the text of a row holds `text`, in the sense of a search.
  static bool holds(const QAbstractItemModel& model, int row, const QString& text);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  int minimumLevel_ = 0;
  QString robot_;
  QString part_;
  QRegularExpression expression_;
  bool usesExpression_ = false;
};

}  // namespace widgets
