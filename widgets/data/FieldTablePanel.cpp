// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/FieldTablePanel.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QProgressBar>
#include <QTableView>
#include <QToolButton>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/log/OpenLogs.h"

namespace widgets {
namespace {

constexpr int kTicksBeforeProgress = 15;  // ticks at 30 Hz before the progress is shown
constexpr int kPercent = 100;

enum SourceEntry { kHistoryEntry, kLogEntry };

}  // namespace

FieldTablePanel::FieldTablePanel(ViewContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      logs_(openLogs(context)),
      askForFile_([this](const QString& title, const QString& suggestion) {
        return QFileDialog::getSaveFileName(this, title, suggestion, tr("Tables (*.csv)"));
      }),
      worker_([this](const FieldTableSource& source, const std::stop_token& stop) {
        worker_.publish(makeTable(source, [this, &stop](double share) {
          share_ = share;
          return !stop.stop_requested();
        }));
      }) {
  setObjectName(QStringLiteral("dataTablePanel"));
  createActions();
  createViews();
  connect(refresh_, &QAction::triggered, this, &FieldTablePanel::refresh);
  connect(cancel_, &QAction::triggered, this, [this] { worker_.cancel(); });
  connect(csv_, &QAction::triggered, this, &FieldTablePanel::saveCsv);
  connect(close_, &QAction::triggered, this, &QWidget::hide);
  connect(source_, QOverload<int>::of(&QComboBox::activated), this, &FieldTablePanel::refresh);
}

void FieldTablePanel::createActions() {
  refresh_ = makeAction(this, "refresh",
                        {"dataTableRefresh", tr("Refresh"), tr("Rebuilds the table, up to now"), {}});
  cancel_ = makeAction(this, "close", {"dataTableCancel", tr("Cancel"), tr("Cancels the table"), {}});
  csv_ = makeAction(this, "save", {"dataTableCsv", tr("Save CSV"), tr("Writes the table to a file"), {}});
  close_ = makeAction(this, "close", {"dataTableClose", tr("Close"), tr("Hides the table"), {}});
}

void FieldTablePanel::createViews() {
  source_ = new QComboBox(this);
  describe(*source_, {"dataTableSource", tr("Values of"), tr("Which messages the table contains")});
  source_->insertItem(kHistoryEntry, tr("History"));
  source_->insertItem(kLogEntry, tr("Whole log"));
  state_ = new QLabel(this);
  describe(*state_, {"dataTableState", tr("State of the table"), {}});
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  progress_ = new QProgressBar(this);
  describe(*progress_, {"dataTableProgress", tr("Progress"), {}});
  progress_->setRange(0, kPercent);
  table_ = makeTable(this, {"dataTable", tr("Values over time"), {}}, &model_);
  table_->setTextElideMode(Qt::ElideRight);
  new ColumnFit(*table_, ColumnKind::kNumber);
  auto* top = makeToolRow(this, 0);
  top->addWidget(source_);
  top->addWidget(makeButton(this, refresh_));
  top->addWidget(makeButton(this, csv_));
  top->addWidget(state_, 1);
  top->addWidget(progress_);
  top->addWidget(makeButton(this, cancel_));
  top->addWidget(makeButton(this, close_));
  auto* layout = makeColumn(this, {}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(table_, 1);
  findChild<QToolButton*>(QStringLiteral("dataTableCancel"))->hide();
  progress_->hide();
}

void FieldTablePanel::show(std::vector<FieldColumn> columns) {
  columns_ = std::move(columns);
  setVisible(true);
  refresh();
}

bool FieldTablePanel::readsLog(FieldTableSource& source) {
  const OpenLogs::Log* log = logs_.current();
  if (log == nullptr) return false;
  source.columns = columns_;
  source.log = log->path;
  source.offset = log->offset;
  bool isThere = false;
  for (const FieldColumn& column : columns_) {
    std::string& found = source.logStreams.emplace_back();
    for (const auto& stream : log->overview->streams) {
      if (OpenLogs::sessionPath(*log, stream.path) == column.stream) found = stream.path;
    }
    isThere = isThere || !found.empty();
  }
  return isThere;
}

void FieldTablePanel::refresh() {
  FieldTableSource source;
  if (source_->currentIndex() != kLogEntry) {
    source = historyOf(context_.session.store(), context_.session.history().archive(), columns_);
  } else if (!readsLog(source)) {
    state_->setText(tr("No open log has these streams."));
    return;
  }
  state_->clear();
  share_ = 0;
  ticks_ = 0;
  worker_.post(std::move(source));
}

void FieldTablePanel::tick() {
  source_->setVisible(!logs_.logs().empty() || source_->currentIndex() == kLogEntry);
  if (ticks_ < 0) return;
  if (auto table = worker_.take()) take(std::move(*table));
  if (ticks_ >= 0) ++ticks_;
  progress_->setVisible(ticks_ > kTicksBeforeProgress);
  progress_->setValue(static_cast<int>(share_ * kPercent));
  findChild<QToolButton*>(QStringLiteral("dataTableCancel"))->setVisible(ticks_ > kTicksBeforeProgress);
}

void FieldTablePanel::take(robotlink::Result<FieldTable> table) {
  ticks_ = -1;
  if (!table) {
    state_->setText(table.error().id == "log.given-up" ? tr("Canceled")
                                                       : QString::fromStdString(table.error().describe()));
    return;
  }
  const bool isCut = table->isCut;
  model_.setTable(std::move(*table), context_.session.timeline().origin());
  csv_->setEnabled(model_.rowCount() > 0);
  const QString rows = counted(model_.rowCount(), tr("1 row"), tr("%1 rows"));
  state_->setText(isCut ? tr("The last %1; there are more").arg(rows) : rows);
  const int row = model_.rowAt(context_.session.timeline().shown());
  if (row >= 0) table_->selectRow(row);
}

void FieldTablePanel::saveCsv() {
  const QString file = askForFile_(tr("Save the table as CSV"), QStringLiteral("values.csv"));
  if (file.isEmpty()) return;
  const auto written =
      robotlink::writeFileAtomically(file.toStdString(), model_.table().csv(model_.origin()));
  state_->setText(written ? tr("Wrote %1").arg(file) : QString::fromStdString(written.error().describe()));
}

}  // namespace widgets
