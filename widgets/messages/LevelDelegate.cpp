// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/messages/LevelDelegate.h"

#include <algorithm>

#include "widgets/Icon.h"
#include "widgets/log/LogModel.h"

namespace widgets {

LevelDelegate::LevelDelegate(QObject* parent)
    : QStyledItemDelegate(parent), icons_{icon("info"),    icon("debug"), icon("info"),
                                          icon("warning"), icon("error"), icon("error")} {}

void LevelDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const {
  QStyledItemDelegate::initStyleOption(option, index);
  const int level = std::clamp(index.data(LogModel::kLevelRole).toInt(), 0, 5);
  option->icon = icons_[static_cast<std::size_t>(level)];
  option->features |= QStyleOptionViewItem::HasDecoration;
  option->decorationSize = QSize(14, 14);
}

}  // namespace widgets
