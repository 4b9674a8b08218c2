// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/processes/TimingModel.h"

#include <QFont>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"

namespace widgets {
namespace {

constexpr robotlink::Duration kRateOver = std::chrono::seconds(2);

bool has(const robotcontrol::ProcessTable& program, const std::string& process, const std::string& task) {
  for (const auto& known : program.processes()) {
    if (known.name() != process) continue;
    return task.empty() || std::find(known.tasks().begin(), known.tasks().end(), task) != known.tasks().end();
  }
  return false;
}

}  // namespace

TimingModel::TimingModel(QObject* parent)
    : TitledModel({tr("Process"), tr("Task"), tr("Solution"), tr("Last ms"), tr("Mean ms"), tr("Min ms"),
                   tr("Max ms"), tr("Hz"), tr("Share of period")},
                  parent) {}

void TimingModel::Frames::add(Frame frame) {
  if (frame.number == 0) frame.number = recent.empty() ? 1 : recent.back().number + 1;
  // If the clock or the frame number went back (a reset, a jump, another program), start over.
  if (!recent.empty() && (frame.time < recent.back().time || frame.number <= recent.back().number))
    recent.clear();
  recent.push_back(frame);
  while (recent.size() > 2 && recent[1].time <= frame.time - kRateOver) recent.pop_front();
}

/// By the frames' numbers, so that frames that were not published do not matter.
double TimingModel::Frames::rate() const {
  if (recent.size() < 2) return 0;
  const double elapsed = robotlink::seconds(recent.back().time - recent.front().time);
  return elapsed > 0 ? static_cast<double>(recent.back().number - recent.front().number) / elapsed : 0;
}

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

void TimingModel::add(const std::string& process, std::uint64_t frame, robotlink::Instant time,
                      const robotcontrol::StopwatchTimes& times) {
  frames_[process].add({time, frame});
  for (const auto& entry : times.entries()) {
    Row& row = rowFor(process, entry.task(), entry.solution());
    const double seconds = entry.seconds();
    row.minimum = row.count == 0 ? seconds : std::min(row.minimum, seconds);
    row.maximum = row.count == 0 ? seconds : std::max(row.maximum, seconds);
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
  frames_.clear();
  shown_ = 0;
  endResetModel();
}

void TimingModel::keepOnly(const robotcontrol::ProcessTable& program) {
  for (std::size_t i = rows_.size(); i-- > 0;) {
    if (has(program, rows_[i].process, rows_[i].task)) continue;
    const int row = static_cast<int>(i);
    if (row < shown_) beginRemoveRows({}, row, row);
    if (rows_[i].task.empty()) frames_.erase(rows_[i].process);
    rows_.erase(rows_.begin() + row);
    if (row >= shown_) continue;
    --shown_;
    endRemoveRows();
  }
}

double TimingModel::rateOf(const Row& row) const {
  const auto found = frames_.find(row.process);
  if (found == frames_.end() || found->second.recent.empty() ||
      found->second.recent.back().time != row.latest)
    return 0;
  return found->second.rate();
}

double TimingModel::number(const Row& row, int column) const {
  const double mean = row.count > 0 ? row.sum / static_cast<double>(row.count) : 0;
  switch (column) {
    case kLast:
      return row.last * 1000;
    case kMean:
      return mean * 1000;
    case kMinimum:
      return row.minimum * 1000;
    case kMax:
      return row.maximum * 1000;
    case kRate:
      return rateOf(row);
    case kShare:
      return mean * rateOf(row);
    default:
      return 0;
  }
}

int TimingModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : shown_;
}

QVariant TimingModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const bool isText = index.column() <= kSolution;
  if (role == kNumberRole && !isText) return number(row, index.column());
  if (role == Qt::TextAlignmentRole && !isText) return kNumberAlignment;
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
      return rateOf(row) > 0 ? tr("%1 %").arg(number(row, kShare) * 100, 0, 'f', 2) : QString();
    case kRate:
      return rateOf(row) > 0 ? QString::number(rateOf(row), 'f', 1) : QString();
    default:
      return QString::number(number(row, index.column()), 'f', 3);
  }
}

QVariant TimingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == kShare)
    return tr("Mean time of the task, as a share of the time from one frame of its process to the next");
  return TitledModel::headerData(section, orientation, role);
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
