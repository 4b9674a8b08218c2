// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>
#include <QStringList>

namespace widgets {

/// Filters a KeyTreeModel: accepts keys whose whole name contains every word that was typed, in any case of
/// letters, together with their groups; optionally only keys that are not off. GUI thread.
class KeyFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit KeyFilter(QObject* parent = nullptr);
  /// Words separated by spaces; empty: all keys pass.
  void setWords(const QString& text);
  /// Whether only keys that are not off pass.
  void setActiveOnly(bool on);
  /// Whether any filter is set.
  bool filters() const { return activeOnly_ || !words_.isEmpty(); }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  QStringList words_;
  bool activeOnly_ = false;
};

}  // namespace widgets
