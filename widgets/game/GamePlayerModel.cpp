// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/game/GamePlayerModel.h"

#include <QGuiApplication>
#include <cmath>

#include "robotcontrol/Game.pb.h"
#include "widgets/Theme.h"

namespace widgets {

GamePlayerModel::GamePlayerModel(QObject* parent)
    : RowModel({tr("Robot"), tr("Team"), tr("Number"), tr("Role"), tr("Plays as"), tr("Penalized for"),
                tr("Left [s]")},
               parent) {}

void GamePlayerModel::setStatus(const robotcontrol::GameStatus* status, const PlayedRoles& roles) {
  std::vector<GamePlayerRow> rows;
  if (status != nullptr) {
    for (const auto& player : status->players()) {
      GamePlayerRow row{
          .robot = player.robot(), .team = player.team(), .role = player.role(), .number = player.number()};
      if (const auto told = roles.find(row.robot); told != roles.end()) row.played = told->second;
      for (const auto& penalty : status->state().penalties()) {
        if (penalty.robot() != row.robot) continue;
        row.reason = penalty.reason();
        row.seconds = penalty.seconds();
      }
      rows.push_back(std::move(row));
    }
  }
  replaceRows(std::move(rows), [](const auto& a, const auto& b) { return a.robot == b.robot; });
}

QVariant GamePlayerModel::text(const GamePlayerRow& row, int column) const {
  switch (column) {
    case kRobot:
      return QString::fromStdString(row.robot);
    case kTeam:
      return QString::fromStdString(row.team);
    case kNumber:
      return row.number;
    case kRole:
      return QString::fromStdString(row.role);
    case kPlayedRole:
      if (!row.played.trouble.empty()) return tr("program does not run");
      return row.played.role.empty() ? QString()
                                     : tr("%1, %2 s ago")
                                           .arg(QString::fromStdString(row.played.role),
                                                QString::number(row.played.seconds, 'f', 1));
    case kPenalty:
      return QString::fromStdString(row.reason);
    default:
      return row.reason.empty() ? QString() : QString::number(std::ceil(row.seconds));
  }
}

QVariant GamePlayerModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const GamePlayerRow& row = this->row(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return text(row, index.column());
    case Qt::TextAlignmentRole:
      return index.column() == kNumber || index.column() == kLeft ? QVariant(kNumberAlignment) : QVariant();
    case Qt::ToolTipRole:
      return row.played.trouble.empty() ? QVariant() : QString::fromStdString(row.played.trouble);
    case Qt::ForegroundRole:
      if (index.column() == kPlayedRole && !row.played.trouble.empty())
        return colorOf(Meaning::kBad, QGuiApplication::palette());
      return row.reason.empty() ? QVariant() : colorOf(Meaning::kWarning, QGuiApplication::palette());
    default:
      return {};
  }
}

}  // namespace widgets
