// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotCardModel.h"

#include <algorithm>

namespace widgets {

void RobotCardModel::setCards(std::vector<RobotCard> cards) {
  const auto isSame = [](const RobotCard& a, const RobotCard& b) { return a.robot == b.robot; };
  if (!std::equal(cards.begin(), cards.end(), rows_.begin(), rows_.end(), isSame))
    return replaceRows(std::move(cards), isSame);
  for (int i = 0; i < rowCount(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (rows_[at] == cards[at]) continue;
    rows_[at] = std::move(cards[at]);
    Q_EMIT dataChanged(index(i, 0), index(i, 0));
  }
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
