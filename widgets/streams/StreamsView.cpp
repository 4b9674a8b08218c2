// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/streams/StreamsView.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/EmptyHint.h"

namespace widgets {
namespace {

const ViewRegistration kStreamsViewRegistration{
    {"log-streams", QT_TRANSLATE_NOOP("View", "Streams"),
     QT_TRANSLATE_NOOP("View",
                       "Lists the streams of logs and live robots with rates, sizes, what was left "
                       "out, and who asked for them."),
     "streams", false, create<StreamsView>}};

}  // namespace

StreamsView::StreamsView(ViewContext& context, QWidget* parent)
    : View(context, parent), logs_(openLogs(context)), filtered_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("streamsView"));
  createViews();
  connectSignals();
  keep("columns", table_->horizontalHeader());
  keep("which", which_);
  tick();
}

void StreamsView::createTable() {
  table_ = makeTable(this,
                     {"streamsTable", tr("All streams"),
                      tr("Check a stream to show it in the timeline; double click it to step its messages")},
                     filtered_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(StreamListModel::kPath, Qt::AscendingOrder);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setTextElideMode(Qt::ElideLeft);
  using enum ColumnKind;
  new ColumnFit(*table_,
                {kName, kNumber, kNumber, kNumber, kNumber, kNumber, kNumber, kNumber, kText, kText, kName});
  hint_ = new EmptyHint(table_);
}

void StreamsView::createViews() {
  auto* search = makeFilterField(this,
                                 {"streamsSearch", tr("Search streams"),
                                  tr("Shows only streams whose path, schema or reader contains this")},
                                 *filtered_, model_);
  filtered_->setFilterRole(StreamListModel::kFilterRole);
  filtered_->setSortRole(StreamListModel::kSortRole);
  which_ = new QComboBox(this);
  describe(*which_, {"streamsWhich", tr("Which streams"), tr("Which streams are listed")});
  which_->addItems({tr("All streams"), tr("Not read"), tr("With losses")});
  copy_ = makeAction(this, "copy",
                     {"streamsCopy", tr("Copy"), tr("Copies the selected rows"), QKeySequence::Copy});
  createTable();
  summary_ = new QLabel(this);
  describe(*summary_,
           {"streamsSummary", tr("Sums of all listed streams"),
            tr("Dropped: because too many arrived for this window, or because the queues of robots' "
               "own processes were full")});
  summary_->setMargin(4);
  auto* row = new QHBoxLayout;
  row->addWidget(search, 1);
  row->addWidget(which_);
  row->addWidget(makeButton(this, copy_));
  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addLayout(row);
  layout->addWidget(table_, 1);
  layout->addWidget(summary_);
}

void StreamsView::connectSignals() {
  connect(which_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this] { shownVersion_ = ~0ULL; });
  connect(copy_, &QAction::triggered, this, [this] {
    copyRows(*table_, [](const QModelIndex& row) { return firstTexts(row, StreamListModel::kSchema + 1); });
  });
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    const auto& row = model_.row(filtered_->mapToSource(index).row());
    if (const auto* log = logs_.find(row.log))
      logs_.replay().setSteppedStream(OpenLogs::sessionPath(*log, row.path));
  });
  connect(&model_, &StreamListModel::shownChanged, this,
          [this](const std::string& path, const std::string& stream, bool shown) {
            if (auto* log = logs_.find(path)) logs_.setHidden(*log, stream, !shown);
          });
  connect(&logs_.replay(), &ReplayControl::steppedStreamChanged, this, [this] { shownVersion_ = ~0ULL; });
}

std::vector<StreamRow> StreamsView::logRows() const {
  std::vector<StreamRow> rows;
  const StreamAskers askers(session());
  for (const auto& log : logs_.logs()) {
    for (auto& row : StreamListModel::rowsOf(log->path, *log->overview, log->hidden)) {
      const std::string path = OpenLogs::sessionPath(*log, row.path);
      row.stepped = path == logs_.replay().steppedStream();
      if (const auto* stream = session().store().find(path)) row.asked = askers.of(*stream);
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

void StreamsView::showStreams() {
  // This view's own look-ups do not count as reading.
  session().store().setReader(0);
  const bool isLog = !logs_.logs().empty();
  std::vector<StreamRow> rows = isLog ? logRows() : StreamListModel::rowsOf(session());
  if (isLog && !session().remoteRobots().empty()) {
    std::set<std::string> elsewhere;
    for (const auto& [robot, line] : session().remoteRobots()) elsewhere.insert(robot);
    for (StreamRow& row : StreamListModel::rowsOf(session(), &elsewhere)) rows.push_back(std::move(row));
  }
  session().readers().beginPeriod();
  model_.setRows(std::move(rows), static_cast<StreamListModel::Which>(which_->currentIndex()));
  table_->setColumnHidden(StreamListModel::kLog, logs_.logs().size() < 2);
  table_->setColumnHidden(StreamListModel::kLeftOut, session().remoteRobots().empty());
  const bool isAll = which_->currentIndex() == 0;
  hint_->setHint(
      model_.rowCount() > 0 ? QString()
      : !isAll              ? tr("There are no such streams. “All streams” lists the others.")
               : tr("Nothing is open.\nStart a simulation, connect to a robot, or open a log with File > "
                    "Open log…"));
  showSummary();
}

void StreamsView::tick() {
  // The period allows reading the rates.
  constexpr int kEvery = 15;
  const bool isDue = ticks_++ % kEvery == 0;
  const std::uint64_t listVersion = session().store().listVersion();
  if (!isDue && shownVersion_ == logs_.version() && listVersion == listVersion_) return;
  shownVersion_ = logs_.version();
  listVersion_ = listVersion;
  showStreams();
}

void StreamsView::showSummary() {
  std::uint64_t messages = 0, bytes = 0, thinned = 0, lost = 0;
  double byteRate = 0;
  for (int row = 0; row < model_.rowCount(); ++row) {
    const StreamRow& of = model_.row(row);
    messages += of.count;
    bytes += of.bytes;
    byteRate += of.byteRate;
    thinned += of.missing.thinned;
    lost += of.missing.lost;
  }
  QStringList parts{tr("streams: %1, messages: %2").arg(model_.rowCount()).arg(messages)};
  if (bytes > 0) parts << tr("size: %1").arg(bytesText(bytes));
  if (byteRate > 0) parts << tr("%1/s").arg(bytesText(static_cast<std::uint64_t>(byteRate)));
  parts << tr("dropped: %1").arg(session().dropped());
  if (thinned + lost > 0) parts << tr("thinned: %1, lost: %2").arg(thinned).arg(lost);
  summary_->setText(parts.join(QStringLiteral(", ")));
  summary_->setVisible(model_.rowCount() > 0);
}

}  // namespace widgets
