// SPDX-License-Identifier: GPL-3.0-or-later
// Sets of robots: the window's parts, the table and its file. RobotsDialogDeploy.cpp has what is done with
// the robots.
#include "app/robotcontrol/remote/RobotsDialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "app/core/Workbench.h"
#include "app/robotcontrol/remote/DialogParts.h"
#include "app/robotcontrol/remote/FoundRobots.h"
#include "app/robotcontrol/remote/RobotColumns.h"
#include "robotlink/base/AtomicFile.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Icon.h"

namespace app {
namespace {

constexpr int kRobotLines = 4, kReportLines = 4;
constexpr int kMinSetWidth = 132;  // characters

/// Returns the member of a set's robot that a column shows.
std::string RobotSet::Robot::*memberOf(int column) {
  switch (column) {
    case kSetName:
      return &RobotSet::Robot::name;
    case kSetTeam:
      return &RobotSet::Robot::team;
    case kSetRole:
      return &RobotSet::Robot::role;
    case kSetAddress:
      return &RobotSet::Robot::address;
    case kSetLayout:
      return &RobotSet::Robot::layout;
    case kSetColorTable:
      return &RobotSet::Robot::colorTable;
    case kSetParameters:
      return &RobotSet::Robot::parameters;
    case kSetMotions:
      return &RobotSet::Robot::motions;
    default:
      return &RobotSet::Robot::preset;
  }
}

/// "robot3", a name that no robot of the set has.
std::string freeName(const RobotSet& set) {
  std::string name;
  for (std::size_t number = set.robots.size() + 1; name.empty(); ++number) {
    std::string next = "robot" + std::to_string(number);
    if (std::ranges::find(set.robots, next, &RobotSet::Robot::name) == set.robots.end())
      name = std::move(next);
  }
  return name;
}

}  // namespace

RobotsDialog::RobotsDialog(Workbench& workbench, CommandActions& actions, QWidget* parent)
    : QDialog(parent), workbench_(workbench), actions_(actions) {
  setObjectName(QStringLiteral("robotsDialog"));
  setWindowTitle(tr("Robots[*]"));
  setWindowIcon(widgets::icon("robot"));
  new QVBoxLayout(this);
  createTop();
  createTable();
  createFound();
  createButtons();
  createReport();
  connectSignals();
  setMinimumWidth(fontMetrics().averageCharWidth() * kMinSetWidth);
  enableButtons();
}

void RobotsDialog::createTop() {
  auto* row = new QHBoxLayout;
  name_ = new QLineEdit(this);
  widgets::describe(*name_,
                    {"robotsName", tr("Name of the set"), tr("A name for display, such as Home game")});
  addLabeled(row, tr("&Set:"), name_);
  const auto add = [&](const char* name, const char* icon, const QString& text, const QString& help,
                       void (RobotsDialog::*act)()) {
    auto* button = makePushButton(this, {name, text, help}, icon);
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, act);
    row->addWidget(button);
  };
  add("robotsNew", "file-new", tr("&New"), tr("Starts a set without robots"), &RobotsDialog::newSet);
  add("robotsOpen", "open", tr("&Open…"), tr("Opens the file of a set"), &RobotsDialog::askForFile);
  add("robotsSave", "save", tr("Sa&ve"), tr("Saves the set as a text file (YAML)"), &RobotsDialog::save);
  add("robotsSaveAs", "save", tr("Save &as…"), tr("Saves the set in another file"), &RobotsDialog::saveAs);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void RobotsDialog::createTable() {
  using Kind = widgets::ColumnKind;
  table_ = makeList(this, {"robotsTable", tr("Robots of the set"), {}},
                    {{tr("Robot"), Kind::kName, QStringLiteral("robot10")},
                     {tr("Team"), Kind::kName},
                     {tr("Role"), Kind::kName, QStringLiteral("defender")},
                     {tr("Address"), Kind::kName, QStringLiteral("wss://192.168.100.100:8765")},
                     {tr("Layout"), Kind::kText},
                     {tr("Color table"), Kind::kText},
                     {tr("Parameters"), Kind::kText},
                     {tr("Motions"), Kind::kText},
                     {tr("Preset"), Kind::kText},
                     {tr("State"), Kind::kText}},
                    kRobotLines);
  table_->setTextElideMode(Qt::ElideMiddle);
  table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                          QAbstractItemView::AnyKeyPressed);
  auto* hint = new widgets::EmptyHint(table_);
  hint->setObjectName(QStringLiteral("robotsHint"));
  const auto showHint = [this, hint] {
    hint->setHint(table_->topLevelItemCount() > 0 ? QString()
                                                  : tr("The set has no robots yet. Click "
                                                       "Add, or double click a robot below."));
  };
  connect(table_->model(), &QAbstractItemModel::rowsInserted, hint, showHint);
  connect(table_->model(), &QAbstractItemModel::rowsRemoved, hint, showHint);
  connect(table_->model(), &QAbstractItemModel::modelReset, hint, showHint);
  showHint();
  static_cast<QVBoxLayout*>(layout())->addWidget(table_, 2);
}

void RobotsDialog::createFound() {
  found_ = new FoundRobots(this);
  static_cast<QVBoxLayout*>(layout())->addWidget(found_, 1);
  connect(found_, &FoundRobots::wanted, this, &RobotsDialog::addFound);
}

void RobotsDialog::createButtons() {
  auto* row = new QHBoxLayout;
  const auto add = [&](const char* name, const char* icon, const QString& text, const QString& help) {
    auto* button = makePushButton(this, {name, text, help}, icon);
    button->setAutoDefault(false);
    row->addWidget(button);
    return button;
  };
  add_ = add("robotsAdd", "add", tr("A&dd"),
             tr("Adds the selected robots on the network; else those that are connected; else an empty row"));
  remove_ = add("robotsRemove", "remove", tr("&Remove"), tr("Removes the selected robot from the set"));
  choose_ = add(
      "robotsChoose", "open", tr("Choose &file…"),
      tr("Chooses the layout, the color table, the preset, or the folder of parameters or motions for the "
         "selected cell"));
  row->addStretch(1);
  connect_ = add("robotsConnect", "connect", tr("&Connect"), tr("Connects all checked robots"));
  disconnect_ = add("robotsDisconnect", "close", tr("D&isconnect"), tr("Disconnects all checked robots"));
  check_ = add("robotsCheck", "search", tr("C&heck"),
               tr("Compares the files on the checked robots with those here, by checksum"));
  deploy_ = add("robotsDeploy", "send", tr("De&ploy"),
                tr("Sends the files that differ to the checked robots, and compares again"));
  restart_ =
      add("robotsRestart", "reset", tr("Restart pro&grams"),
          tr("Restarts the programs of the checked robots that have not read the deployed files yet; these "
             "robots are stopped meanwhile"));
  cancel_ = add("robotsCancel", "close", tr("Cance&l"), tr("Cancels comparing and sending"));
  restart_->setEnabled(false);
  cancel_->setEnabled(false);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void RobotsDialog::createReport() {
  using Kind = widgets::ColumnKind;
  report_ = makeList(this, {"robotsReport", tr("What the robots have"), {}},
                     {{tr("File on the robot"), Kind::kName,
                       QStringLiteral("parameters/ers210/motion.wheel-model-rectangle.textproto")},
                      {tr("Compared with the file here"), Kind::kText}},
                     kReportLines);
  report_->setRootIsDecorated(true);
  static_cast<QVBoxLayout*>(layout())->addWidget(report_, 3);
  state_ = makeState(this, "robotsState", 2);
  layout()->addWidget(state_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);
  layout()->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

void RobotsDialog::connectSignals() {
  connect(name_, &QLineEdit::textEdited, this, [this] { setChanged(true); });
  connect(table_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* row, int column) {
    if (isShowing_ || column == kSetState) return;
    row->setToolTip(column, row->text(column));
    setChanged(true);
  });
  connect(table_, &QTreeWidget::currentItemChanged, this, &RobotsDialog::enableButtons);
  connect(add_, &QPushButton::clicked, this, &RobotsDialog::addRobots);
  connect(remove_, &QPushButton::clicked, this, &RobotsDialog::removeRobot);
  connect(choose_, &QPushButton::clicked, this, &RobotsDialog::chooseFile);
  connect(connect_, &QPushButton::clicked, this, &RobotsDialog::connectAll);
  connect(disconnect_, &QPushButton::clicked, this, &RobotsDialog::disconnectAll);
  connect(check_, &QPushButton::clicked, this, [this] { deploy(Deploy::kCheck); });
  connect(deploy_, &QPushButton::clicked, this, [this] { deploy(Deploy::kSend); });
  connect(restart_, &QPushButton::clicked, this, [this] { deploy(Deploy::kRestart); });
  connect(cancel_, &QPushButton::clicked, this, &RobotsDialog::cancelDeploying);
}

// ---- The set, and its rows

RobotSet RobotsDialog::set() const {
  RobotSet set{name_->text().toStdString(), {}};
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    RobotSet::Robot& robot = set.robots.emplace_back();
    for (int column = 0; column < kSetState; ++column)
      robot.*memberOf(column) = table_->topLevelItem(i)->text(column).trimmed().toStdString();
  }
  return set;
}

void RobotsDialog::show(const RobotSet& set) {
  isShowing_ = true;
  name_->setText(QString::fromStdString(set.name));
  table_->clear();
  report_->clear();
  reported_.clear();
  for (const RobotSet::Robot& robot : set.robots) addRow(robot);
  isShowing_ = false;
  enableButtons();
}

QTreeWidgetItem* RobotsDialog::addRow(const RobotSet::Robot& robot) {
  auto* row = new QTreeWidgetItem(table_);
  row->setFlags(row->flags() | Qt::ItemIsEditable | Qt::ItemIsUserCheckable);
  row->setCheckState(kSetName, Qt::Checked);
  for (int column = 0; column < kSetState; ++column) {
    row->setText(column, QString::fromStdString(robot.*memberOf(column)));
    row->setToolTip(column, row->text(column));
  }
  return row;
}

std::filesystem::path RobotsDialog::folder() const {
  return file_.isEmpty() ? std::filesystem::path() : std::filesystem::path(file_.toStdString()).parent_path();
}

void RobotsDialog::setChanged(bool changed) {
  isChanged_ = changed;
  setWindowModified(changed);
  const QString name = file_.isEmpty() ? QString() : tr(" – %1").arg(QFileInfo(file_).fileName());
  setWindowTitle(tr("Robots%1[*]").arg(name));
  enableButtons();
}

bool RobotsDialog::mayDiscard() {
  return !isChanged_ ||
         QMessageBox::question(this, tr("Discard the changes?"),
                               tr("This set was changed and not saved. Discard the changes?")) ==
             QMessageBox::Yes;
}

void RobotsDialog::newSet() {
  if (!mayDiscard()) return;
  file_.clear();
  show({});
  setChanged(false);
}

void RobotsDialog::askForFile() {
  if (!mayDiscard()) return;
  const QString file = QFileDialog::getOpenFileName(this, tr("Open a set of robots"), file_,
                                                    tr("Sets of robots (*.yaml);;All files (*)"));
  if (!file.isEmpty()) openSet(file);
}

void RobotsDialog::openSet(const QString& file) {
  const auto read = readRobotSet(file.toStdString());
  if (!read)
    return widgets::showOutcome(*state_, QString::fromStdString(robotlink::describe(read.error())), true);
  file_ = file;
  show(*read);
  setChanged(false);
  state_->clear();
}

void RobotsDialog::save() {
  if (file_.isEmpty()) return saveAs();
  const std::string text = toText(set());
  // The text that is written must be readable again.
  if (const auto read = parseRobotSet(text, file_.toStdString()); !read) {
    QStringList reasons;
    for (const robotlink::Error& error : read.error()) reasons << QString::fromStdString(error.text);
    return widgets::showOutcome(*state_, tr("Not saved: %1").arg(reasons.join(QStringLiteral("; "))), true);
  }
  const auto saved = robotlink::writeFileAtomically(file_.toStdString(), text);
  if (!saved) return widgets::showOutcome(*state_, QString::fromStdString(saved.error().describe()), true);
  setChanged(false);
  widgets::showOutcome(*state_, tr("Saved as %1.").arg(QDir::toNativeSeparators(file_)), false);
}

void RobotsDialog::saveAs() {
  QString file = QFileDialog::getSaveFileName(this, tr("Save the set of robots"),
                                              file_.isEmpty() ? QStringLiteral("robots.yaml") : file_,
                                              tr("Sets of robots (*.yaml)"));
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".yaml");
  // Files stay where they are, seen from the new place.
  const QDir before(QString::fromStdString(folder().string())), now(QFileInfo(file).absolutePath());
  for (int i = 0; i < table_->topLevelItemCount(); ++i) {
    for (int column = kSetLayout; column < kSetState; ++column) {
      QTreeWidgetItem& row = *table_->topLevelItem(i);
      if (!row.text(column).isEmpty())
        row.setText(column, now.relativeFilePath(before.absoluteFilePath(row.text(column))));
    }
  }
  file_ = file;
  save();
}

void RobotsDialog::addFound(const robotlink::dds::AnnouncedRobots& robots) {
  const RobotSet now = set();
  QTreeWidgetItem* shown = nullptr;
  for (const auto& robot : robots.robots) {
    const auto known = std::ranges::find(now.robots, robot.name, &RobotSet::Robot::name);
    if (known == now.robots.end()) {
      shown = addRow({.name = robot.name, .address = robots.url()});
    } else {
      shown = table_->topLevelItem(static_cast<int>(known - now.robots.begin()));
      shown->setText(kSetAddress, QString::fromStdString(robots.url()));
    }
  }
  table_->setCurrentItem(shown);
  setChanged(true);
}

void RobotsDialog::addRobots() {
  if (const auto selected = found_->selected()) return addFound(*selected);
  const RobotSet now = set();
  QTreeWidgetItem* added = nullptr;
  for (const auto& connection : workbench_.remote().connections()) {
    for (const std::string& robot : connection.robots) {
      const bool isThere = std::ranges::any_of(
          now.robots, [&](const auto& one) { return one.name == robot || one.address == connection.url; });
      if (!isThere) added = addRow({.name = robot, .address = connection.url});
    }
  }
  if (added == nullptr) added = addRow({.name = freeName(now), .address = "ws://127.0.0.1:8765"});
  table_->setCurrentItem(added);
  setChanged(true);
}

void RobotsDialog::removeRobot() {
  delete table_->currentItem();
  setChanged(true);
}

void RobotsDialog::chooseFile() {
  QTreeWidgetItem* row = table_->currentItem();
  const int column = table_->currentColumn();
  if (row == nullptr || column < kSetLayout || column >= kSetState) return;
  const QDir folder(QString::fromStdString(this->folder().string()));
  const QString from = folder.absoluteFilePath(row->text(column));
  const bool isFolder = column == kSetParameters || column == kSetMotions;
  const QString chosen = isFolder ? QFileDialog::getExistingDirectory(this, tr("Choose a folder"), from)
                                  : QFileDialog::getOpenFileName(
                                        this, tr("Choose a file"), from,
                                        column == kSetLayout   ? tr("Process layouts (*.yaml)")
                                        : column == kSetPreset ? tr("Presets (*.json)")
                                                               : tr("Color tables (*.c64 *.tm *.raw *.cal "
                                                                    "*.lut *.bz2)"));
  if (chosen.isEmpty()) return;
  row->setText(column, file_.isEmpty() ? chosen : folder.relativeFilePath(chosen));
  row->setToolTip(column, row->text(column));
}

void RobotsDialog::enableButtons() {
  const bool hasRobots = table_->topLevelItemCount() > 0;
  for (QPushButton* button : {connect_, disconnect_, check_, deploy_}) button->setEnabled(hasRobots);
  remove_->setEnabled(table_->currentItem() != nullptr);
  const int column = table_->currentColumn();
  choose_->setEnabled(table_->currentItem() != nullptr && column >= kSetLayout && column < kSetState);
}

}  // namespace app
