// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>
#include <utility>

namespace widgets {

/// A table whose columns have fixed titles. GUI thread.
class TitledModel : public QAbstractTableModel {
 public:
  int columnCount(const QModelIndex& parent = {}) const override {
    return parent.isValid() ? 0 : static_cast<int>(titles_.size());
  }
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    const bool isTitle = orientation == Qt::Horizontal && role == Qt::DisplayRole;
    return isTitle && section >= 0 && section < titles_.size() ? QVariant(titles_[section]) : QVariant();
  }

 protected:
  /// The alignment of numbers in their cells, for Qt::TextAlignmentRole.
  static constexpr int kNumberAlignment = Qt::AlignRight | Qt::AlignVCenter;

  TitledModel(QStringList titles, QObject* parent)
      : QAbstractTableModel(parent), titles_(std::move(titles)) {}
  /// Announces that the contents of all rows changed.
  void announceRows() {
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  }

 private:
  QStringList titles_;
};

}  // namespace widgets
