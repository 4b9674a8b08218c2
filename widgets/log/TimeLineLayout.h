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

#include "logplayer/Bookmarks.h"
#include "widgets/models/LogOverview.h"
#include "widgets/models/TimeScale.h"

namespace widgets {

/// One log of a time line. Times are the log's own; `offset` is added to them.
struct TimeLineBand {
  QString title;
  robotlink::Duration offset{0};
  bool showsOffset = false;  ///< there are several logs
  bool collapsed = false;    ///< the streams are hidden
  std::shared_ptr<const LogOverview> log;
  std::vector<std::string> streams;  ///< that have a row, in this order
  std::vector<logplayer::Bookmark> bookmarks;
  bool hasImages = false;
  double imageAspect = 4.0 / 3;                     ///< width by height
  std::map<robotlink::Instant, QImage> thumbnails;  ///< by the time that they were asked for
};

/// What of it is seen and how.
struct TimeLineLook {
  QSizeF size;
  double gutter = 190;  ///< width of the names' column
  double row = 17;      ///< height of a stream's row, for the font in use
  TimeScale scale;      ///< its `left` is the gutter's right edge
  double scroll = 0;    ///< pixels that are scrolled away above the bands
  robotlink::Instant shown{};
  robotlink::Instant begin{}, end{};  ///< of all logs; equal: no log is open, and the ruler is empty
  robotlink::Instant origin{};        ///< what the ruler shows as 0 s
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range;
  std::pair<int, std::uint64_t> bookmark{-1, 0};  ///< band and id of the chosen one
  std::pair<int, std::string> stream{-1, {}};     ///< band and path of the one whose messages are stepped
  bool focused = false;
};

/// Where everything lies.
struct TimeLineLayout {
  enum class Kind : std::uint8_t { kHeader, kImages, kTexts, kStream };
  struct Lane {
    Kind kind;
    int band;
    std::string stream;  ///< of kStream
    QRectF rect;         ///< as wide as the widget, gutter included
  };
  QRectF ruler;  ///< without the gutter
  QRectF body;   ///< what of the bands is seen, gutter included
  std::vector<Lane> lanes;
  double height = 0;  ///< that all bands need

  /// Null if there is none.
  const Lane* laneAt(const QPointF& point) const&;
  const Lane* laneAt(const QPointF& point) const&& = delete;  // it would not outlive the call
};

TimeLineLayout layOut(const std::vector<TimeLineBand>& bands, const TimeLineLook& look);

/// Where pictures stand in a strip: from which x to which, and the time whose image is shown.
struct ThumbnailSlot {
  double left, right;
  robotlink::Instant time;  ///< of the log
};
std::vector<ThumbnailSlot> thumbnailSlots(const TimeLineBand& band, const TimeLineLook& look);
/// Height of the images in a strip, in pixels.
int thumbnailHeight();

/// What of a bookmark can be clicked: its flag, text included.
QRectF bookmarkRect(const TimeLineBand& band, const logplayer::Bookmark& bookmark, const TimeLineLook& look,
                    const QRectF& lane, const QFontMetricsF& metrics);
/// The triangle that collapses a band, and the text that tells its offset.
QRectF collapseRect(const QRectF& lane);
QRectF offsetRect(const QRectF& lane, const TimeLineLook& look);

}  // namespace widgets
