// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/TimingView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>

#include "robotlink/debugging/Streams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/processes/BarDelegate.h"

namespace widgets {
namespace {

const ViewRegistration kTimingViewRegistration{
    {"timing", QT_TRANSLATE_NOOP("View", "Timing"),
     QT_TRANSLATE_NOOP("View", "Shows how long each task takes, and its share of its process's period."),
     "timing", false, create<TimingView>}};

constexpr char kKey[] = "timing/tasks";

}  // namespace

TimingView::TimingView(ViewContext& context, QWidget* parent)
    : View(context, parent), sorted_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("timingView"));
  createActions();
  createViews();
  connectSignals();
  keep("measure", measure_);
  keep("columns", table_->horizontalHeader());
}

void TimingView::createActions() {
  measure_ = makeToggle(this, "timing",
                        {"timingMeasure", tr("Measure"),
                         tr("Lets the robot measure its tasks (debug key timing/tasks)"), tr("Ctrl+Shift+M")},
                        true);
  reset_ = makeAction(this, "reset",
                      {"timingReset", tr("Reset"), tr("Restarts the statistics"), tr("Ctrl+Backspace")});
  copy_ =
      makeAction(this, "copy",
                 {"timingCopy", tr("Copy as CSV"), tr("Copies the whole table as CSV"), QKeySequence::Copy});
}

void TimingView::createViews() {
  sorted_->setSourceModel(&model_);
  sorted_->setSortRole(TimingModel::kNumberRole);
  sorted_->setDynamicSortFilter(true);
  table_ = makeTable(this, {"timingTable", tr("Times of the tasks"), {}}, sorted_);
  table_->setItemDelegateForColumn(TimingModel::kShare, new BarDelegate(TimingModel::kNumberRole, table_));
  table_->setSortingEnabled(true);
  table_->sortByColumn(TimingModel::kProcess, Qt::AscendingOrder);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  using enum ColumnKind;
  new ColumnFit(*table_, {kName, kName, kName, kNumber, kNumber, kNumber, kNumber, kNumber, kNumber});
  hint_ = new EmptyHint(table_);
  state_ = new QLabel(this);
  describe(*state_, {"timingState", tr("State of the measuring"), {}});
  auto* top = new QHBoxLayout;
  top->addWidget(makeLabeledButton(this, measure_));
  top->addWidget(state_, 1);
  for (QAction* action : {reset_, copy_}) top->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addLayout(top);
  layout->addWidget(table_, 1);
}

void TimingView::connectSignals() {
  connect(measure_, &QAction::triggered, this, &TimingView::measure);
  connect(reset_, &QAction::triggered, &model_, &TimingModel::reset);
  connect(copy_, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(model_.csv()); });
}

void TimingView::measure(bool on) {
  if (robot_.empty()) return;
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(kKey);
  request.mutable_set_key()->mutable_mode()->set_kind(on ? robotcontrol::KeyMode::ALWAYS
                                                         : robotcontrol::KeyMode::OFF);
  ask(session(), robot_, std::move(request), this, [this](bool accepted, const QString& reason) {
    state_->setText(accepted ? QString() : tr("The robot does not measure: %1").arg(reason));
  });
}

void TimingView::followRobot() {
  const std::string& robot = session().selectedRobot();
  if (robot == robot_) return;
  robot_ = robot;
  program_.clear();
  cursors_.clear();
  model_.reset();
  if (measure_->isChecked()) measure(true);
}

bool TimingView::forgetDead() {
  const auto* table = session().store().latestAs<robotcontrol::ProcessTable>(
      robot_ + '/' + robotlink::streams::kProcesses, session().timeline().newest());
  if (table == nullptr || model_.rowCount() == 0) return false;
  std::string program;
  for (const auto& process : table->processes()) {
    program += process.name() + ':';
    for (const std::string& task : process.tasks()) program += task + ',';
  }
  if (program == program_) return false;
  program_ = std::move(program);
  model_.keepOnly(*table);
  return true;
}

void TimingView::tick() {
  followRobot();
  bool added = false;
  if (!robot_.empty()) {
    for (const auto* stream : streamsOfType(session().store(), robot_, "robotcontrol.StopwatchTimes")) {
      const std::string process = lastPart(stream->path);
      for (const auto* message : cursors_[stream->path].take(*stream).messages) {
        const auto* times = dynamic_cast<const robotcontrol::StopwatchTimes*>(message->value.get());
        if (times == nullptr) continue;
        model_.add(process, message->frame, message->time, *times);
        added = true;
      }
    }
  }
  if (forgetDead() || added) model_.update();
  if (model_.rowCount() > 0) return hint_->setHint({});
  hint_->setHint(
      robot_.empty() ? tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar.")
      : measure_->isChecked() ? tr("Waiting for the robot's times. They come while its program runs.")
                              : tr("The robot does not measure. Press “Measure”."));
}

}  // namespace widgets
