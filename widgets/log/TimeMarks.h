// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QRegularExpression>
#include <QString>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"
#include "widgets/log/LogModel.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/log/TimeMark.h"

namespace widgets {

/// The marks in the timeline and in all plots of a window: text messages that match a regular
/// expression, and where a simulated world was put to another instant, of open logs as a whole and of the
/// session; and what a search found. GUI thread; owned by the
/// logs.
class TimeMarks final : public QObject {
  Q_OBJECT
 public:
  /// The maximum number of marks: the first ones of logs, the newest ones of robots.
  static constexpr std::size_t kMaxMarks = 10'000;

  /// The marks of a window, created on the first call.
  static TimeMarks& of(OpenLogs& logs);

  /// Marks texts that match, in any case of letters; empty: none. Returns an empty text, or what is wrong
  /// with the expression, in which case all stays as it was.
  QString setPattern(const QString& pattern);
  const QString& pattern() const { return pattern_; }
  /// Sets the hits of a search, in order of time.
  void setHits(std::vector<TimeMark> hits);
  /// Takes new texts. May be called by several views in each tick.
  void tick(robotlink::Session& session);
  /// In order of time.
  const std::vector<TimeMark>& texts() const { return texts_; }
  const std::vector<TimeMark>& hits() const { return hits_; }
  /// Grows with every change.
  std::uint64_t version() const { return version_; }

 private:
  explicit TimeMarks(OpenLogs& logs) : QObject(&logs), logs_(logs) {}
  /// Forgets all texts if their source is another one.
  void startOver(robotlink::Session& session);
  void takeLogs();
  void takeSession(robotlink::Session& session);
  void add(LogEntry entry);

  OpenLogs& logs_;
  QString pattern_;
  QRegularExpression expression_;
  std::vector<TimeMark> texts_, hits_;
  std::uint64_t version_ = 1;
  /// The data seen in the last tick: the store's generation, and the logs' texts and offsets.
  std::uint64_t generation_ = 0;
  std::vector<std::pair<std::shared_ptr<const std::vector<LogEntry>>, robotlink::Duration>> listed_;
  std::map<std::string, StreamCursor> cursors_;
  /// Texts that are marked, by their times, so that one that is played is not marked twice.
  std::set<std::pair<robotlink::Instant, QString>> known_;
};

}  // namespace widgets
