// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/TimeMarks.h"

#include <algorithm>

#include "foxglove/Robot.pb.h"
#include "robotlink/debugging/Streams.h"

namespace widgets {

using robotlink::Instant;

TimeMarks& TimeMarks::of(OpenLogs& logs) {
  auto* known = logs.findChild<TimeMarks*>(QString(), Qt::FindDirectChildrenOnly);
  return known != nullptr ? *known : *new TimeMarks(logs);
}

QString TimeMarks::setPattern(const QString& pattern) {
  if (pattern == pattern_) return {};
  const QRegularExpression expression(pattern, QRegularExpression::CaseInsensitiveOption);
  if (!expression.isValid())
    return tr("%1 at character %2").arg(expression.errorString()).arg(expression.patternErrorOffset() + 1);
  pattern_ = pattern;
  expression_ = expression;
  listed_.clear();
  generation_ = 0;
  ++version_;
  return {};
}

void TimeMarks::setHits(std::vector<TimeMark> hits) {
  hits_ = std::move(hits);
  ++version_;
}

void TimeMarks::add(LogEntry entry) {
  const bool isJump = entry.source == QLatin1String(robotlink::streams::kWorldSource);
  if (!isJump && (pattern_.isEmpty() || !expression_.match(entry.text).hasMatch())) return;
  if (!known_.emplace(entry.time, entry.text).second) return;
  const auto at = std::ranges::upper_bound(texts_, entry.time, {}, &TimeMark::from);
  texts_.insert(at, {entry.time, entry.time, std::move(entry.text), entry.level});
  ++version_;
}

void TimeMarks::takeLogs() {
  for (const auto& [texts, offset] : listed_) {
    if (!texts) continue;
    for (const LogEntry& entry : *texts) {
      if (texts_.size() >= kMaxMarks) return;
      LogEntry shifted = entry;
      shifted.time += offset;
      add(std::move(shifted));
    }
  }
}

void TimeMarks::takeSession(robotlink::Session& session) {
  auto& store = session.store();
  for (const auto* stream : streamsOfType(store, {}, "foxglove.Log")) {
    for (const auto* message : cursors_[stream->path].take(*stream).messages) {
      const auto* log = dynamic_cast<const foxglove::Log*>(message->value.get());
      if (log == nullptr) continue;
      const auto level = static_cast<LogEntry::Level>(std::clamp(static_cast<int>(log->level()), 0, 5));
      add({message->time,
           level,
           {},
           QString::fromStdString(log->name()),
           QString::fromStdString(log->message())});
    }
  }
  while (texts_.size() > kMaxMarks) {
    known_.erase({texts_.front().from, texts_.front().text});
    texts_.erase(texts_.begin());
  }
}

void TimeMarks::startOver(robotlink::Session& session) {
  auto& store = session.store();
  decltype(listed_) listed;
  for (const auto& log : logs_.logs()) listed.emplace_back(log->overview->texts, log->offset);
  // A generation begins at 0; here 0 means none.
  const std::uint64_t generation = store.generation() + 1;
  if (listed == listed_ && generation == generation_) return;
  listed_ = std::move(listed);
  generation_ = generation;
  if (!texts_.empty()) ++version_;
  texts_.clear();
  known_.clear();
  cursors_.clear();
  takeLogs();
}

void TimeMarks::tick(robotlink::Session& session) {
  startOver(session);
  takeSession(session);
}

}  // namespace widgets
