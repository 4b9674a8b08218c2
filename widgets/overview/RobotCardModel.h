// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "widgets/RowModel.h"
#include "widgets/overview/RobotCard.h"

namespace widgets {

/// The cards of a session's robots as a list, in the session's order. GUI thread.
class RobotCardModel final : public RowModel<RobotCard> {
  Q_OBJECT
 public:
  explicit RobotCardModel(QObject* parent = nullptr) : RowModel({tr("Robot")}, parent) {}
  /// Replaces the cards; the current one stays if the robots are the same, and only cards that differ are
  /// announced, because images are expensive to paint.
  void setCards(std::vector<RobotCard> cards);
  /// The row of a robot; -1 if there is none.
  int rowOf(const std::string& robot) const;
  QVariant data(const QModelIndex& index, int role) const override;
};

}  // namespace widgets
