// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "logplayer/bookmarks/Bookmarks.h"
#include "robotlink/series/Series.h"
#include "robotlink/session/HistoryArchive.h"
#include "robotlink/session/RemoteRobot.h"
#include "widgets/log/LogOverview.h"
#include "widgets/log/MissingValues.h"
#include "widgets/log/TimeMark.h"
#include "widgets/log/TimeScale.h"

// Contents, look and geometry of a timeline: plain values and pure functions, shared by painting and mouse.
namespace widgets {

/// A value as a curve over time.
struct TimeLineTrack {
  /// The source that it shows, in the form of PlotSource::text().
  QString source;
  QString unit = {};
  /// Times are seconds on the session's timeline; null: there are no values.
  std::shared_ptr<const robotlink::Series> series = {};
  /// The reason why there are no values.
  QString problem = {};
  /// The parts of the history that the series lacks.
  std::vector<MissingValues> missing = {};
  /// The number of points, and the time of the last one: a series changes while it is shown.
  std::size_t points = 0;
  double newest = 0;
  bool operator==(const TimeLineTrack&) const = default;
};

/// A log of a timeline, or the history of a live robot. Times are the log's own; `offset` is added to
/// them.
struct TimeLineBand {
  /// Name of the log.
  QString title;
  robotlink::Duration offset{0};
  /// Whether the offset is shown, which it is if there are several logs.
  bool showsOffset = false;
  /// Whether the streams are hidden.
  bool collapsed = false;
  /// Null: not yet known.
  std::shared_ptr<const LogOverview> log;
  /// Paths of the streams that have a row, in this order.
  std::vector<std::string> streams;
  std::vector<logplayer::Bookmark> bookmarks;
  /// Warnings and errors of a live robot, sorted by time; null: there is no lane for them, or a log has them.
  std::shared_ptr<const std::vector<LogEntry>> said = {};
  /// Whether there is a lane with thumbnails.
  bool hasImages = false;
  /// The stretches of a live robot's messages that are kept, in order of time; those before `inMemory` are on
  /// disk; between these stretches messages were dropped. Empty for a log.
  std::vector<robotlink::Stretch> kept;
  robotlink::Instant inMemory{};
  /// Width by height of the images.
  double imageAspect = 4.0 / 3;
  /// Keyed by the times for which they were requested.
  std::map<robotlink::Instant, QImage> thumbnails;
  /// Stretches in which nothing was received from a remote robot; the band is that of the robot then, and
  /// has no log.
  std::vector<robotlink::LineGap> gaps;
  /// Only the last band has these; it is not a log then.
  std::vector<TimeLineTrack> tracks = {};
};

/// The visible part and its look. Sizes are logical pixels.
struct TimeLineLook {
  QSizeF size;
  /// Width of the column with names.
  double gutter = 190;
  /// Height of a stream's row, for the font in use.
  double row = 17;
  /// Times along x; its `left` is the gutter's right edge.
  TimeScale scale;
  /// Height that is scrolled away above the visible bands.
  double scroll = 0;
  /// Position of the play head.
  robotlink::Instant shown{};
  /// Extent of all logs; equal: no log is open, and the ruler is empty.
  robotlink::Instant begin{}, end{};
  /// The instant that the ruler shows as 0 s.
  robotlink::Instant origin{};
  /// The selected range; unset: none.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range;
  /// Band and id of the chosen bookmark; -1: none.
  std::pair<int, std::uint64_t> bookmark{-1, 0};
  /// Band and path of the stream whose messages are stepped; -1: none.
  std::pair<int, std::string> stream{-1, {}};
  /// The marks in the ruler: texts, and results of a search, in order of time; may be null.
  std::shared_ptr<const std::vector<TimeMark>> texts = {}, hits = {};
  /// Whether the widget has the focus.
  bool focused = false;
};

/// The places of everything, in widget pixels.
struct TimeLineLayout {
  /// The lanes of a band from top to bottom: title, thumbnails, text messages, one per stream, and one per
  /// value.
  enum class Kind : std::uint8_t { kHeader, kImages, kTexts, kStream, kTrack };
  /// A row over the whole width of the widget.
  struct Lane {
    Kind kind;
    int band;
    /// Path, for kStream; source, for kTrack.
    std::string stream;
    /// Gutter included.
    QRectF rect;
  };
  /// The ruler without the gutter.
  QRectF ruler;
  /// The visible part of the bands, gutter included.
  QRectF body;
  std::vector<Lane> lanes;
  /// Height of all bands.
  double height = 0;

  /// Null if there is none.
  const Lane* laneAt(const QPointF& point) const&;
  const Lane* laneAt(const QPointF& point) const&& = delete;  // it would not outlive the call
};

/// Computes the layout of all lanes, visible or not.
TimeLineLayout layOut(const std::vector<TimeLineBand>& bands, const TimeLineLook& look);

/// The warnings and errors of a log or a robot; null: there is no lane for them.
const std::vector<LogEntry>* saidOf(const TimeLineBand& band);

/// A place for a thumbnail: from x to x, and the time whose image it shows.
struct ThumbnailSlot {
  double left, right;
  /// In the log's own times.
  robotlink::Instant time;
};
/// The visible slots of a band; they keep their times while the timeline is panned. Those of a live robot
/// keep them also while its history grows: they are a whole power of two of 0.1 s apart.
std::vector<ThumbnailSlot> thumbnailSlots(const TimeLineBand& band, const TimeLineLook& look);
/// Height of thumbnails in pixels.
int thumbnailHeight();

/// The area of a bookmark's flag in its lane, text included.
QRectF bookmarkRect(const TimeLineBand& band, const logplayer::Bookmark& bookmark, const TimeLineLook& look,
                    const QRectF& lane, const QFontMetricsF& metrics);
/// The triangle that collapses a band.
QRectF collapseRect(const QRectF& lane);
/// The text with the band's offset.
QRectF offsetRect(const QRectF& lane, const TimeLineLook& look);

}  // namespace widgets
