// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QStyledItemDelegate>
#include <array>

namespace widgets {

/// Shows a message's level by its icon before its name.
class LevelDelegate final : public QStyledItemDelegate {
  Q_OBJECT
 public:
  explicit LevelDelegate(QObject* parent);

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;

 private:
  std::array<QIcon, 6> icons_;  // by LogEntry::Level
};

}  // namespace widgets
