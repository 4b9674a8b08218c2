// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/errors/ErrorsView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <algorithm>
#include <utility>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/errors/ErrorFormula.h"

namespace widgets {
namespace {

const ViewRegistration kErrorsViewRegistration{
    {"errors", QT_TRANSLATE_NOOP("View", "Errors"),
     QT_TRANSLATE_NOOP("View",
                       "Shows the errors of the robot's percepts and models against the simulator's ground "
                       "truth, for each solution."),
     "errors", false, create<ErrorsView>}};

constexpr char kPlotErrorCommand[] = "plots.add";
/// Each how many ticks the figures are computed: three times a second.
constexpr int kShownEach = 10;

/// The packages that have to be published.
const std::vector<const char*>& neededPackages() {
  static const std::vector<const char*> kNeeded = [] {
    std::vector<const char*> names;
    for (const std::string& name : robotlink::TruthErrors::neededPackages()) names.push_back(name.c_str());
    return names;
  }();
  return kNeeded;
}

}  // namespace

ErrorsView::ErrorsView(ViewContext& context, QWidget* parent)
    : View(context, parent), sorted_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("errorsView"));
  createActions();
  createViews();
  connectSignals();
  keep("columns", table_->horizontalHeader());
}

void ErrorsView::createActions() {
  plot_ = makeAction(this, "plots",
                     {"errorsPlot", tr("Plot"), tr("Plots the chosen error over time"), tr("Ctrl+Return")});
  copy_ = makeAction(this, "copy",
                     {"errorsCopy", tr("Copy table"), tr("Copies the table with tabs"), QKeySequence::Copy});
  reset_ = makeAction(this, "reset",
                      {"errorsReset", tr("Reset"), tr("Restarts the figures"), tr("Ctrl+Backspace")});
}

void ErrorsView::createViews() {
  auto* search = makeFilterField(
      this,
      {"errorsSearch", tr("Search errors"), tr("Shows only errors whose stream, solution or name has this")},
      *sorted_, model_);
  sorted_->setFilterKeyColumn(-1);
  sorted_->setSortRole(ErrorModel::kNumberRole);
  table_ = makeTable(this, {"errorsTable", tr("Errors"), {}}, sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(ErrorModel::kStream, Qt::AscendingOrder);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setContextMenuPolicy(Qt::ActionsContextMenu);
  table_->addActions({plot_, copy_, reset_});
  std::vector<ColumnKind> kinds(ErrorModel::kColumns, ColumnKind::kNumber);
  for (const int name : {ErrorModel::kStream, ErrorModel::kSolution, ErrorModel::kError})
    kinds[static_cast<std::size_t>(name)] = ColumnKind::kName;
  new ColumnFit(*table_, std::move(kinds));
  hint_ = new EmptyHint(table_);
  state_ = makeNote(this, "errorsState", tr("Why nothing was plotted"));
  state_->hide();
  auto* top = makeToolRow(this, 0);
  top->addWidget(search, 1);
  for (QAction* action : {plot_, copy_, reset_}) top->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(table_, 1);
  layout->addWidget(state_);
}

void ErrorsView::connectSignals() {
  connect(plot_, &QAction::triggered, this, &ErrorsView::plot);
  connect(table_, &QTableView::activated, this, &ErrorsView::plot);
  connect(copy_, &QAction::triggered, this,
          [this] { QApplication::clipboard()->setText(numbers().value_or(QString())); });
  connect(reset_, &QAction::triggered, this, &ErrorsView::reset);
  connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this, &ErrorsView::showState);
}

std::string ErrorsView::chosenFormula() const {
  const QModelIndex index = table_->currentIndex();
  if (!index.isValid()) return {};
  const ErrorRow& row = model_.row(sorted_->mapToSource(index).row());
  return errorFormula(robot_, row.source.path, row.package, row.quantity);
}

void ErrorsView::plot() {
  const std::string formula = chosenFormula();
  if (formula.empty()) return;
  const auto done = context().commands.run(kPlotErrorCommand, {formula});
  state_->setVisible(!done);
  if (!done) showOutcome(*state_, QString::fromStdString(done.error().describe()), true);
}

void ErrorsView::reset() {
  errors_.clearErrors();
  showFigures();
  showState();
}

bool ErrorsView::collect(std::vector<const robotlink::StreamMessage*>& news) {
  const auto& store = session().store();
  bool wentBack = false;
  for (const auto* stream : store.streams(robot_ + '/')) {
    if (!robotlink::TruthErrors::reads(std::string_view(stream->path).substr(robot_.size() + 1))) continue;
    store.noteRead(*stream);
    const auto taken = cursors_[stream->path].take(*stream);
    wentBack |= taken.restarted;
    news.insert(news.end(), taken.messages.begin(), taken.messages.end());
  }
  return !wentBack;
}

void ErrorsView::takeNews() {
  std::vector<const robotlink::StreamMessage*> news;
  if (robot_.empty()) return;
  if (!collect(news)) {
    // All messages of the streams are read again, including the latched ones.
    cursors_.clear();
    errors_.clear();
    news.clear();
    collect(news);
  }
  // The table of solutions is read before the packages of the same time.
  std::ranges::stable_sort(news, {}, [](const auto* message) {
    const auto* table = dynamic_cast<const robotcontrol::SolutionTable*>(message->value.get());
    return std::pair(message->time, table == nullptr);
  });
  for (const auto* message : news)
    errors_.add(robot_, message->path.substr(robot_.size() + 1), message->time, message->value);
}

void ErrorsView::tick() {
  const bool isOther = session().selectedRobot() != robot_;
  robot_ = session().selectedRobot();
  errors_.setField(context().field);
  if (!robot_.empty()) subscription_.want(session(), robot_, neededPackages());
  takeNews();
  if (!isOther && --wait_ > 0) return;
  wait_ = kShownEach;
  showFigures();
  showState();
}

void ErrorsView::showFigures() {
  const auto found = errors_.errors().find(robot_);
  model_.setErrors(found != errors_.errors().end() ? found->second : robotlink::TruthErrors::Packages());
}

bool ErrorsView::knowsTruth() const {
  const std::string key = std::string("package/") + robotlink::kOracleWorld.name;
  const auto* table = session().store().latestAs<robotcontrol::KeyTable>(
      robot_ + '/' + robotlink::streams::kKeys, session().timeline().newest());
  const bool hasKey = table != nullptr &&
                      std::ranges::any_of(table->keys(), [&](const auto& one) { return one.name() == key; });
  return hasKey || cursors_.contains(robot_ + '/' + robotlink::kOracleWorld.name);
}

void ErrorsView::showState() {
  hint_->setHint(model_.rowCount() > 0 ? QString()
                 : robot_.empty()
                     ? tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.")
                 : knowsTruth() ? tr("Nothing compared yet. Errors appear while the robot's program runs.")
                                : tr("There is no ground truth for this "
                                     "robot. The simulator has it; a log "
                                     "has it if oracle/world was recorded."));
  const bool hasFormula = !chosenFormula().empty();
  plot_->setEnabled(hasFormula && context().commands.find(kPlotErrorCommand) != nullptr);
  reset_->setEnabled(model_.rowCount() > 0);
  copy_->setEnabled(model_.rowCount() > 0);
}

}  // namespace widgets
