// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QStyledItemDelegate>
#include <array>

namespace widgets {

/// Shows the icon of a message's level before its name. The level is LogModel::kLevelRole; the icons are
/// loaded once in the constructor. GUI thread.
class LevelDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  explicit LevelDelegate(QObject* parent);

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  /// Indexed by LogEntry::Level.
  std::array<QIcon, 6> icons_;
};

}  // namespace widgets
