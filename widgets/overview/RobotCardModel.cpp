// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotCardModel.h"

#include <algorithm>

namespace widgets {

void RobotCardModel::setCards(std::vector<RobotCard> cards) {
  replaceRows(std::move(cards), [](const RobotCard& a, const RobotCard& b) { return a.robot == b.robot; });
}

int RobotCardModel::rowOf(const std::string& robot) const {
  const auto found = std::ranges::find(rows_, robot, &RobotCard::robot);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

QVariant RobotCardModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const RobotCard& card = row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return QString::fromStdString(card.robot);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return card.text();
    default:
      return {};
  }
}

}  // namespace widgets
