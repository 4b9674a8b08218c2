// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/TimingModel.h"

#include <QFont>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"

namespace widgets {

TimingModel::Row& TimingModel::rowFor(const std::string& process, const std::string& task,
                                      const std::string& solution) {
  for (Row& row : rows_) {
    if (row.process == process && row.task == task && row.solution == solution) return row;
  }
  Row& added = rows_.emplace_back();
  added.process = process;
  added.task = task;
  added.solution = solution;
  return added;
}

void TimingModel::add(const std::string& process, robotlink::Instant time,
                      const robotcontrol::StopwatchTimes& times) {
  for (const auto& entry : times.entries()) {
    Row& row = rowFor(process, entry.task(), entry.solution());
    const double seconds = entry.seconds();
    row.minimum = row.count == 0 ? seconds : std::min(row.minimum, seconds);
    row.maximum = row.count == 0 ? seconds : std::max(row.maximum, seconds);
    if (row.count == 0 || time < row.latest) row.first = time;  // a clock that went back begins anew
    row.sum += seconds;
    row.last = seconds;
    row.latest = time;
    ++row.count;
  }
}

void TimingModel::update() {
  const int rows = static_cast<int>(rows_.size());
  if (rows > shown_) {
    beginInsertRows({}, shown_, rows - 1);
    shown_ = rows;
    endInsertRows();
  }
  if (rows > 0) Q_EMIT dataChanged(index(0, kLast), index(rows - 1, kShare));
}

void TimingModel::reset() {
  beginResetModel();
  rows_.clear();
  shown_ = 0;
  endResetModel();
}

double TimingModel::frameSum(const std::string& process) const {
  double sum = 0;
  for (const Row& row : rows_) {
    if (row.process == process && row.task.empty()) sum += row.sum;
  }
  return sum;
}

double TimingModel::number(const Row& row, int column) const {
  const double elapsed = robotlink::seconds(row.latest - row.first);
  switch (column) {
    case kLast:
      return row.last * 1000;
    case kMean:
      return row.count > 0 ? row.sum / static_cast<double>(row.count) * 1000 : 0;
    case kMinimum:
      return row.minimum * 1000;
    case kMaximum:
      return row.maximum * 1000;
    case kRate:
      return elapsed > 0 ? static_cast<double>(row.count - 1) / elapsed : 0;
    case kShare: {
      const double whole = frameSum(row.process);
      return whole > 0 ? row.sum / whole : 0;
    }
    default:
      return 0;
  }
}

int TimingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : shown_;
}

int TimingModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : kColumns;
}

QVariant TimingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool isText = index.column() <= kSolution;
  if (role == kNumberRole && !isText) return number(row, index.column());
  if (role == Qt::TextAlignmentRole && !isText) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::FontRole && row.task.empty()) {
    QFont font;
    font.setBold(true);
    return font;
  }
  if (role != Qt::DisplayRole && role != kNumberRole) return {};
  switch (index.column()) {
    case kProcess:
      return QString::fromStdString(row.process);
    case kTask:
      return row.task.empty() ? tr("frame") : QString::fromStdString(row.task);
    case kSolution:
      return QString::fromStdString(row.solution);
    case kShare:
      return tr("%1 %").arg(number(row, kShare) * 100, 0, 'f', 1);
    case kRate:
      return QString::number(number(row, kRate), 'f', 1);
    default:
      return QString::number(number(row, index.column()), 'f', 3);
  }
}

QVariant TimingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  const QString titles[] = {tr("Process"),  tr("Task"),     tr("Solution"), tr("Last ms"), tr("Mean ms"),
                            tr("Min ms"), tr("Max ms"), tr("Hz"),       tr("Share")};
  return titles[section];
}

QString TimingModel::csv() const {
  QString text = QStringLiteral("process,task,solution,last_ms,mean_ms,min_ms,max_ms,hz,share\n");
  for (const Row& row : rows_) {
    QStringList cells{QString::fromStdString(row.process),
                      row.task.empty() ? QStringLiteral("frame") : QString::fromStdString(row.task),
                      QString::fromStdString(row.solution)};
    for (int column = kLast; column < kColumns; ++column)
      cells << QString::number(number(row, column), 'g', 6);
    text += cells.join(QLatin1Char(',')) + QLatin1Char('\n');
  }
  return text;
}

}  // namespace widgets
