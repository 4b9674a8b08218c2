// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/TimeLineLayout.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr double kImages = 68, kGap = 6;
constexpr double kImageMargin = 2;
constexpr double kTrackRows = 2.4;  // height in rows

}  // namespace

const TimeLineLayout::Lane* TimeLineLayout::laneAt(const QPointF& point) const& {
  if (!body.contains(point)) return nullptr;
  const auto found =
      std::find_if(lanes.begin(), lanes.end(), [&](const Lane& lane) { return lane.rect.contains(point); });
  return found == lanes.end() ? nullptr : &*found;
}

TimeLineLayout layOut(const std::vector<TimeLineBand>& bands, const TimeLineLook& look) {
  const double ruler = look.row + 9, header = look.row + 5;
  TimeLineLayout layout;
  layout.ruler = QRectF(look.gutter, 0, std::max(0.0, look.size.width() - look.gutter), ruler);
  layout.body = QRectF(0, ruler, look.size.width(), std::max(0.0, look.size.height() - ruler));
  double y = ruler - look.scroll;
  const auto add = [&](TimeLineLayout::Kind kind, int band, double height, const std::string& stream = {}) {
    layout.lanes.push_back({kind, band, stream, QRectF(0, y, look.size.width(), height)});
    y += height;
  };
  for (int i = 0; i < static_cast<int>(bands.size()); ++i) {
    const TimeLineBand& band = bands[static_cast<std::size_t>(i)];
    add(TimeLineLayout::Kind::kHeader, i, header);
    if (band.hasImages) add(TimeLineLayout::Kind::kImages, i, kImages);
    if (saidOf(band) != nullptr) add(TimeLineLayout::Kind::kTexts, i, look.row);
    if (!band.collapsed) {
      for (const std::string& stream : band.streams) add(TimeLineLayout::Kind::kStream, i, look.row, stream);
    }
    for (const TimeLineTrack& track : band.tracks)
      add(TimeLineLayout::Kind::kTrack, i, kTrackRows * look.row, track.source.toStdString());
    y += kGap;
  }
  layout.height = y + look.scroll - ruler;
  return layout;
}

int thumbnailHeight() {
  return static_cast<int>(kImages - 2 * kImageMargin);
}

const std::vector<LogEntry>* saidOf(const TimeLineBand& band) {
  if (band.said != nullptr) return band.said.get();
  return band.log != nullptr ? &band.log->said : nullptr;
}

namespace {

/// The slots of a live robot, from the begin of all that is shown.
std::vector<ThumbnailSlot> historySlots(const TimeLineBand& band, const TimeLineLook& look, double width) {
  std::vector<ThumbnailSlot> slots;
  if (band.kept.empty()) return slots;
  Duration step = std::chrono::milliseconds(100);
  while (static_cast<double>(step.count()) < width * look.scale.nsPerPixel) step *= 2;
  const Instant from = std::max({look.begin, band.kept.front().from, look.scale.time(look.gutter) - step});
  const Instant to = std::min(band.kept.back().to, look.scale.time(look.size.width()));
  for (Instant time = look.begin + (from - look.begin) / step * step; time <= to; time += step) {
    const double left = look.scale.x(time);
    slots.push_back({left, left + width - kImageMargin, time});
  }
  return slots;
}

}  // namespace

std::vector<ThumbnailSlot> thumbnailSlots(const TimeLineBand& band, const TimeLineLook& look) {
  std::vector<ThumbnailSlot> slots;
  if (!band.hasImages) return slots;
  const double width = std::max(16.0, thumbnailHeight() * band.imageAspect + kImageMargin);
  if (band.log == nullptr) return historySlots(band, look, width);
  const double begin = look.scale.x(band.log->begin + band.offset),
               end = look.scale.x(band.log->end + band.offset);
  // Slots count from the log's beginning, so that the same images are shown while panning.
  const double first = std::max(0.0, std::floor((look.gutter - begin) / width));
  for (double i = first; begin + i * width <= std::min(end, look.size.width()); ++i) {
    const double left = begin + i * width;
    // The time of the slot's middle: at its left edge the first slot would be empty, and all others early.
    const Instant time = band.log->begin + Duration(std::llround((i + 0.5) * width * look.scale.nsPerPixel));
    slots.push_back({left, left + width - kImageMargin, time});
  }
  return slots;
}

QRectF bookmarkRect(const TimeLineBand& band, const logplayer::Bookmark& bookmark, const TimeLineLook& look,
                    const QRectF& lane, const QFontMetricsF& metrics) {
  constexpr double kMaxText = 180, kPole = 6;
  const double from = look.scale.x(bookmark.from + band.offset), to = look.scale.x(bookmark.to + band.offset);
  const double text =
      std::min(kMaxText, metrics.horizontalAdvance(QString::fromStdString(bookmark.text)) + 2 * kPole);
  return {from, lane.top() + 2, std::max({to - from, text, 12.0}), lane.height() - 4};
}

QRectF collapseRect(const QRectF& lane) {
  return {lane.left() + 2, lane.top(), 18, lane.height()};
}

QRectF offsetRect(const QRectF& lane, const TimeLineLook& look) {
  const double width = look.row * 3.8;
  return {look.gutter - width - 4, lane.top(), width, lane.height()};
}

}  // namespace widgets
