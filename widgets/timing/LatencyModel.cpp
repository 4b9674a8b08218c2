// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/LatencyModel.h"

#include <algorithm>

namespace widgets {

LatencyModel::LatencyModel(QObject* parent)
    : TitledModel({tr("From"), tr("To"), tr("Last ms"), tr("Mean ms"), tr("Median ms"), tr("95 % ms"),
                   tr("99 % ms"), tr("Max ms"), tr("Waiting ms"), tr("Computing ms"), tr("Count")},
                  parent) {}

void LatencyModel::add(const Latency& latency) {
  auto found = std::ranges::find_if(rows_, [&](const Row& row) {
    return row.reading == latency.reading && row.command == latency.command;
  });
  if (found == rows_.end()) {
    rows_.push_back({latency.reading, latency.command, {}, {}, {}});
    found = std::prev(rows_.end());
  }
  found->total.add(latency.total());
  found->waiting.add(latency.waiting);
  found->computing.add(latency.computing);
}

void LatencyModel::update() {
  const int rows = static_cast<int>(rows_.size());
  if (rows > shown_) {
    beginInsertRows({}, shown_, rows - 1);
    shown_ = rows;
    endInsertRows();
  }
  if (rows > 0) Q_EMIT dataChanged(index(0, kLast), index(rows - 1, kCount));
}

void LatencyModel::reset() {
  beginResetModel();
  rows_.clear();
  shown_ = 0;
  endResetModel();
}

double LatencyModel::number(const Row& row, int column) const {
  switch (column) {
    case kLast:
      return row.total.last() * 1000;
    case kMean:
      return row.total.mean() * 1000;
    case kMedian:
      return row.total.percentile(0.5) * 1000;
    case kNinetyFive:
      return row.total.percentile(0.95) * 1000;
    case kNinetyNine:
      return row.total.percentile(0.99) * 1000;
    case kMax:
      return row.total.maximum() * 1000;
    case kWaiting:
      return row.waiting.mean() * 1000;
    case kComputing:
      return row.computing.mean() * 1000;
    default:
      return static_cast<double>(row.total.count());
  }
}

QString LatencyModel::summary() const {
  if (rows_.empty()) return {};
  const auto image = std::ranges::find_if(
      rows_, [](const Row& row) { return row.reading.find("image") != std::string::npos; });
  const Row& row = image == rows_.end() ? rows_.front() : *image;
  return tr("%1 to %2: %3 ms, 95 %: %4 ms")
      .arg(QString::fromStdString(row.reading), QString::fromStdString(row.command),
           QString::number(number(row, kMean), 'f', 1), QString::number(number(row, kNinetyFive), 'f', 1));
}

int LatencyModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : shown_;
}

QVariant LatencyModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool isText = index.column() <= kCommand;
  if (role == kNumberRole && !isText) return number(row, index.column());
  if (role == Qt::TextAlignmentRole && !isText) return kNumberAlignment;
  if (role != Qt::DisplayRole && role != kNumberRole) return {};
  if (isText) return QString::fromStdString(index.column() == kReading ? row.reading : row.command);
  if (index.column() == kCount) return QString::number(row.total.count());
  return QString::number(number(row, index.column()), 'f', 2);
}

QVariant LatencyModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::ToolTipRole)
    return TitledModel::headerData(section, orientation, role);
  switch (section) {
    case kReading:
      return tr("The reading of the platform, whose timestamp is the beginning");
    case kCommand:
      return tr("The command to the platform, the first that is based on the reading");
    case kWaiting:
      return tr(
          "Mean time on the robot's clock, from the reading's timestamp to the beginning of the frame "
          "that sent the command");
    case kComputing:
      return tr(
          "Mean real time from the beginning of that frame to the command; in lockstep, where the "
          "robot's clock is stopped meanwhile, it includes earlier processes");
    default:
      return {};
  }
}

QString LatencyModel::csv() const {
  QString text = QStringLiteral(
      "from,to,last_ms,mean_ms,median_ms,p95_ms,p99_ms,max_ms,waiting_ms,computing_ms,count\n");
  for (const Row& row : rows_) {
    QStringList cells{QString::fromStdString(row.reading), QString::fromStdString(row.command)};
    for (int column = kLast; column < kColumns; ++column)
      cells << QString::number(number(row, column), 'g', 6);
    text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace widgets
