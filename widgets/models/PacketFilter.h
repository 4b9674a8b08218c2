// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QSortFilterProxyModel>

namespace widgets {

/// Shows of a PacketModel what passes all of: a direction, names that are not hidden, a text, only what is
/// damaged.
class PacketFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  enum class From : std::uint8_t { kBoth, kRobot, kClient };
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setFrom(From from);
  void setHiddenNames(QSet<QString> names);
  const QSet<QString>& hiddenNames() const { return hidden_; }
  /// What name or summary hold, whatever the case; or bytes, as hexadecimal digits with or without spaces.
  void setText(const QString& text);
  void setDamagedOnly(bool only);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  From from_ = From::kBoth;
  QSet<QString> hidden_;
  QString text_;
  QByteArray bytes_;  ///< that the text spells; empty: it spells none
  bool damagedOnly_ = false;
};

}  // namespace widgets
