// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/game/GameView.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QTableView>
#include <QToolButton>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"

namespace widgets::test {

using robotcontrol::ControlGame;
using robotcontrol::GameState;

namespace {

/// A game of two robots, of which one is penalized.
robotcontrol::GameStatus gameStatus() {
  robotcontrol::GameStatus status;
  status.set_automatic(true);
  auto& state = *status.mutable_state();
  state.set_phase(GameState::PLAYING);
  state.set_half(2);
  state.set_seconds_left(63.2);
  state.set_kick_off("blue");
  state.set_message("blue1 is penalized for 30 s: pushing.");
  for (const char* team : {"red", "blue"}) {
    auto& one = *state.add_teams();
    one.set_name(team);
    one.set_goals(team == std::string("red") ? 3 : 1);
    auto& player = *status.add_players();
    player.set_robot(std::string(team) + "1");
    player.set_team(team);
    player.set_number(1);
    player.set_role("goalie");
  }
  auto& penalty = *state.add_penalties();
  penalty.set_robot("blue1");
  penalty.set_reason("pushing");
  penalty.set_seconds(12.3);
  status.add_reasons("pushing");
  status.add_reasons("holding");
  status.mutable_radio()->set_delay(0.02);
  status.mutable_radio()->set_loss(0.05);
  return status;
}

/// A view of a game.
struct GameBench : Bench {
  GameBench() : Bench({.answers = true}) { push("game", gameStatus(), 1); }
  const ControlGame& asked() const { return requests.back().control_game(); }
};

QString textOf(const QWidget& view, const char* label) {
  return child<QLabel>(view, label).text();
}

/// Clicks a button.
void press(const QWidget& view, const char* button) {
  child<QToolButton>(view, button).click();
}

}  // namespace

class GameViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void scoreTimePhaseAndPenaltiesAreShown() {
    GameBench bench;
    auto view = bench.open<GameView>();
    QCOMPARE(textOf(*view, "gameScore"), QStringLiteral("red 3 : 1 blue"));
    QCOMPARE(textOf(*view, "gameTime"), QStringLiteral("half 2, 1:04 left, playing"));
    QVERIFY(textOf(*view, "gameMessage").startsWith(QStringLiteral("blue1 is penalized")));
    QVERIFY(child<QToolButton>(*view, "gamePlay").isChecked());
    QVERIFY(!child<QToolButton>(*view, "gameReady").isChecked());
    QVERIFY(child<QToolButton>(*view, "gameAutomatic").isChecked());
    QCOMPARE(child<QComboBox>(*view, "gameKickOff").currentText(), QStringLiteral("blue"));
    auto& model = *child<QTableView>(*view, "gamePlayers").model();
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.index(1, GamePlayerModel::kPenalty).data().toString(), QStringLiteral("pushing"));
    QCOMPARE(model.index(1, GamePlayerModel::kLeft).data().toString(), QStringLiteral("13"));
    QCOMPARE(model.index(0, GamePlayerModel::kPenalty).data().toString(), QString());
    QCOMPARE(child<QDoubleSpinBox>(*view, "gameRadioDelay").value(), 20.0);
    QCOMPARE(child<QDoubleSpinBox>(*view, "gameRadioLoss").value(), 5.0);
    keepPicture(*view, "game");
  }

  void asNumbersEachRobotHasTheTimeAndTheGoals() {
    GameBench bench;
    const auto view = bench.open<GameView>();
    const QStringList rows = view->numbers().value_or(QString()).split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(rows.size(), 3);
    QVERIFY(rows[0].endsWith(QStringLiteral("\thalf\tseconds left\tphase\tgoals of red\tgoals of blue")));
    for (int row : {1, 2}) QVERIFY(rows[row].endsWith(QStringLiteral("\t2\t63.2\tplaying\t3\t1")));
    QCOMPARE(rows[0].count(QLatin1Char('\t')), rows[2].count(QLatin1Char('\t')));
  }

  void whatRobotsTellTheirTeamThatTheyPlayIsShownWithItsAge() {
    GameBench bench;
    robotcontrol::KeyTable keys;
    keys.add_keys()->set_name("package/team/message");
    keys.mutable_keys(0)->set_stream("team/message");
    bench.push("blue1/tables/keys", keys, 1);
    auto view = bench.open<GameView>();
    auto& model = *child<QTableView>(*view, "gamePlayers").model();
    const auto played = [&](int row) {
      return model.index(row, GamePlayerModel::kPlayedRole).data().toString();
    };
    bench.tick(*view);
    QCOMPARE(played(1), QString());
    QCOMPARE(bench.requests.back().set_key().name(), std::string("package/team/message"));
    QCOMPARE(bench.requests.back().robot(), std::string("blue1"));
    robotcontrol::TeamMessage told;
    told.set_role("striker");
    robotlink::assign(*told.mutable_timestamp(), robotlink::Instant(robotlink::fromSeconds(2)));
    bench.push("blue1/team/message", told, 2);
    bench.push("game", gameStatus(), 3.5);
    bench.tick(*view);
    QCOMPARE(played(1), QStringLiteral("striker, 1.5 s ago"));
    QCOMPARE(played(0), QString());
  }

  void aRobotWhoseProgramDoesNotRunIsMarkedWithTheReason() {
    GameBench bench;
    robotcontrol::HostingStatus crashed;
    crashed.set_state(robotcontrol::HostingStatus::ENDED);
    crashed.set_text("The program of blue1 crashed.");
    bench.push("blue1/hosting", crashed, 1);
    auto view = bench.open<GameView>();
    const QModelIndex cell =
        child<QTableView>(*view, "gamePlayers").model()->index(1, GamePlayerModel::kPlayedRole);
    QCOMPARE(cell.data().toString(), QStringLiteral("program does not run"));
    QCOMPARE(cell.data(Qt::ToolTipRole).toString(), QStringLiteral("The program of blue1 crashed."));
    QVERIFY(cell.data(Qt::ForegroundRole).isValid());
    crashed.set_state(robotcontrol::HostingStatus::RUNNING);
    bench.push("blue1/hosting", crashed, 2);
    bench.advance();
    bench.tick(*view);
    QCOMPARE(cell.data().toString(), QString());
  }

  void buttonsAskTheReferee() {
    GameBench bench;
    auto view = bench.open<GameView>();
    const std::pair<const char*, ControlGame::Action> buttons[]{{"gameReady", ControlGame::READY},
                                                                {"gameSet", ControlGame::SET},
                                                                {"gamePlay", ControlGame::PLAY},
                                                                {"gameFinish", ControlGame::FINISH},
                                                                {"gameRestart", ControlGame::RESTART}};
    for (const auto& [button, action] : buttons) {
      press(*view, button);
      QCOMPARE(bench.asked().action(), action);
    }
    press(*view, "gameAutomatic");
    QCOMPARE(bench.asked().action(), ControlGame::AUTOMATIC);
    QVERIFY(!bench.asked().on());
    bench.tick(*view);
    QVERIFY2(child<QToolButton>(*view, "gameAutomatic").isChecked(), "until the referee says so");
  }

  void theChosenRobotIsPenalizedAndReturns() {
    GameBench bench;
    auto view = bench.open<GameView>();
    QVERIFY(!child<QToolButton>(*view, "gamePenalize").isEnabled());
    auto& table = child<QTableView>(*view, "gamePlayers");
    table.setCurrentIndex(table.model()->index(1, 0));
    child<QComboBox>(*view, "gameReason").setCurrentText(QStringLiteral("holding"));
    bench.tick(*view);
    press(*view, "gamePenalize");
    QCOMPARE(bench.asked().action(), ControlGame::PENALIZE);
    QCOMPARE(bench.asked().robot(), std::string("blue1"));
    QCOMPARE(bench.asked().reason(), std::string("holding"));
    press(*view, "gameReturn");
    QCOMPARE(bench.asked().action(), ControlGame::RETURN);
    QCOMPARE(bench.asked().robot(), std::string("blue1"));
    table.setCurrentIndex(table.model()->index(0, 0));
    bench.tick(*view);
    QVERIFY2(!child<QToolButton>(*view, "gameReturn").isEnabled(), "red1 plays");
  }

  void kickOffAndRadioAreChosen() {
    GameBench bench;
    auto view = bench.open<GameView>();
    auto& kickOff = child<QComboBox>(*view, "gameKickOff");
    kickOff.setCurrentIndex(0);
    Q_EMIT kickOff.activated(0);
    QCOMPARE(bench.asked().action(), ControlGame::KICK_OFF);
    QCOMPARE(bench.asked().team(), std::string("red"));
    child<QDoubleSpinBox>(*view, "gameRadioRange").setValue(3);
    QCOMPARE(bench.asked().action(), ControlGame::RADIO);
    QCOMPARE(bench.asked().radio().range(), 3.0);
    QVERIFY2(!bench.asked().radio().has_delay(), "it stays as it is");
    child<QDoubleSpinBox>(*view, "gameRadioLoss").setValue(50);
    QCOMPARE(bench.asked().radio().loss(), 0.5);
  }

  void aRobotOrItsTeamGetsALayout() {
    using Type = robotlink::CommandTable::Type;
    GameBench bench;
    std::vector<std::string> asked;
    bench.commands.add({.name = "layout.open",
                        .help = "Opens a layout",
                        .arguments = {{"layout", Type::kText}, {"robot", Type::kText}},
                        .run = [&](const robotlink::CommandTable::Values& values) -> robotlink::Result<void> {
                          asked.push_back(std::get<std::string>(values[0]) + " " +
                                          std::get<std::string>(values[1]));
                          return {};
                        },
                        .offer =
                            [](const auto&) {
                              return std::vector<std::string>{"compact", "parallel"};
                            }});
    auto view = bench.open<GameView>();
    QVERIFY(!child<QToolButton>(*view, "gameLayoutRobot").isEnabled());
    auto& table = child<QTableView>(*view, "gamePlayers");
    table.setCurrentIndex(table.model()->index(1, 0));
    bench.tick(*view);
    child<QComboBox>(*view, "gameLayout").setCurrentText(QStringLiteral("parallel"));
    bench.tick(*view);
    press(*view, "gameLayoutRobot");
    press(*view, "gameLayoutTeam");
    QCOMPARE(asked, (std::vector<std::string>{"parallel blue1", "parallel blue"}));
  }

  void theLayoutThatRunsIsShownUntilAnotherOneIsChosen() {
    GameBench bench;
    bench.commands.add({.name = "layout.open", .help = "Opens a layout", .offer = [](const auto&) {
                          return std::vector<std::string>{"compact", "parallel", "soccer"};
                        }});
    std::string ofBlue = "parallel";
    bench.context.layoutOf = [&](const std::string& robot) { return robot == "blue1" ? ofBlue : "soccer"; };
    auto view = bench.open<GameView>();
    auto& box = child<QComboBox>(*view, "gameLayout");
    QCOMPARE(box.currentText(), QStringLiteral("soccer"));
    auto& table = child<QTableView>(*view, "gamePlayers");
    table.setCurrentIndex(table.model()->index(1, 0));
    bench.tick(*view);
    QCOMPARE(box.currentText(), QStringLiteral("parallel"));
    box.setCurrentText(QStringLiteral("compact"));
    bench.tick(*view);
    QCOMPARE(box.currentText(), QStringLiteral("compact"));
    ofBlue = "my-own";
    bench.tick(*view);
    QCOMPARE(box.currentText(), QStringLiteral("my-own"));
  }

  void aLongerTextIsNotCut() {
    GameBench bench;
    auto view = bench.open<GameView>();
    view->resize(300, 500);
    view->show();
    QVERIFY(QTest::qWaitForWindowExposed(view.get()));
    auto status = gameStatus();
    for (const auto phase : {GameState::INITIAL, GameState::SET, GameState::PLAYING}) {
      status.mutable_state()->set_phase(phase);
      status.mutable_state()->mutable_teams(0)->set_goals(phase == GameState::SET ? 0 : 12);
      bench.push("game", status, 1 + phase);
      bench.advance();
      bench.tick(*view);
      for (const char* name : {"gameTime", "gameScore", "gameMessage"}) {
        const auto& label = child<QLabel>(*view, name);
        const auto fits = [&] {
          const QRect room = label.contentsRect();
          const QRect text = label.fontMetrics().boundingRect(
              QRect(0, 0, room.width(), 1000), label.wordWrap() ? Qt::TextWordWrap : 0, label.text());
          return text.width() <= room.width() && text.height() <= room.height();
        };
        QTRY_VERIFY2(fits(), name);
      }
    }
  }

  void aRefusalIsShown() {
    GameBench bench;
    bench.refusal = "the game is over";
    auto view = bench.open<GameView>();
    press(*view, "gamePlay");
    bench.tick(*view);
    QCOMPARE(textOf(*view, "gameOutcome"), QStringLiteral("the game is over"));
  }

  void withoutAGameItSaysHowToGetOne() {
    Bench bench;
    auto view = bench.open<GameView>();
    QVERIFY(!child<QWidget>(*view, "gamePlayers").isVisible());
  }
};

const GuiTest<GameViewTest> kGameViewTest;

}  // namespace widgets::test

#include "GameViewTest.moc"
