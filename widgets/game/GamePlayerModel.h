// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "widgets/RowModel.h"

namespace robotcontrol {
class GameStatus;
}

namespace widgets {

/// The role that a robot last reported to its team ("striker"; empty: none yet), and its age, s.
struct PlayedRole {
  std::string role = {};
  double seconds = 0;
  /// The reason why its program does not run, in sentences; empty: it runs.
  std::string trouble = {};
};
/// Keyed by the names of robots.
using PlayedRoles = std::map<std::string, PlayedRole>;

/// A robot that plays.
struct GamePlayerRow {
  std::string robot, team, role;
  PlayedRole played = {};
  unsigned number = 0;
  /// The reason why it is penalized; empty: it is not.
  std::string reason = {};
  /// The seconds of its penalty that are left.
  double seconds = 0;
};

/// The robots of a game, and their penalties. GUI thread.
class GamePlayerModel final : public RowModel<GamePlayerRow> {
  Q_OBJECT
 public:
  enum Column { kRobot, kTeam, kNumber, kRole, kPlayedRole, kPenalty, kLeft, kColumns };

  explicit GamePlayerModel(QObject* parent = nullptr);
  /// Replaces the rows; a selection survives unless the robots are others. Null: there is no game.
  void setStatus(const robotcontrol::GameStatus* status, const PlayedRoles& roles = {});

  QVariant data(const QModelIndex& index, int role) const override;

 private:
  QVariant text(const GamePlayerRow& row, int column) const;
};

}  // namespace widgets
