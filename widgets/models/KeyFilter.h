// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace widgets {

/// Shows those keys of a KeyTreeModel whose whole name contains every word that was typed, with the groups
/// they are in; on wish only those that are not off.
class KeyFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit KeyFilter(QObject* parent = nullptr);
  void setWords(const QString& text);
  void setActiveOnly(bool on);
  bool filters() const { return activeOnly_ || !words_.isEmpty(); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QStringList words_;
  bool activeOnly_ = false;
};

}  // namespace widgets
