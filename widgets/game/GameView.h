// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robotcontrol/Game.pb.h"
#include "widgets/PackageSubscription.h"
#include "widgets/View.h"
#include "widgets/game/GamePlayerModel.h"

class QLabel;
class QTableView;

namespace widgets {

class EmptyHint;
class LayoutRow;
class RadioPanel;

/// The game that simulated robots play: score, time and phase, the referee's decisions by hand, penalties,
/// and the radio of the teams.
class GameView final : public View {
  Q_OBJECT
 public:
  explicit GameView(ViewContext& context, QWidget* parent = nullptr);

  void tick() override;
  /// The table of robots with the time and the goals of the game.
  std::optional<QString> numbers() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Null: there is no game.
  const robotcontrol::GameStatus* shownStatus() const;
  static QString phaseText(const robotcontrol::GameState& state);
  /// Shows what the referee says; null: there is none.
  void showStatus(const robotcontrol::GameStatus* status);
  /// The roles that the players last told their teams; has them publish that.
  PlayedRoles playedRoles(const robotcontrol::GameStatus& status);
  void showPhase(const robotcontrol::GameStatus& status);
  /// The choices of teams and reasons, which the rules name.
  void showChoices(const robotcontrol::GameStatus& status);
  void ask(const robotcontrol::ControlGame& control);
  /// Asks for something about the selected robot.
  void askForPlayer(robotcontrol::ControlGame::Action action);
  QString chosenRobot() const;

  GamePlayerModel players_;
  PackageSubscription told_;
  /// Ready, set, play, finish.
  std::array<QAction*, 4> phases_{};
  QAction *restart_ = nullptr, *automatic_ = nullptr, *penalize_ = nullptr, *return_ = nullptr;
  QComboBox *kickOff_ = nullptr, *reason_ = nullptr;
  QLabel *score_ = nullptr, *time_ = nullptr, *message_ = nullptr, *outcome_ = nullptr;
  RadioPanel* radio_ = nullptr;
  LayoutRow* layout_ = nullptr;
  QTableView* table_ = nullptr;
  QWidget* contents_ = nullptr;
  EmptyHint* hint_ = nullptr;
};

}  // namespace widgets
