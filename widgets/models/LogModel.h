// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <deque>

#include "robotlink/base/Clock.h"

namespace widgets {

/// One text that a robot said.
struct LogEntry {
  enum class Level : std::uint8_t { kUnknown, kDebug, kInfo, kWarning, kError, kFatal };
  robotlink::Instant time;
  Level level = Level::kInfo;
  QString robot;
  QString source;  ///< "cognition/ball-percept"
  QString text;
  bool logged = false;  ///< an open log holds it, whether or not it was played
};

/// The texts of all robots as a table: time, level, robot, source, text. Bounded: past `capacity` rows the
/// oldest go, some hundred at a time, so that a full table costs no more than an empty one. A batch is one
/// insertion. GUI thread.
class LogModel final : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kTime, kLevel, kRobot, kSource, kText, kColumns };
  static constexpr int kLevelRole = Qt::UserRole + 1;

  explicit LogModel(std::size_t capacity = 100'000, QObject* parent = nullptr);

  void append(std::vector<LogEntry> entries);
  /// Each where its time belongs, behind those of the same time. For few of them, or for those that come
  /// after all others.
  void insert(std::vector<LogEntry> entries);
  /// Rows later than this are muted: a log holds them, but it was not yet played so far.
  void setShown(robotlink::Instant time);
  void clear();
  /// Removes what no log holds.
  void removePublished();
  const LogEntry& entry(int row) const { return entries_[static_cast<std::size_t>(row)]; }
  /// The last row that is not later than `time`; -1 if there is none.
  int rowAt(robotlink::Instant time) const;
  static QString levelName(LogEntry::Level level);
  /// What is shown as 0 s.
  void setOrigin(robotlink::Instant time);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::size_t capacity_;
  std::deque<LogEntry> entries_;
  robotlink::Instant origin_;
  robotlink::Instant shown_ = robotlink::Instant::max();
};

}  // namespace widgets
