// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TimeLineCanvas that shows: contents, zoom, pan and scrolling. TimeLineMouse.cpp has the
// reaction to mouse and keys.
#include "widgets/timeline/TimeLineCanvas.h"

#include <QPainter>
#include <QScrollBar>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/timeline/TimeLinePaint.h"

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr double kMarginShare = 0.02;  // margin on both sides of what is fitted, as a share of the width

bool sameContents(const std::vector<TimeLineBand>& a, const std::vector<TimeLineBand>& b) {
  const auto same = [](const TimeLineBand& x, const TimeLineBand& y) {
    const auto sameImage = [](const auto& p, const auto& q) {
      return p.first == q.first && p.second.cacheKey() == q.second.cacheKey();
    };
    return x.title == y.title && x.offset == y.offset && x.showsOffset == y.showsOffset &&
           x.collapsed == y.collapsed && x.log == y.log && x.streams == y.streams && x.said == y.said &&
           x.bookmarks == y.bookmarks && x.gaps == y.gaps && x.tracks == y.tracks && x.kept == y.kept &&
           x.inMemory == y.inMemory && x.hasImages == y.hasImages && x.imageAspect == y.imageAspect &&
           x.thumbnails.size() == y.thumbnails.size() &&
           std::equal(x.thumbnails.begin(), x.thumbnails.end(), y.thumbnails.begin(), sameImage);
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

}  // namespace

TimeLineCanvas::TimeLineCanvas(QWidget* parent) : QAbstractScrollArea(parent) {
  describe(*this, {"timeLineCanvas", tr("Timeline"), tr("The logs over time, with the playhead")});
  setToolTip({});
  setFocusPolicy(Qt::StrongFocus);
  setFrameShape(QFrame::NoFrame);
  setMinimumSize(320, 90);
  viewport()->setMouseTracking(true);
  setAcceptDrops(true);
  viewport()->setObjectName(QStringLiteral("timeLineViewport"));
  measure();
}

void TimeLineCanvas::measure() {
  const QFontMetricsF metrics(font());
  look_.row = std::ceil(metrics.height()) + 2;
  look_.gutter = std::ceil(metrics.averageCharWidth() * 32);
  look_.scale.left = look_.gutter;
}

void TimeLineCanvas::setBands(std::vector<TimeLineBand> bands) {
  if (sameContents(bands_, bands)) return;
  bands_ = std::move(bands);
  updateScrollBars();
  lookAnew();
}

void TimeLineCanvas::setExtent(Instant begin, Instant end) {
  if (extentKnown_ && begin == look_.begin && end == look_.end) return;
  look_.begin = begin;
  look_.end = end;
  const bool refit = !extentKnown_ || fitted_;
  extentKnown_ = end > begin;
  if (refit) return fit();
  updateScrollBars();
  lookAnew();
}

void TimeLineCanvas::setOrigin(Instant time) {
  if (time == look_.origin) return;
  look_.origin = time;
  lookAnew();
}

void TimeLineCanvas::setShown(Instant time) {
  if (held_.drag == Drag::kScrub || time == look_.shown) return;
  look_.shown = time;
  if (follow_) keepShownInSight();
  setAccessibleDescription(tr("Playhead at %1 s").arg(timeText(time - look_.origin)));
  viewport()->update();
}

void TimeLineCanvas::setRange(std::optional<std::pair<Instant, Instant>> range) {
  if (held_.drag == Drag::kSelect || held_.drag == Drag::kRangeEdge || range == look_.range) return;
  look_.range = range;
  lookAnew();
}

void TimeLineCanvas::setSteppedStream(int band, const std::string& path) {
  if (look_.stream == std::pair(band, path)) return;
  look_.stream = {band, path};
  lookAnew();
}

void TimeLineCanvas::setFollow(bool on) {
  follow_ = on;
  if (on) keepShownInSight();
}

void TimeLineCanvas::setScrubsEverywhere(bool on) {
  scrubsEverywhere_ = on;
}

void TimeLineCanvas::chooseBookmark(int band, std::uint64_t id) {
  look_.bookmark = {band, id};
  lookAnew();
}

void TimeLineCanvas::lookAnew() {
  still_ = {};
  viewport()->update();
}

void TimeLineCanvas::fit() {
  showRange(look_.begin, look_.end);
  fitted_ = true;
}

void TimeLineCanvas::showRange(Instant from, Instant to) {
  const double width = std::max(1.0, look_.size.width() - look_.gutter);
  const double span = std::max(1e6, static_cast<double>((to - from).count()));
  look_.scale.nsPerPixel = span / (width * (1 - 2 * kMarginShare));
  fitted_ = false;
  setFrom(from - Duration(std::llround(width * kMarginShare * look_.scale.nsPerPixel)));
}

void TimeLineCanvas::zoom(double factor) {
  const double head = look_.scale.x(look_.shown);
  const bool seen = head >= look_.gutter && head <= look_.size.width();
  look_.scale.zoomAt(seen ? head : (look_.gutter + look_.size.width()) / 2, factor);
  fitted_ = false;
  setFrom(look_.scale.from);
}

void TimeLineCanvas::setFrom(Instant from) {
  // A part of the logs always stays visible.
  const auto width =
      Duration(std::llround(std::max(1.0, look_.size.width() - look_.gutter) * look_.scale.nsPerPixel));
  const Instant earliest = std::min(look_.begin - width / 20, look_.end - width + width / 20);
  const Instant latest = std::max(look_.end - width + width / 20, look_.begin - width / 20);
  look_.scale.from = std::clamp(from, earliest, latest);
  updateScrollBars();
  lookAnew();
  Q_EMIT looked();
}

void TimeLineCanvas::keepShownInSight() {
  const double x = look_.scale.x(look_.shown), width = look_.size.width() - look_.gutter;
  if (x >= look_.gutter && x <= look_.size.width() - 0.02 * width) return;
  // Page by page, which is calmer and cheaper than a picture that always moves.
  setFrom(look_.scale.time(x) - Duration(std::llround(0.1 * width * look_.scale.nsPerPixel)));
}

void TimeLineCanvas::updateScrollBars() {
  if (settingBars_) return;
  settingBars_ = true;  // their signals are ignored meanwhile
  const TimeLineLayout all = layout();
  verticalScrollBar()->setPageStep(static_cast<int>(all.body.height()));
  verticalScrollBar()->setSingleStep(static_cast<int>(look_.row));
  verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(std::ceil(all.height - all.body.height()))));
  look_.scroll = verticalScrollBar()->value();
  const double begin = look_.scale.x(look_.begin) - look_.gutter,
               end = look_.scale.x(look_.end) - look_.gutter;
  const double width = look_.size.width() - look_.gutter;
  const double before = std::clamp(-begin, 0.0, 1e9), behind = std::clamp(end - width, 0.0, 1e9);
  horizontalScrollBar()->setPageStep(static_cast<int>(width));
  horizontalScrollBar()->setSingleStep(40);
  horizontalScrollBar()->setRange(0, static_cast<int>(before + behind));
  horizontalScrollBar()->setValue(static_cast<int>(before));
  settingBars_ = false;
}

void TimeLineCanvas::scrollContentsBy(int dx, int dy) {
  if (settingBars_) return;
  if (dy != 0) look_.scroll = verticalScrollBar()->value();
  if (dx != 0) {
    fitted_ = false;
    look_.scale.from -= Duration(std::llround(dx * look_.scale.nsPerPixel));
    Q_EMIT looked();
  }
  lookAnew();
}

std::vector<Instant> TimeLineCanvas::missingThumbnails(int index) const {
  std::vector<Instant> times;
  for (const ThumbnailSlot& slot : thumbnailSlots(band(index), look_)) {
    if (!band(index).thumbnails.contains(slot.time)) times.push_back(slot.time);
  }
  return times;
}

void TimeLineCanvas::resizeEvent(QResizeEvent* event) {
  QAbstractScrollArea::resizeEvent(event);
  look_.size = viewport()->size();
  if (fitted_ && extentKnown_) return fit();
  setFrom(look_.scale.from);
}

void TimeLineCanvas::paintEvent(QPaintEvent*) {
  if (still_.isNull()) {
    const qreal ratio = devicePixelRatioF();
    still_ = QPixmap((look_.size * ratio).toSize());
    still_.setDevicePixelRatio(ratio);
    QPainter painter(&still_);
    painter.setFont(font());
    paintTimeLine(painter, bands_, look_, palette());
  }
  QPainter painter(viewport());
  painter.drawPixmap(0, 0, still_);
  if (!bands_.empty()) paintPlayHead(painter, look_, palette());
}

void TimeLineCanvas::focusInEvent(QFocusEvent* event) {
  QAbstractScrollArea::focusInEvent(event);
  look_.focused = true;
  viewport()->update();
}

void TimeLineCanvas::focusOutEvent(QFocusEvent* event) {
  QAbstractScrollArea::focusOutEvent(event);
  look_.focused = false;
  viewport()->update();
}

void TimeLineCanvas::changeEvent(QEvent* event) {
  QAbstractScrollArea::changeEvent(event);
  if (event->type() == QEvent::FontChange) measure();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) lookAnew();
}

}  // namespace widgets
