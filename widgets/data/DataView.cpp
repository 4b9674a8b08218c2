// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSplitter>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "robotlink/base/Spelling.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/data/FieldTablePanel.h"
#include "widgets/data/PublishPanel.h"
#include "widgets/data/UnfoldedRows.h"

namespace widgets {
namespace {

const ViewRegistration kDataViewRegistration{
    {"data", QT_TRANSLATE_NOOP("View", "Data"),
     QT_TRANSLATE_NOOP("View", "Shows the messages of all streams with all their fields, and compares them."),
     "packages", true, create<DataView>}};

constexpr char kPlotCommand[] = "plots.add";

// The data of the combo box of comparisons, also in saved states; robots are "robot:<name>".
const QLatin1String kRemembered("remembered");
const QLatin1String kLogged("logged");
const QLatin1String kRobotPrefix("robot:");

// Further comparisons of commands.
constexpr char kNone[] = "none", kNow[] = "now";

DataComparison comparisonFrom(const QString& text) {
  if (text == kRemembered) return {DataComparison::With::kRemembered};
  if (text == kLogged) return {DataComparison::With::kLogged};
  if (text.startsWith(kRobotPrefix))
    return {DataComparison::With::kRobot, text.mid(kRobotPrefix.size()).toStdString()};
  return {};
}

}  // namespace

DataView::DataView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("dataView"));
  createActions();
  createTree();
  createViews();
  connectSignals();
  keep("search", search_);
  keep("columns", tree_->header());
  keep("splitter", splitter_);
  keep("publishing", publish_);
  keep(
      "message", [this] { return publishing_->state(); },
      [this](const QJsonValue& state) { publishing_->setState(state); }, Names::kObjects);
  keep(
      "rows", [this] { return unfolded_->save(); },
      [this](const QJsonValue& rows) { unfolded_->restore(rows); }, Names::kObjects);
  keep(
      "comparison", [this] { return QJsonValue(comparison_->currentData().toString()); },
      [this](const QJsonValue& value) {
        const QString text = value.toString();
        if (comparison_->findData(text) < 0 && text.startsWith(kRobotPrefix))
          comparison_->addItem(text.mid(kRobotPrefix.size()), text);
        comparison_->setCurrentIndex(std::max(0, comparison_->findData(text)));
      },
      Names::kObjects);
  showState();
}

void DataView::createActions() {
  remember_ =
      makeAction(this, "bookmark",
                 {"dataRemember", tr("Remember now"), tr("Compares with the values that are shown now"), {}});
  plot_ = makeAction(this, "plots",
                     {"dataPlot", tr("Plot"), tr("Plots the selected numbers over time"), tr("Ctrl+Return")});
  listOverTime_ =
      makeAction(this, "time-line",
                 {"dataOverTime", tr("Table over time"), tr("Lists the selected values over time"), {}});
  publish_ = makeToggle(this, "send",
                        {"dataPublish", tr("Publish"), tr("Fills in a message to a robot and sends it"), {}});
  switchOn_ = makeAction(
      this, "keys", {"dataSwitchOn", tr("Switch on"), tr("Switches on the debug key of the stream"), {}});
  copyPath_ =
      makeAction(this, "copy",
                 {"dataCopyPath", tr("Copy path"),
                  tr("Copies the paths of the selected rows, as expressions take them"), tr("Ctrl+Shift+C")});
  copyValue_ = makeAction(
      this, "copy",
      {"dataCopyValue", tr("Copy value"), tr("Copies the values with all digits"), QKeySequence::Copy});
  copyJson_ = makeAction(
      this, "copy", {"dataCopyJson", tr("Copy as JSON"), tr("Copies the row and everything below it"), {}});
}

void DataView::createTree() {
  tree_ = makeTree(this, {"dataTree", tr("Data of all streams"), {}}, &model_);
  tree_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  tree_->setDragEnabled(true);
  tree_->setDragDropMode(QAbstractItemView::DragOnly);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  tree_->setIconSize({2 * DataModel::kThumbnailHeight, DataModel::kThumbnailHeight});
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kText, ColumnKind::kNumber, ColumnKind::kText});
  tree_->setColumnHidden(DataModel::kOther, true);
  unfolded_ = new UnfoldedRows(*tree_, model_);
  hint_ = new EmptyHint(tree_);
}

void DataView::createViews() {
  search_ = makeSearchField(
      this, {"dataSearch", tr("Search data"), tr("Words that paths of streams and fields contain")});
  comparison_ = new QComboBox(this);
  describe(*comparison_,
           {"dataComparison", tr("Compare with"),
            tr("Shows other values next to these and marks differences; timestamps do not count")});
  comparison_->addItem(tr("No comparison"), QString());
  comparison_->addItem(tr("Remembered values"), QString(kRemembered));
  comparison_->addItem(tr("Logged values"), QString(kLogged));
  path_ = new QLabel(this);
  describe(*path_, {"dataPath", tr("Path of the selected row"), {}});
  path_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  path_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  state_ = makeNote(this, "dataState", tr("State of the data"));
  state_->hide();

  auto* top = makeToolRow(this, 0);
  top->addWidget(search_, 1);
  top->addWidget(comparison_);
  for (QAction* action : {remember_, plot_, listOverTime_, publish_})
    top->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  table_ = new FieldTablePanel(context(), this);
  table_->hide();
  publishing_ = new PublishPanel(context(), this);
  publishing_->hide();
  splitter_ = makeSplitter(this, "dataSplitter", Qt::Vertical, {{tree_, 3}, {table_, 2}, {publishing_, 2}});
  layout->addWidget(splitter_, 1);
  layout->addWidget(path_);
  layout->addWidget(state_);
}

void DataView::connectSignals() {
  for (const auto changed : {&DataModel::rowsInserted, &DataModel::rowsRemoved})
    connect(&model_, changed, this, [this] { hasOtherRows_ = true; });
  connect(search_, &QLineEdit::textChanged, this, &DataView::search);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    tree_->setFocus();
    if (!tree_->currentIndex().isValid()) tree_->setCurrentIndex(model_.index(0, 0));
  });
  connect(comparison_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &DataView::compare);
  connect(remember_, &QAction::triggered, this, [this] {
    model_.remember();
    comparison_->setCurrentIndex(comparison_->findData(QString(kRemembered)));
  });
  connect(tree_, &QTreeView::activated, this, &DataView::activate);
  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == DataModel::kValue) switchOn(index);
  });
  connect(tree_, &QTreeView::customContextMenuRequested, this, &DataView::showMenu);
  connect(tree_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &DataView::showState);
  connect(plot_, &QAction::triggered, this, &DataView::plotSelected);
  connect(publish_, &QAction::toggled, this, [this](bool on) {
    publishing_->setVisible(on);
    if (on) publishing_->setFocus();
  });
  connect(listOverTime_, &QAction::triggered, this, &DataView::showTable);
  connect(switchOn_, &QAction::triggered, this, [this] {
    for (const QModelIndex& index : selectedRows()) switchOn(index);
  });
  connect(copyPath_, &QAction::triggered, this, [this] {
    QStringList paths;
    for (const QModelIndex& index : selectedRows()) paths << index.data(DataModel::kPathRole).toString();
    copy(paths.join(QLatin1Char('\n')));
  });
  connect(copyValue_, &QAction::triggered, this, [this] {
    QStringList values;
    for (const QModelIndex& index : selectedRows())
      values << index.data(DataModel::kFullValueRole).toString();
    copy(values.join(QLatin1Char('\n')));
  });
  connect(copyJson_, &QAction::triggered, this, &DataView::copyJson);
}

void DataView::tick() {
  updateModel();
  listComparisons();
  table_->tick();
  publishing_->tick();
  hint_->setHint(model_.rowCount() > 0 ? QString()
                 : model_.isFiltered()
                     ? tr("Nothing matches. Clear the search.")
                     : tr("No data yet. Start a simulation, connect to a robot, or open a log."));
}

void DataView::updateModel() {
  const QPersistentModelIndex top = tree_->indexAt(QPoint(0, 0));
  hasOtherRows_ = false;
  model_.update(session().store(), session().timeline().shown());
  const bool isScrolled = tree_->verticalScrollBar()->value() > 0;
  if (!hasOtherRows_ || !isScrolled || !top.isValid()) return;
  // The visible rows stay in their place while rows are added and removed above them.
  const int left = tree_->horizontalScrollBar()->value();
  tree_->scrollTo(top, QAbstractItemView::PositionAtTop);
  tree_->horizontalScrollBar()->setValue(left);
}

void DataView::search(const QString& words) {
  const QString current = tree_->currentIndex().data(DataModel::kRowRole).toString();
  model_.setWords(words);
  if (model_.isFiltered()) unfolded_->unfoldFound();
  const QModelIndex index = current.isEmpty() ? QModelIndex() : model_.find(current);
  if (index.isValid()) {
    tree_->setCurrentIndex(index);
    tree_->scrollTo(index);
  }
  showState();
}

void DataView::listComparisons() {
  const std::vector<std::string> robots = model_.robots();
  if (robots == listedRobots_) return;
  listedRobots_ = robots;
  for (const std::string& robot : robots) {
    const QString name = QString::fromStdString(robot);
    if (comparison_->findData(kRobotPrefix + name) < 0) comparison_->addItem(name, kRobotPrefix + name);
  }
  for (int i = comparison_->count() - 1; i >= 0; --i) {
    const DataComparison entry = comparisonFrom(comparison_->itemData(i).toString());
    const bool isGone = entry.with == DataComparison::With::kRobot && i != comparison_->currentIndex() &&
                        std::ranges::find(robots, entry.robot) == robots.end();
    if (isGone) comparison_->removeItem(i);
  }
}

std::vector<std::string> DataView::comparisons(const robotlink::Session& session) {
  std::vector<std::string> all{kNone, kNow, kRemembered.latin1(), kLogged.latin1()};
  all.insert(all.end(), session.robots().begin(), session.robots().end());
  return all;
}

robotlink::Result<void> DataView::compareWith(const std::string& what) {
  tick();  // lists the robots
  if (what == kNow) {
    remember_->trigger();
    return {};
  }
  const QString name = QString::fromStdString(what);
  const QString data = what == kNone                            ? QString()
                       : name == kRemembered || name == kLogged ? name
                                                                : kRobotPrefix + name;
  const int index = comparison_->findData(data);
  if (index >= 0) {
    comparison_->setCurrentIndex(index);
    return {};
  }
  return robotlink::failure("data.compare",
                            "there is nothing called " + what + " to compare with" +
                                robotlink::suggestion(what, comparisons(session())),
                            {}, {what});
}

void DataView::compare() {
  const DataComparison comparison = comparisonFrom(comparison_->currentData().toString());
  if (comparison.with == DataComparison::With::kRemembered && !model_.hasRemembered()) model_.remember();
  model_.setComparison(comparison);
  tree_->setColumnHidden(DataModel::kOther, comparison.with == DataComparison::With::kNothing);
}

void DataView::activate(const QModelIndex& index) {
  if (index.data(DataModel::kKeyRole).toString().isEmpty()) {
    if (!index.siblingAtColumn(0).data(DataModel::kSourceRole).toString().isEmpty()) plotSelected();
  } else {
    switchOn(index);
  }
}

void DataView::switchOn(const QModelIndex& index) {
  const QString key = index.data(DataModel::kKeyRole).toString();
  if (key.isEmpty()) return;
  const std::string robot = robotlink::streams::robotOf(model_.node(index)->name);
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(key.toStdString());
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  showOutcome(*state_, tr("Asked %1 for %2 (debug key)").arg(QString::fromStdString(robot), key), false);
  state_->show();
  ask(session(), robot, std::move(request), this, [this, key](bool accepted, const QString& reason) {
    if (!accepted) showOutcome(*state_, tr("%1 was refused: %2").arg(key, reason), true);
    state_->setVisible(!accepted);
  });
}

void DataView::plotSelected() {
  for (const QModelIndex& index : selectedRows()) {
    const std::string source = index.data(DataModel::kSourceRole).toString().toStdString();
    if (source.empty()) continue;
    const auto done = context().commands.run(kPlotCommand, {source});
    state_->setVisible(!done);
    if (!done) showOutcome(*state_, QString::fromStdString(done.error().describe()), true);
  }
}

void DataView::showTable() {
  std::vector<FieldColumn> columns;
  for (const QModelIndex& index : selectedRows()) {
    const std::string field = index.data(DataModel::kFieldRole).toString().toStdString();
    if (field.empty()) continue;
    FieldColumn column{model_.node(index)->stream()->name, field};
    if (std::ranges::find(columns, column) == columns.end()) columns.push_back(std::move(column));
  }
  if (!columns.empty()) table_->show(std::move(columns));
}

void DataView::copy(const QString& text) {
  QApplication::clipboard()->setText(text);
}

void DataView::copyJson() {
  QStringList texts;
  for (const QModelIndex& index : selectedRows()) texts << model_.json(index);
  copy(texts.join(QLatin1Char('\n')));
}

QModelIndexList DataView::selectedRows() const {
  return tree_->selectionModel()->selectedRows(DataModel::kName);
}

void DataView::showMenu(const QPoint& at) {
  if (!tree_->indexAt(at).isValid()) return;
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("dataMenu"));
  menu.addActions({switchOn_, plot_, listOverTime_});
  menu.addSeparator();
  menu.addActions({copyPath_, copyValue_, copyJson_});
  menu.exec(tree_->viewport()->mapToGlobal(at));
}

void DataView::showState() {
  const QModelIndexList rows = selectedRows();
  const auto any = [&rows](int role) {
    return std::any_of(rows.begin(), rows.end(),
                       [role](const QModelIndex& index) { return !index.data(role).toString().isEmpty(); });
  };
  plot_->setEnabled(any(DataModel::kSourceRole) && context().commands.find(kPlotCommand) != nullptr);
  listOverTime_->setEnabled(any(DataModel::kFieldRole));
  switchOn_->setVisible(any(DataModel::kKeyRole));
  for (QAction* action : {copyPath_, copyValue_, copyJson_}) action->setEnabled(!rows.isEmpty());
  path_->setText(rows.isEmpty() ? QString() : rows.last().data(DataModel::kPathRole).toString());
}

}  // namespace widgets
