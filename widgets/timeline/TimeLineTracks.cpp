// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/TimeLineTracks.h"

#include <algorithm>
#include <set>
#include <utility>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/log/OpenLogs.h"
#include "widgets/plots/HistoryCurves.h"
#include "widgets/plots/LoggedCurves.h"
#include "widgets/plots/PastValues.h"

namespace widgets {

struct TimeLineTracks::Track {
  explicit Track(const PlotSource& from) : source(from), reader(from) {}

  PlotSource source;
  PlotReader reader;
  /// The values that have arrived, behind those read of the history.
  std::shared_ptr<robotlink::Series> live = std::make_shared<robotlink::Series>();
  PastValues past = {};
  /// Null: no open log has it.
  std::shared_ptr<const LoggedCurve> logged = {};
  /// Streams whose debug keys were requested; what a user switches off afterward stays off.
  std::set<std::string> requested = {};
};

TimeLineTracks::TimeLineTracks(robotlink::Session& session, OpenLogs& logs)
    : session_(session), logs_(logs) {}

TimeLineTracks::~TimeLineTracks() = default;

robotlink::Result<void> TimeLineTracks::add(const QString& source) {
  std::vector<std::string> streams;
  for (const auto* stream : session_.store().streams()) streams.push_back(stream->path);
  auto full = completed(PlotSource::fromText(source), session_.selectedRobot(), streams, session_.robots());
  if (!full) return tl::unexpected(full.error());
  if (!full->filter.empty() || !full->across.empty())
    return robotlink::failure("timeline.track",
                              "a timeline shows values as they are; leave out what follows | or over, or use "
                              "a plot");
  if (std::ranges::any_of(tracks_, [&](const auto& track) { return track->source == *full; })) return {};
  if (tracks_.size() >= kMax)
    return robotlink::failure("timeline.track", "a timeline shows at most " + std::to_string(kMax) +
                                                    " values; remove one by its context menu");
  tracks_.push_back(std::make_unique<Track>(*full));
  return {};
}

void TimeLineTracks::remove(const QString& source) {
  std::erase_if(tracks_, [&](const auto& track) { return track->source.text() == source; });
}

QStringList TimeLineTracks::sources() const {
  QStringList texts;
  for (const auto& track : tracks_) texts << track->source.text();
  return texts;
}

void TimeLineTracks::setSources(const QStringList& sources) {
  tracks_.clear();
  for (const QString& source : sources) {
    PlotSource read = PlotSource::fromText(source);
    const bool isPlain = !read.isEmpty() && read.filter.empty() && read.across.empty();
    if (isPlain && tracks_.size() < kMax) tracks_.push_back(std::make_unique<Track>(read));
  }
}

void TimeLineTracks::requestMissing(Track& track) {
  for (const std::string& stream : track.reader.streams()) {
    if (track.requested.contains(stream)) continue;
    const std::string key = keyFor(session_.store(), stream, session_.timeline().newest());
    if (key.empty()) continue;
    track.requested.insert(stream);
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(key);
    request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
    ask(session_, robotlink::streams::robotOf(stream), std::move(request));
  }
}

void TimeLineTracks::tick(bool afresh) {
  if (tracks_.empty()) return;
  const bool readsLogs = logs_.replay().open();
  if (readsLogs) LoggedCurves::of(logs_).tick();
  for (const auto& track : tracks_) {
    if (readsLogs) {
      track->logged = LoggedCurves::of(logs_).curve(track->source);
      continue;
    }
    track->logged.reset();
    requestMissing(*track);
    auto news = track->reader.take(session_.store());
    if (news.restarted || (afresh && news.missed)) {
      track->live->clear();
      track->past.restart();
    }
    for (const robotlink::Series::Point& point : news.points) {
      track->past.note(point, false);
      track->live->append(point);
    }
    readHistory(*track);
    track->live->limit(kMaxBytes);
  }
}

void TimeLineTracks::readHistory(Track& track) {
  HistoryCurves& history = HistoryCurves::of(logs_);
  history.tick(session_);
  robotlink::PointFilter none;
  track.past.mergeInto(*track.live, none);
  if (!track.past.isWanted()) return;
  const std::pair begin(*track.past.begin(), *track.past.begin());
  const auto missing = missingValues(session_, track.reader.streams(), begin, track.past.unread());
  missing.empty() ? track.past.skip() : track.past.read(history.curve(track.source));
}

std::vector<TimeLineTrack> TimeLineTracks::shown() const {
  std::vector<TimeLineTrack> all;
  for (const auto& track : tracks_) {
    TimeLineTrack& shown = all.emplace_back();
    shown.source = track->source.text();
    shown.unit = track->reader.unit();
    if (logs_.replay().open()) {
      // The curve owns its points.
      if (track->logged) shown.series = {track->logged, &track->logged->series};
      if (track->logged) shown.problem = track->logged->problem;
    } else {
      shown.series = track->live;
      shown.problem = track->reader.problem(session_.store());
      if (!track->live->empty())
        shown.missing =
            missingValues(session_, track->reader.streams(),
                          {track->live->front().time, track->live->back().time}, track->past.unread());
    }
    shown.points = shown.series ? shown.series->size() : 0;
    if (shown.series && !shown.series->empty()) shown.newest = shown.series->back().time;
  }
  return all;
}

}  // namespace widgets
