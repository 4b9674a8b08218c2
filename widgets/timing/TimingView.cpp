// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimingView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "robotlink/debugging/Streams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/processes/BarDelegate.h"
#include "widgets/timing/GanttCanvas.h"
#include "widgets/timing/GanttFrames.h"

namespace widgets {
namespace {

const ViewRegistration kTimingViewRegistration{
    {"timing", QT_TRANSLATE_NOOP("View", "Timing"),
     QT_TRANSLATE_NOOP("View",
                       "Shows how long processes and tasks take, as a chart of the last seconds and "
                       "as statistics, and how long images take to become commands."),
     "timing", false, create<TimingView>}};

constexpr char kKey[] = "timing/tasks";
/// Below this height a view that is wide enough has its parts side by side.
constexpr int kSideBySideHeight = 400, kSideBySideWidth = 600;

}  // namespace

TimingView::TimingView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      logs_(openLogs(context)),
      sorted_(new QSortFilterProxyModel(this)),
      sortedLatencies_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("timingView"));
  createActions();
  createViews();
  connectSignals();
  keep("measure", measure_);
  keep("columns", table_->horizontalHeader());
  keep("latencyColumns", latencyTable_->horizontalHeader());
  keep("splitter", splitter_);
  keep(
      "span", [this] { return QJsonValue(chart_->span()); },
      [this](const QJsonValue& value) { chart_->setSpan(value.toDouble(chart_->span())); });
  keep(
      "tab", [this] { return QJsonValue(tabs_->currentIndex()); },
      [this](const QJsonValue& value) { tabs_->setCurrentIndex(value.toInt(tabs_->currentIndex())); });
}

void TimingView::createActions() {
  measure_ = makeToggle(this, "timing",
                        {"timingMeasure", tr("Measure"),
                         tr("Lets the robot measure its tasks (debug key timing/tasks)"), tr("Ctrl+Shift+M")},
                        true);
  follow_ = makeToggle(
      this, "follow",
      {"timingFollow", tr("Follow"), tr("Keeps the instant that the timeline shows in the chart (F)")}, true);
  zoomIn_ = makeAction(this, "zoom-in",
                       {"timingZoomIn", tr("Zoom in"), tr("Shows less time in the chart (+ or the wheel)")});
  zoomOut_ =
      makeAction(this, "zoom-out",
                 {"timingZoomOut", tr("Zoom out"), tr("Shows more time in the chart (- or the wheel)")});
  reset_ = makeAction(this, "reset",
                      {"timingReset", tr("Reset"), tr("Restarts the statistics"), tr("Ctrl+Backspace")});
  copy_ = makeAction(
      this, "copy",
      {"timingCopy", tr("Copy as CSV"), tr("Copies the table in front as CSV"), QKeySequence::Copy});
}

void TimingView::createTables() {
  using enum ColumnKind;
  sorted_->setSourceModel(&model_);
  sorted_->setSortRole(TimingModel::kNumberRole);
  sorted_->setDynamicSortFilter(true);
  table_ = makeTable(this, {"timingTable", tr("Times of the tasks"), {}}, sorted_);
  table_->setItemDelegateForColumn(TimingModel::kShare, new BarDelegate(TimingModel::kNumberRole, table_));
  table_->setSortingEnabled(true);
  table_->sortByColumn(TimingModel::kProcess, Qt::AscendingOrder);
  std::vector<ColumnKind> kinds(TimingModel::kColumns, kNumber);
  for (const int name : {TimingModel::kProcess, TimingModel::kTask, TimingModel::kSolution})
    kinds[static_cast<std::size_t>(name)] = kName;
  new ColumnFit(*table_, std::move(kinds));
  hint_ = new EmptyHint(table_);

  sortedLatencies_->setSourceModel(&latencies_);
  sortedLatencies_->setSortRole(LatencyModel::kNumberRole);
  sortedLatencies_->setDynamicSortFilter(true);
  latencyTable_ = makeTable(this, {"latencyTable", tr("From readings to commands"), {}}, sortedLatencies_);
  latencyTable_->setSortingEnabled(true);
  latencyTable_->sortByColumn(LatencyModel::kReading, Qt::AscendingOrder);
  std::vector<ColumnKind> latencyKinds(LatencyModel::kColumns, kNumber);
  latencyKinds[LatencyModel::kReading] = latencyKinds[LatencyModel::kCommand] = kName;
  new ColumnFit(*latencyTable_, std::move(latencyKinds));
  latencyHint_ = new EmptyHint(latencyTable_);
  latencyHint_->setObjectName(QStringLiteral("latencyHint"));
  for (QTableView* table : {table_, latencyTable_}) {
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->setFrameShape(QFrame::NoFrame);
  }
}

QWidget* TimingView::createLatency() {
  auto* page = new QWidget(this);
  QLabel* how = makeNote(page, "latencyHow", tr("How latencies are measured"));
  how->setText(
      tr("From a reading's own timestamp to when the first command that is based on it is sent: waiting, on "
         "the robot's clock, plus computing, in real time. In lockstep that clock is stopped while processes "
         "compute; then all time along the way counts as computing. The output of a process counts as "
         "based on the newest reading that reached it."));
  auto* layout = makeColumn(page, {0, 0, 0, 0}, 2);
  layout->addWidget(latencyTable_, 1);
  layout->addWidget(how);
  return page;
}

void TimingView::createViews() {
  createTables();
  chart_ = new GanttCanvas(this);
  describe(*chart_, {"timingChart", tr("Chart of the last seconds"), {}});
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(chart_);
  scroll->setFocusProxy(chart_);
  chartHint_ = new EmptyHint(static_cast<QWidget*>(chart_));
  chartHint_->setObjectName(QStringLiteral("timingChartHint"));
  tabs_ = new QTabWidget(this);
  describe(*tabs_, {"timingTabs", tr("Statistics"), {}});
  tabs_->setDocumentMode(true);
  tabs_->addTab(table_, tr("Tasks"));
  tabs_->addTab(createLatency(), tr("Latency"));
  tabs_->setTabToolTip(1, tr("How long readings, such as images, take to become commands"));
  splitter_ = makeSplitter(this, "timingSplitter", Qt::Vertical, {{scroll, 2}, {tabs_, 3}});
  state_ = new QLabel(this);
  describe(*state_, {"timingState", tr("State of the measurement"), {}});
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* top = makeToolRow(this, 0);
  top->addWidget(makeLabeledButton(this, measure_));
  top->addWidget(state_, 1);
  for (QAction* action : {follow_, zoomIn_, zoomOut_, reset_, copy_})
    top->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(splitter_, 1);
}

void TimingView::connectSignals() {
  connect(measure_, &QAction::triggered, this, &TimingView::measure);
  connect(reset_, &QAction::triggered, this, &TimingView::reset);
  connect(copy_, &QAction::triggered, this, &TimingView::copy);
  connect(follow_, &QAction::toggled, chart_, &GanttCanvas::setFollow);
  connect(chart_, &GanttCanvas::followChanged, follow_, &QAction::setChecked);
  connect(zoomIn_, &QAction::triggered, chart_, [this] { chart_->zoom(1.25); });
  connect(zoomOut_, &QAction::triggered, chart_, [this] { chart_->zoom(1 / 1.25); });
  connect(chart_, &GanttCanvas::jumpWanted, this, [this](robotlink::Instant time) {
    logs_.replay().open() ? logs_.replay().jumpTo(time) : session().history().show(time);
  });
}

void TimingView::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  const bool isLow = height() < kSideBySideHeight && width() >= kSideBySideWidth;
  splitter_->setOrientation(isLow ? Qt::Horizontal : Qt::Vertical);
}

void TimingView::measure(bool on) {
  refusal_.clear();
  if (robot_.empty()) return;
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(kKey);
  request.mutable_set_key()->mutable_mode()->set_kind(on ? robotcontrol::KeyMode::ALWAYS
                                                         : robotcontrol::KeyMode::OFF);
  ask(session(), robot_, std::move(request), this, [this](bool accepted, const QString& reason) {
    refusal_ = accepted ? QString() : tr("The robot does not measure its tasks: %1").arg(reason);
  });
}

void TimingView::reset() {
  model_.reset();
  latencies_.reset();
}

void TimingView::copy() {
  QApplication::clipboard()->setText(tabs_->currentIndex() == 0 ? model_.csv() : latencies_.csv());
}

void TimingView::followRobot() {
  const std::string& robot = session().selectedRobot();
  if (robot == robot_) return;
  robot_ = robot;
  program_.clear();
  periods_.clear();
  cursors_.clear();
  trace_.clear();
  reset();
  if (measure_->isChecked()) measure(true);
}

bool TimingView::followProgram() {
  const auto* table = session().store().latestAs<robotcontrol::ProcessTable>(
      robot_ + '/' + robotlink::streams::kProcesses, session().timeline().newest());
  if (table == nullptr) return false;
  std::string program;
  for (const auto& process : table->processes()) {
    program += process.name() + '=' + std::to_string(process.period()) + ':';
    for (const std::string& task : process.tasks()) program += task + ',';
  }
  if (program == program_) return false;
  program_ = std::move(program);
  periods_.clear();
  for (const auto& process : table->processes()) periods_[process.name()] = process.period();
  model_.keepOnly(*table);
  return true;
}

bool TimingView::takeNews() {
  if (robot_.empty()) return false;
  bool added = false;
  for (const auto* stream : streamsOfType(session().store(), robot_, "robotcontrol.StopwatchTimes")) {
    const std::string process = measuredProcess(stream->path);
    const auto news = cursors_[stream->path].take(*stream);
    if (news.restarted) trace_.clear();
    for (const auto* message : news.messages) {
      const auto* times = dynamic_cast<const robotcontrol::StopwatchTimes*>(message->value.get());
      if (times == nullptr) continue;
      model_.add(process, message->frame, message->time, *times);
      trace_.add(*times);
      added = true;
    }
  }
  for (const Latency& latency : trace_.take()) latencies_.add(latency);
  return added;
}

void TimingView::tick() {
  followRobot();
  const bool isOther = followProgram(), added = takeNews();
  if (isOther || added) {
    model_.update();
    latencies_.update();
  }
  chart_->refresh(session(), robot_, periods_);
  showState();
}

void TimingView::showState() {
  const QString latency = latencies_.summary();
  showOutcome(*state_, !refusal_.isEmpty() ? refusal_ : latency, !refusal_.isEmpty());
  state_->setToolTip(state_->text());
  const QString nothing =
      robot_.empty() ? tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.")
      : measure_->isChecked() ? tr("Waiting for the robot's times. They arrive while its program runs.")
                              : tr("The robot does not measure its tasks. Press “Measure”.");
  hint_->setHint(model_.rowCount() > 0 ? QString() : nothing);
  const auto& lanes = chart_->look().lanes;
  const bool isBlank = std::ranges::all_of(lanes, [](const GanttLane& lane) { return lane.frames.empty(); });
  chartHint_->setHint(isBlank && model_.rowCount() > 0
                          ? tr("No frame was measured at this time. “Follow” shows the current one.")
                          : QString());
  latencyHint_->setHint(
      latencies_.rowCount() > 0 ? QString()
      : model_.rowCount() > 0
          ? tr("No command was based on a reading of the platform yet. Older programs and logs do not say "
               "which commands are.")
          : nothing);
}

}  // namespace widgets
