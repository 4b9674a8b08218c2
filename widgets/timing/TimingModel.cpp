// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimingModel.h"

#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

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
                   tr("Median ms"), tr("95 % ms"), tr("99 % ms"), tr("Max ms"), tr("Hz"), tr("Min period ms"),
                   tr("Max period ms"), tr("Jitter ms"), tr("Overruns"), tr("Share of period")},
                  parent) {}

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
  frames_[process].add(time, frame);
  for (const auto& entry : times.entries()) {
    Row& row = rowFor(process, entry.task(), entry.solution());
    row.times.add(entry.seconds());
    addRun(row, time);
  }
  countOverrun(process, times);
}

void TimingModel::addRun(Row& row, robotlink::Instant time) {
  const std::uint64_t frame = frames_[row.process].newest();
  if (row.latestFrame > 0 && frame == row.latestFrame + 1 && time >= row.latest)
    row.periods.add(robotlink::seconds(time - row.latest));
  row.latest = time;
  row.latestFrame = frame;
}

void TimingModel::countOverrun(const std::string& process, const robotcontrol::StopwatchTimes& times) {
  const auto known = periods_.find(process);
  const double period = frames_[process].period(known == periods_.end() ? 0 : known->second);
  const robotcontrol::StopwatchTimes::Entry* longest = nullptr;
  const robotcontrol::StopwatchTimes::Entry* whole = nullptr;
  for (const auto& entry : times.entries()) {
    if (entry.task().empty()) {
      whole = &entry;
    } else if (longest == nullptr || entry.seconds() > longest->seconds()) {
      longest = &entry;
    }
  }
  if (whole == nullptr || period <= 0 || whole->seconds() <= period) return;
  ++rowFor(process, {}, whole->solution()).overruns;
  if (longest != nullptr) ++rowFor(process, longest->task(), longest->solution()).overruns;
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
  periods_.clear();
  for (const auto& process : program.processes()) periods_[process.name()] = process.period();
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
  return found != frames_.end() && found->second.isNewest(row.latest) ? found->second.hertz() : 0;
}

double TimingModel::number(const Row& row, int column) const {
  switch (column) {
    case kLast:
      return row.times.last() * 1000;
    case kMean:
      return row.times.mean() * 1000;
    case kMinimum:
      return row.times.minimum() * 1000;
    case kMedian:
      return row.times.percentile(0.5) * 1000;
    case kNinetyFive:
      return row.times.percentile(0.95) * 1000;
    case kNinetyNine:
      return row.times.percentile(0.99) * 1000;
    case kMax:
      return row.times.maximum() * 1000;
    case kRate:
      return rateOf(row);
    case kPeriodMinimum:
      return row.periods.minimum() * 1000;
    case kPeriodMax:
      return row.periods.maximum() * 1000;
    case kJitter:
      return row.periods.deviation() * 1000;
    case kOverruns:
      return static_cast<double>(row.overruns);
    case kShare:
      return row.times.mean() * rateOf(row);
    default:
      return 0;
  }
}

QString TimingModel::shownText(const Row& row, int column) const {
  switch (column) {
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
    case kPeriodMinimum:
    case kPeriodMax:
    case kJitter:
      return row.periods.count() > 0 ? QString::number(number(row, column), 'f', 3) : QString();
    case kOverruns:
      return QString::number(row.overruns);
    default:
      return QString::number(number(row, column), 'f', 3);
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
  if (role == Qt::ForegroundRole && index.column() == kOverruns && row.overruns > 0)
    return colorOf(Meaning::kBad, QGuiApplication::palette());
  if (role == Qt::ToolTipRole && index.column() == kOverruns) {
    return tr("%1 of %2 frames, %3 %")
        .arg(row.overruns)
        .arg(row.times.count())
        .arg(100.0 * static_cast<double>(row.overruns) / static_cast<double>(row.times.count()), 0, 'f', 2);
  }
  if (role != Qt::DisplayRole && role != kNumberRole) return {};
  return shownText(row, index.column());
}

QVariant TimingModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::ToolTipRole)
    return TitledModel::headerData(section, orientation, role);
  switch (section) {
    case kMedian:
      return tr("Median: half of all frames took at most this long");
    case kNinetyFive:
      return tr("95th percentile");
    case kNinetyNine:
      return tr("99th percentile");
    case kPeriodMinimum:
      return tr("Shortest time from one frame to the next, on the robot's clock");
    case kPeriodMax:
      return tr("Longest time from one frame to the next, on the robot's clock");
    case kJitter:
      return tr("Standard deviation of the time from one frame to the next, on the robot's clock");
    case kOverruns:
      return tr(
          "Frames that took longer than the period of their process, or than the time from one frame "
          "to the next where it has none; of a task: those in which it took longest");
    case kShare:
      return tr("Mean time of the task, as a share of the time from one frame of its process to the next");
    default:
      return {};
  }
}

QString TimingModel::csv() const {
  QString text = QStringLiteral(
      "process,task,solution,last_ms,mean_ms,min_ms,median_ms,p95_ms,p99_ms,max_ms,hz,period_min_ms,period_"
      "max_ms,"
      "period_deviation_ms,overruns,share\n");
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
