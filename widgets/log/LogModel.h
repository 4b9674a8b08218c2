// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/TimedModel.h"

namespace widgets {

/// A text message (foxglove.Log) of a robot's program.
struct LogEntry {
  /// Numbered as in foxglove.Log.
  enum class Level : std::uint8_t { kUnknown, kDebug, kInfo, kWarning, kError, kFatal };
  robotlink::Instant time;
  Level level = Level::kInfo;
  QString robot;
  /// Name of the process and task: "cognition/ball-percept".
  QString source;
  QString text;
  /// Whether an open log contains it, played or not.
  bool logged = false;
};

/// The text messages of all robots as a table, sorted by time. GUI thread.
class LogModel final : public TimedModel<LogEntry> {
  Q_OBJECT
 public:
  /// Time in s, level, robot, source, text.
  enum Column { kTime, kLevel, kRobot, kSource, kText, kColumns };
  /// LogEntry::Level as int.
  static constexpr int kLevelRole = Qt::UserRole + 1;

  /// `capacity`: the largest number of rows.
  explicit LogModel(std::size_t capacity = 100'000, QObject* parent = nullptr);

  /// Inserts each message by its time, behind those of the same time. Messages that are later than all others
  /// are appended as one insertion; otherwise each one is an insertion, and once the table is full the
  /// remaining ones are dropped.
  void insert(std::vector<LogEntry> entries);
  /// Rows later than this are muted: an open log contains them, but the replay has not reached them.
  void setShown(robotlink::Instant time);
  /// Removes the messages that no open log contains: those that are later than `after`.
  void removePublished(robotlink::Instant after = robotlink::Instant::min());
  /// "warning"; translated.
  static QString levelName(LogEntry::Level level);

  QVariant data(const QModelIndex& index, int role) const override;

 private:
  /// See setShown(); by default nothing is muted.
  robotlink::Instant shown_ = robotlink::Instant::max();
};

}  // namespace widgets
