// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSet>
#include <QSortFilterProxyModel>

namespace widgets {

/// Filters a PacketModel: accepts rows that pass all of direction, hidden names, text, and "damaged only".
/// GUI thread.
class PacketFilter final : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  /// The sender of the packets that pass.
  enum class From : std::uint8_t { kBoth, kRobot, kClient };
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void setFrom(From from);
  /// Packets of these names do not pass.
  void setHiddenNames(QSet<QString> names);
  const QSet<QString>& hiddenNames() const { return hidden_; }
  /// Text that name or summary contain, in any case of letters, or bytes that the packet contains, as at
  /// least two pairs of hexadecimal digits with or without spaces. Empty: everything passes.
  void setText(const QString& text);
  /// Whether only damaged packets pass.
  void setDamagedOnly(bool only);

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  From from_ = From::kBoth;
  QSet<QString> hidden_;
  QString text_;
  /// The bytes that the text spells; empty: none.
  QByteArray bytes_;
  bool damagedOnly_ = false;
};

}  // namespace widgets
