// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/StreamsView.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"

namespace widgets {
namespace {

const ViewRegistration kStreamsViewRegistration{
    {"log-streams", QT_TRANSLATE_NOOP("View", "Streams"),
     QT_TRANSLATE_NOOP("View", "Lists the streams of logs or live robots with count, size, rate and schema."),
     "streams", false, create<StreamsView>}};

}  // namespace

StreamsView::StreamsView(ViewContext& context, QWidget* parent)
    : View(context, parent), logs_(openLogs(context)), filtered_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("streamsView"));
  createViews();
  connectSignals();
  keep("columns", table_->horizontalHeader());
  tick();
}

void StreamsView::createViews() {
  auto* search = makeFilterField(
      this,
      {"streamsSearch", tr("Search streams"), tr("Shows only streams whose path or schema contains this")},
      *filtered_, model_);
  filtered_->setFilterRole(StreamListModel::kFilterRole);
  filtered_->setSortRole(StreamListModel::kSortRole);

  table_ = makeTable(this,
                     {"streamsTable", tr("Streams of the logs"),
                      tr("The check shows a stream in the timeline; a double click steps its messages")},
                     filtered_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(StreamListModel::kPath, Qt::AscendingOrder);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setTextElideMode(Qt::ElideMiddle);
  new ColumnFit(*table_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber, ColumnKind::kNumber,
                          ColumnKind::kName, ColumnKind::kName});
  hint_ = new EmptyHint(table_);
  summary_ = new QLabel(this);
  summary_->setObjectName(QStringLiteral("streamsSummary"));
  summary_->setMargin(4);

  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addWidget(search);
  layout->addWidget(table_, 1);
  layout->addWidget(summary_);
}

void StreamsView::connectSignals() {
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    const auto& row = model_.row(filtered_->mapToSource(index).row());
    if (const auto* log = logs_.find(row.log))
      logs_.replay().setSteppedStream(OpenLogs::sessionPath(*log, row.path));
  });
  connect(&model_, &StreamListModel::shownChanged, this,
          [this](const std::string& path, const std::string& stream, bool shown) {
            if (auto* log = logs_.find(path)) logs_.setHidden(*log, stream, !shown);
          });
  connect(&logs_.replay(), &ReplayControl::steppedStreamChanged, this, [this] { shownVersion_ = 0; });
}

void StreamsView::showLive() {
  // As often as rates can be read.
  constexpr int kEvery = 15;
  if (ticks_++ % kEvery != 0) return;
  model_.setRows(StreamListModel::rowsOf(session()));
  table_->setColumnHidden(StreamListModel::kLog, true);
  hint_->setHint(
      model_.rowCount() > 0
          ? QString()
          : tr("Nothing is open.\nStart a simulation, connect to a robot, or open a log with File > "
               "Open log…"));
  showSummary();
}

void StreamsView::tick() {
  if (logs_.logs().empty()) {
    shownVersion_ = 0;
    return showLive();
  }
  ticks_ = 0;
  if (shownVersion_ == logs_.version()) return;
  shownVersion_ = logs_.version();
  std::vector<StreamRow> rows;
  for (const auto& log : logs_.logs()) {
    for (auto& row : StreamListModel::rowsOf(log->path, *log->overview, log->hidden)) {
      row.stepped = OpenLogs::sessionPath(*log, row.path) == logs_.replay().steppedStream();
      rows.push_back(std::move(row));
    }
  }
  model_.setRows(std::move(rows));
  table_->setColumnHidden(StreamListModel::kLog, logs_.logs().size() < 2);
  hint_->setHint({});
  showSummary();
}

void StreamsView::showSummary() {
  std::uint64_t messages = 0, bytes = 0;
  for (int row = 0; row < model_.rowCount(); ++row) {
    messages += model_.row(row).count;
    bytes += model_.row(row).bytes;
  }
  summary_->setVisible(model_.rowCount() > 0);
  const QString all = tr("streams: %1, messages: %2").arg(model_.rowCount()).arg(messages);
  summary_->setText(bytes > 0 ? tr("%1, size: %2").arg(all, bytesText(bytes)) : all);
}

}  // namespace widgets
