// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/ProcessesView.h"

#include <QAction>
#include <QBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>

#include "robotlink/debugging/Streams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/processes/HostingBar.h"
#include "widgets/processes/ProcessGraphWidget.h"
#include "widgets/processes/TableGraph.h"

namespace widgets {
namespace {

const ViewRegistration kProcessesViewRegistration{
    {"processes", QT_TRANSLATE_NOOP("View", "Processes"),
     QT_TRANSLATE_NOOP("View", "Shows the robot's processes, the packages between them and their rates."),
     "processes", false, create<ProcessesView>}};

constexpr robotlink::Duration kMeanOver = std::chrono::seconds(2);

}  // namespace

ProcessesView::ProcessesView(ViewContext& context, QWidget* parent) : View(context, parent) {
  setObjectName(QStringLiteral("processesView"));
  createActions();
  createViews();
  connectSignals();
  keep("details", details_);
  keep("debugLinks", debugLinks_);
  keep("splitter", splitter_);
}

void ProcessesView::createActions() {
  fit_ = makeAction(this, "fit", {"processesFit", tr("Fit"), tr("Shows the whole graph"), tr("Ctrl+0")});
  zoomIn_ =
      makeAction(this, "zoom-in",
                 {"processesZoomIn", tr("Zoom in"), tr("Makes the graph larger"), QKeySequence::ZoomIn});
  zoomOut_ =
      makeAction(this, "zoom-out",
                 {"processesZoomOut", tr("Zoom out"), tr("Makes the graph smaller"), QKeySequence::ZoomOut});
  debugLinks_ = makeToggle(this, "debug",
                           {"processesDebugLinks", tr("Debug links"),
                            tr("Also shows the links of the debug process with all others")});
  details_ = makeToggle(
      this, "info", {"processesDetails", tr("Details"), tr("Shows the table of the processes"), tr("Ctrl+D")},
      true);
  refresh_ = makeAction(
      this, "refresh", {"processesRefresh", tr("Refresh"), tr("Reloads the robot's tables"), tr("Shift+F5")});
}

void ProcessesView::createViews() {
  hosting_ = new HostingBar(this);
  graph_ = new ProcessGraphWidget(this);
  hint_ = new EmptyHint(graph_);
  hint_->setHint(tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar."));
  table_ = makeTable(this, {"processesTable", tr("Processes"), {}}, &model_);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  using enum ColumnKind;
  new ColumnFit(*table_, {kName, kName, kNumber, kNumber, kNumber, kNumber, kNumber, kNumber, kText});
  splitter_ = makeSplitter(this, "processesSplitter", Qt::Vertical, {{graph_, 3}, {table_, 1}});
  splitter_->setChildrenCollapsible(false);
  auto* top = makeToolRow(this, 0);
  for (QAction* action : {fit_, zoomIn_, zoomOut_, debugLinks_, details_, refresh_})
    top->addWidget(makeButton(this, action));
  top->addStretch();
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(hosting_);
  layout->addWidget(splitter_, 1);
}

void ProcessesView::connectSignals() {
  connect(fit_, &QAction::triggered, graph_, &ProcessGraphWidget::fit);
  connect(zoomIn_, &QAction::triggered, this, [this] { graph_->zoom(1.2); });
  connect(zoomOut_, &QAction::triggered, this, [this] { graph_->zoom(1 / 1.2); });
  connect(details_, &QAction::toggled, table_, &QWidget::setVisible);
  connect(debugLinks_, &QAction::toggled, this, &ProcessesView::showTables);
  connect(refresh_, &QAction::triggered, this, [this] {
    robotcontrol::Request request;
    request.mutable_send_tables();
    ask(session(), robot_, std::move(request));
  });
  connect(hosting_, &HostingBar::chosen, this,
          [this](const robotcontrol::HostProgram& choice, HostingBar::Robots robots) {
            robotcontrol::Request request;
            *request.mutable_host_program() = choice;
            ask(session(), robots == HostingBar::Robots::kAll ? std::string() : robot_, std::move(request));
            // The view shows what the robot reports, whether the request is accepted or not.
            shownHosting_ = nullptr;
          });
  connect(graph_, &ProcessGraphWidget::selected, this, [this](const QString& process) {
    const int row = graph_->graph().find(process);
    if (row >= 0) table_->selectRow(row);
    if (row < 0) table_->clearSelection();
  });
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this](const QModelIndex& index) {
            graph_->setSelected(index.siblingAtColumn(ProcessTableModel::kName).data().toString());
          });
}

void ProcessesView::tick() {
  const std::string& robot = session().selectedRobot();
  showHosting();
  const auto* message =
      session().store().latest(robot + '/' + robotlink::streams::kProcesses, session().timeline().shown());
  const robotlink::PackagePtr value = message != nullptr ? message->value : nullptr;
  if (robot == robot_ && value == shown_) return;
  robot_ = robot;
  shown_ = value;
  showTables();
}

void ProcessesView::showHosting() {
  const auto* message = session().store().latest(
      session().selectedRobot() + '/' + robotlink::streams::kHosting, session().timeline().shown());
  const robotlink::PackagePtr value = message != nullptr ? message->value : nullptr;
  if (value == shownHosting_ && value != nullptr) return;
  shownHosting_ = value;
  hosting_->setStatus(dynamic_cast<const robotcontrol::HostingStatus*>(value.get()));
}

void ProcessesView::showTables() {
  const std::string path = robot_ + '/' + robotlink::streams::kProcesses;
  const auto& store = session().store();
  const auto* message = store.latest(path, session().timeline().shown());
  const auto* table =
      message != nullptr ? dynamic_cast<const robotcontrol::ProcessTable*>(message->value.get()) : nullptr;
  if (table == nullptr) {
    graph_->setGraph({});
    model_.setGraph({});
    hint_->setHint(
        robot_.empty()
            ? tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.")
            : tr("The robot has not reported its processes yet. Start its program."));
    return;
  }
  const auto* older = store.latest(path, message->time - kMeanOver);
  if (older == nullptr) older = &store.find(path)->messages.front();
  const auto* before = dynamic_cast<const robotcontrol::ProcessTable*>(older->value.get());
  ProcessGraph graph = processGraph(*table, before, message->time - older->time,
                                    ProcessGraph::Options{debugLinks_->isChecked()});
  hint_->setHint({});
  model_.setGraph(graph);
  graph_->setGraph(std::move(graph));
}

}  // namespace widgets
