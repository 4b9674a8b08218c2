// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogModel.h"

#include <QGuiApplication>
#include <algorithm>

#include "widgets/Theme.h"
#include "widgets/log/TimeScale.h"

namespace widgets {

LogModel::LogModel(std::size_t capacity, QObject* parent)
    : TitledModel({tr("Time [s]"), tr("Level"), tr("Robot"), tr("Source"), tr("Text")}, parent),
      capacity_(capacity) {}

void LogModel::append(std::vector<LogEntry> entries) {
  if (entries.size() > capacity_)
    entries.erase(entries.begin(), entries.end() - static_cast<std::ptrdiff_t>(capacity_));
  if (entries.empty()) return;
  const std::size_t wanted = entries_.size() + entries.size();
  if (wanted > capacity_) {
    const std::size_t spare = std::max(wanted - capacity_, capacity_ / 100);
    const std::size_t removed = std::min(entries_.size(), spare);
    beginRemoveRows({}, 0, static_cast<int>(removed) - 1);
    entries_.erase(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(removed));
    endRemoveRows();
  }
  const int first = static_cast<int>(entries_.size());
  beginInsertRows({}, first, first + static_cast<int>(entries.size()) - 1);
  std::move(entries.begin(), entries.end(), std::back_inserter(entries_));
  endInsertRows();
}

void LogModel::insert(std::vector<LogEntry> entries) {
  const auto earlier = [](const LogEntry& one, const LogEntry& other) { return one.time < other.time; };
  std::stable_sort(entries.begin(), entries.end(), earlier);
  if (entries_.empty() || entries.empty() || entries.front().time >= entries_.back().time)
    return append(std::move(entries));
  for (LogEntry& entry : entries) {
    if (entries_.size() >= capacity_) {
      if (earlier(entry, entries_.front())) continue;
      beginRemoveRows({}, 0, 0);
      entries_.erase(entries_.begin());
      endRemoveRows();
    }
    const auto at = std::upper_bound(entries_.begin(), entries_.end(), entry, earlier);
    const int row = static_cast<int>(at - entries_.begin());
    beginInsertRows({}, row, row);
    entries_.insert(at, std::move(entry));
    endInsertRows();
  }
}

void LogModel::setShown(robotlink::Instant time) {
  // As a list, since std::minmax() of two values returns references to them, which end here.
  const auto [from, to] = std::minmax({rowAt(std::exchange(shown_, time)), rowAt(time)});
  if (from != to) Q_EMIT dataChanged(index(from + 1, 0), index(to, kColumns - 1), {Qt::ForegroundRole});
}

void LogModel::clear() {
  beginResetModel();
  entries_.clear();
  endResetModel();
}

void LogModel::removePublished() {
  if (std::none_of(entries_.begin(), entries_.end(), [](const LogEntry& said) { return said.logged; }))
    return clear();
  for (int row = rowCount() - 1; row >= 0; --row) {
    if (entry(row).logged) continue;
    beginRemoveRows({}, row, row);
    entries_.erase(entries_.begin() + row);
    endRemoveRows();
  }
}

int LogModel::rowAt(robotlink::Instant time) const {
  const auto later = std::upper_bound(
      entries_.begin(), entries_.end(), time,
      [](robotlink::Instant instant, const LogEntry& entry) { return instant < entry.time; });
  return static_cast<int>(later - entries_.begin()) - 1;
}

QString LogModel::levelName(LogEntry::Level level) {
  switch (level) {
    case LogEntry::Level::kDebug:
      return tr("debug");
    case LogEntry::Level::kInfo:
      return tr("info");
    case LogEntry::Level::kWarning:
      return tr("warning");
    case LogEntry::Level::kError:
      return tr("error");
    case LogEntry::Level::kFatal:
      return tr("fatal");
    case LogEntry::Level::kUnknown:
      break;
  }
  return tr("message");
}

void LogModel::setOrigin(robotlink::Instant time) {
  if (std::exchange(origin_, time) == time || entries_.empty()) return;
  Q_EMIT dataChanged(index(0, kTime), index(rowCount() - 1, kTime));
}

int LogModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(entries_.size());
}

QVariant LogModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const LogEntry& said = entry(index.row());
  if (role == kLevelRole) return static_cast<int>(said.level);
  if (role == Qt::TextAlignmentRole && index.column() == kTime) return kNumberAlignment;
  if (role == Qt::ToolTipRole && index.column() == kText) return said.text;
  if (role == Qt::ForegroundRole) {
    const QPalette palette = QGuiApplication::palette();
    if (said.time > shown_) return colorOf(Meaning::kMuted, palette);
    if (said.level >= LogEntry::Level::kError) return colorOf(Meaning::kBad, palette);
    if (said.level == LogEntry::Level::kWarning) return colorOf(Meaning::kWarning, palette);
    return said.level == LogEntry::Level::kDebug ? colorOf(Meaning::kMuted, palette) : QVariant();
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kTime:
      return timeText(said.time - origin_);
    case kLevel:
      return levelName(said.level);
    case kRobot:
      return said.robot;
    case kSource:
      return said.source;
    default:
      return said.text;
  }
}

}  // namespace widgets
