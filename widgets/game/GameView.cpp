// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/game/GameView.h"

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Hosting.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/game/LayoutRow.h"
#include "widgets/game/RadioPanel.h"

namespace widgets {

using robotcontrol::ControlGame;
using robotcontrol::GameState;

namespace {

const ViewRegistration kGameViewRegistration{
    {"game", QT_TRANSLATE_NOOP("View", "Game"),
     QT_TRANSLATE_NOOP("View",
                       "Shows score, time and penalties of a simulated game, and lets you referee it."),
     "kick", false, create<GameView>}};

/// The phases that the actions begin, in their order.
constexpr std::array<std::pair<ControlGame::Action, GameState::Phase>, 4> kGamePhases{
    {{ControlGame::READY, GameState::READY},
     {ControlGame::SET, GameState::SET},
     {ControlGame::PLAY, GameState::PLAYING},
     {ControlGame::FINISH, GameState::FINISHED}}};

/// The table of robots keeps room for this many rows in a low dock.
constexpr int kRowsAtLeast = 4;

QString clockText(double seconds) {
  const int all = static_cast<int>(std::ceil(seconds));
  return QStringLiteral("%1:%2").arg(all / 60).arg(all % 60, 2, 10, QLatin1Char('0'));
}

/// Replaces the entries of a box if they are others; the chosen one stays if it is still there.
void setEntries(QComboBox& box, const QStringList& entries) {
  QStringList present;
  for (int i = 0; i < box.count(); ++i) present << box.itemText(i);
  if (present == entries) return;
  const QSignalBlocker quiet(box);
  const QString chosen = box.currentText();
  box.clear();
  box.addItems(entries);
  box.setCurrentText(chosen);
}

}  // namespace

GameView::GameView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("gameView"));
  createActions();
  createViews();
  connectSignals();
  tick();
}

void GameView::createActions() {
  phases_ = {
      makeAction(this, "follow", {"gameReady", tr("Ready"), tr("Sends the robots to their positions")}),
      makeAction(this, "grab",
                 {"gameSet", tr("Set"), tr("Places robots and ball for the kick-off; they wait")}),
      makeAction(this, "play", {"gamePlay", tr("Play"), tr("Starts play")}),
      makeAction(this, "stop", {"gameFinish", tr("Finish"), tr("Ends the half")})};
  for (QAction* phase : phases_) phase->setCheckable(true);
  restart_ = makeAction(
      this, "reset",
      {"gameRestart", tr("New game"), tr("Restarts the game: no goals, first half, no penalties")});
  automatic_ = makeToggle(this, "auto-send",
                          {"gameAutomatic", tr("Automatic"),
                           tr("The referee decides by itself: phases, goals, balls out, penalties")});
  penalize_ = makeAction(this, "must-not",
                         {"gamePenalize", tr("Penalize"), tr("Takes the chosen robot out of the game")});
  return_ =
      makeAction(this, "undo", {"gameReturn", tr("Return"), tr("Returns the chosen robot to the game")});
}

void GameView::createViews() {
  contents_ = new QWidget(this);
  auto* top = makeToolRow(contents_, 0);
  score_ = addLabel(top, "gameScore", tr("Score"));
  QFont large = score_->font();
  large.setPointSizeF(1.6 * large.pointSizeF());
  large.setBold(true);
  score_->setFont(large);
  top->addStretch(1);
  top->addWidget(makeLabeledButton(contents_, automatic_));
  time_ = makeNote(contents_, "gameTime", tr("Half, time and phase"));

  auto* phases = makeToolRow(contents_, 0);
  for (QAction* phase : phases_) phases->addWidget(makeLabeledButton(contents_, phase));
  phases->addWidget(makeLabeledButton(contents_, restart_));
  auto* kickOffLabel = new QLabel(tr("Kick-off"), contents_);
  kickOff_ = new QComboBox(contents_);
  describe(*kickOff_, {"gameKickOff", tr("Kick-off"), tr("The team that kicks off next")});
  kickOffLabel->setBuddy(kickOff_);
  phases->addWidget(kickOffLabel);
  phases->addWidget(kickOff_);
  phases->addStretch(1);

  table_ = makeTable(contents_, {"gamePlayers", tr("Robots"), {}}, &players_);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setMinimumHeight((kRowsAtLeast + 1) * table_->verticalHeader()->defaultSectionSize());
  new ColumnFit(*table_, {ColumnKind::kName, ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kName,
                          ColumnKind::kName, ColumnKind::kText, ColumnKind::kNumber});
  auto* penalties = makeToolRow(contents_, 0);
  reason_ = new QComboBox(contents_);
  describe(*reason_, {"gameReason", tr("Reason"), tr("Reason for the penalty")});
  penalties->addWidget(makeLabeledButton(contents_, penalize_));
  penalties->addWidget(reason_);
  penalties->addWidget(makeLabeledButton(contents_, return_));
  penalties->addStretch(1);

  layout_ = new LayoutRow(context().commands, contents_);
  radio_ = new RadioPanel(contents_);
  message_ = makeNote(contents_, "gameMessage", tr("The latest event"));
  outcome_ = makeNote(contents_, "gameOutcome", tr("What came of it"));
  auto* layout = makeColumn(contents_, {6, 4, 6, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(time_);
  layout->addWidget(message_);
  layout->addWidget(phases->parentWidget());
  layout->addWidget(table_, 1);
  layout->addWidget(penalties->parentWidget());
  layout->addWidget(layout_);
  layout->addWidget(radio_);
  layout->addWidget(outcome_);
  makeColumn(this)->addWidget(makeScrollArea(this, contents_), 1);
  hint_ = new EmptyHint(this);
}

void GameView::connectSignals() {
  const auto asks = [this](QAction* action, ControlGame::Action what) {
    connect(action, &QAction::triggered, this, [this, what] {
      ControlGame control;
      control.set_action(what);
      ask(control);
    });
  };
  for (std::size_t i = 0; i < phases_.size(); ++i) asks(phases_[i], kGamePhases[i].first);
  asks(restart_, ControlGame::RESTART);
  connect(automatic_, &QAction::triggered, this, [this](bool on) {
    ControlGame control;
    control.set_action(ControlGame::AUTOMATIC);
    control.set_on(on);
    ask(control);
  });
  connect(penalize_, &QAction::triggered, this, [this] { askForPlayer(ControlGame::PENALIZE); });
  connect(return_, &QAction::triggered, this, [this] { askForPlayer(ControlGame::RETURN); });
  connect(kickOff_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    ControlGame control;
    control.set_action(ControlGame::KICK_OFF);
    control.set_team(kickOff_->currentText().toStdString());
    ask(control);
  });
  connect(layout_, &LayoutRow::asked, this,
          [this](const QString& reason) { showOutcome(*outcome_, reason, !reason.isEmpty()); });
  connect(radio_, &RadioPanel::wanted, this, [this](const robotcontrol::TeamRadioSettings& settings) {
    ControlGame control;
    control.set_action(ControlGame::RADIO);
    *control.mutable_radio() = settings;
    ask(control);
  });
}

void GameView::ask(const ControlGame& control) {
  robotcontrol::Request request;
  *request.mutable_control_game() = control;
  widgets::ask(session(), {}, std::move(request), this, [this](bool accepted, const QString& reason) {
    showOutcome(*outcome_, accepted ? QString() : reason, !accepted);
  });
}

void GameView::askForPlayer(ControlGame::Action action) {
  ControlGame control;
  control.set_action(action);
  control.set_robot(chosenRobot().toStdString());
  if (action == ControlGame::PENALIZE) control.set_reason(reason_->currentText().toStdString());
  ask(control);
}

QString GameView::chosenRobot() const {
  const QModelIndex index = table_->currentIndex();
  return index.isValid() ? QString::fromStdString(players_.row(index.row()).robot) : QString();
}

const robotcontrol::GameStatus* GameView::shownStatus() const {
  return session().store().latestAs<robotcontrol::GameStatus>(robotlink::streams::kGame,
                                                              session().timeline().shown());
}

void GameView::tick() {
  showStatus(shownStatus());
}

std::optional<QString> GameView::numbers() {
  const auto table = View::numbers();
  const auto* status = shownStatus();
  if (!table || status == nullptr) return table;
  const GameState& state = status->state();
  QStringList titles{QStringLiteral("half"), QStringLiteral("seconds left"), QStringLiteral("phase")};
  QStringList values{QString::number(state.half()), QString::number(state.seconds_left(), 'f', 1),
                     phaseText(state)};
  for (const auto& team : state.teams()) {
    titles << QStringLiteral("goals of ") + QString::fromStdString(team.name());
    values << QString::number(team.goals());
  }
  QStringList rows = table->split(QLatin1Char('\n'), Qt::SkipEmptyParts);
  for (int i = 0; i < rows.size(); ++i)
    rows[i] += QLatin1Char('\t') + (i == 0 ? titles : values).join(QLatin1Char('\t')) + QLatin1Char('\n');
  return rows.join(QString());
}

QString GameView::phaseText(const GameState& state) {
  static const char* const kWords[]{QT_TR_NOOP("initial"), QT_TR_NOOP("ready"), QT_TR_NOOP("set"),
                                    QT_TR_NOOP("playing"), QT_TR_NOOP("finished")};
  return tr(kWords[GameState::Phase_IsValid(state.phase()) ? state.phase() : 0]);
}

void GameView::showStatus(const robotcontrol::GameStatus* status) {
  contents_->setVisible(status != nullptr);
  hint_->setHint(status != nullptr ? QString()
                                   : tr("No game is played. Open a scene with a game, such as game2002."));
  players_.setStatus(status, status != nullptr ? playedRoles(*status) : PlayedRoles());
  if (status == nullptr) return;
  showPhase(*status);
  showChoices(*status);
  radio_->showSettings(status->radio());
  const QModelIndex index = table_->currentIndex();
  const bool isChosen = index.isValid();
  const GamePlayerRow chosen = isChosen ? players_.row(index.row()) : GamePlayerRow();
  const bool isPenalized = !chosen.reason.empty();
  const std::string ofRobot =
      isChosen || status->players().empty() ? chosen.robot : status->players(0).robot();
  const auto& layoutOf = context().layoutOf;
  layout_->showFor(QString::fromStdString(chosen.robot), QString::fromStdString(chosen.team),
                   layoutOf ? QString::fromStdString(layoutOf(ofRobot)) : QString());
  penalize_->setEnabled(isChosen);
  return_->setEnabled(isPenalized);
}

PlayedRoles GameView::playedRoles(const robotcontrol::GameStatus& status) {
  PlayedRoles roles;
  const robotlink::Instant shown = session().timeline().shown();
  for (const auto& player : status.players()) {
    told_.want(session(), player.robot(), {robotlink::kTeamMessage.name});
    PlayedRole& played = roles[player.robot()];
    const auto* hosting = session().store().latestAs<robotcontrol::HostingStatus>(
        player.robot() + '/' + robotlink::streams::kHosting, shown);
    if (hosting != nullptr && hosting->state() != robotcontrol::HostingStatus::RUNNING)
      played.trouble = hosting->text();
    const auto* message =
        session().store().latest(player.robot() + '/' + robotlink::kTeamMessage.name, shown);
    const auto* said =
        message == nullptr ? nullptr : dynamic_cast<const robotcontrol::TeamMessage*>(message->value.get());
    if (said == nullptr) continue;
    played.role = said->role();
    played.seconds = std::max(0.0, robotlink::seconds(shown - message->time));
  }
  return roles;
}

void GameView::showPhase(const robotcontrol::GameStatus& status) {
  const GameState& state = status.state();
  QStringList names, goals;
  for (const auto& team : state.teams()) {
    names << QString::fromStdString(team.name());
    goals << QString::number(team.goals());
  }
  if (names.size() == 2)
    score_->setText(QStringLiteral("%1 %2 : %3 %4").arg(names[0], goals[0], goals[1], names[1]));
  time_->setText(
      tr("half %1, %2 left, %3").arg(state.half()).arg(clockText(state.seconds_left()), phaseText(state)));
  message_->setText(QString::fromStdString(state.message()));
  for (std::size_t i = 0; i < phases_.size(); ++i)
    phases_[i]->setChecked(state.phase() == kGamePhases[i].second);
  automatic_->setChecked(status.automatic());
}

void GameView::showChoices(const robotcontrol::GameStatus& status) {
  QStringList teams, reasons;
  for (const auto& team : status.state().teams()) teams << QString::fromStdString(team.name());
  for (const auto& reason : status.reasons()) reasons << QString::fromStdString(reason);
  setEntries(*kickOff_, teams);
  setEntries(*reason_, reasons);
  if (!kickOff_->view()->isVisible()) {
    const QSignalBlocker quiet(kickOff_);
    kickOff_->setCurrentText(QString::fromStdString(status.state().kick_off()));
  }
}

}  // namespace widgets
