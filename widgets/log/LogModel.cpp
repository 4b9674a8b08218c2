// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogModel.h"

#include <QGuiApplication>
#include <algorithm>

#include "widgets/Theme.h"
#include "widgets/log/TimeScale.h"

namespace widgets {

LogModel::LogModel(std::size_t capacity, QObject* parent)
    : TimedModel({tr("Time [s]"), tr("Level"), tr("Robot"), tr("Source"), tr("Text")}, capacity, parent) {}

void LogModel::insert(std::vector<LogEntry> entries) {
  const auto earlier = [](const LogEntry& one, const LogEntry& other) { return one.time < other.time; };
  std::stable_sort(entries.begin(), entries.end(), earlier);
  if (entries_.empty() || entries.empty() || entries.front().time >= entries_.back().time)
    return append(std::move(entries));
  for (LogEntry& entry : entries) {
    if (entries_.size() >= capacity_) {
      if (earlier(entry, entries_.front())) continue;
      removeFirst(1);
    }
    const auto at = std::upper_bound(entries_.begin(), entries_.end(), entry, earlier);
    const int row = static_cast<int>(at - entries_.begin());
    beginInsertRows({}, row, row);
    entries_.insert(at, std::move(entry));
    endInsertRows();
  }
}

void LogModel::setShown(robotlink::Instant time) {
  // A list is used, since std::minmax() of two values would return references to temporaries.
  const auto [from, to] = std::minmax({rowAt(std::exchange(shown_, time)), rowAt(time)});
  if (from != to) Q_EMIT dataChanged(index(from + 1, 0), index(to, kColumns - 1), {Qt::ForegroundRole});
}

void LogModel::removePublished(robotlink::Instant after) {
  const auto begin = std::ranges::upper_bound(entries_, after, {}, &LogEntry::time) - entries_.begin();
  for (int end = rowCount(); end > begin;) {
    // The rows to remove are contiguous.
    int first = end;
    while (first > begin && !entry(first - 1).logged) --first;
    if (first < end) {
      beginRemoveRows({}, first, end - 1);
      entries_.erase(entries_.begin() + first, entries_.begin() + end);
      endRemoveRows();
    }
    end = first - 1;
  }
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
