// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/OptionHistory.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>

#include "robotcontrol/Motion.pb.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

struct HistoryTexts {
  Q_DECLARE_TR_FUNCTIONS(OptionHistory)
};

}  // namespace

void OptionHistory::clear() {
  rows_.clear();
  colors_.clear();
  end_ = 0;
  before_ = -1;
}

void OptionHistory::read(const robotlink::StreamStore::Stream* stream, robotlink::Instant until) {
  if (stream == nullptr) {
    clear();
    path_.clear();
    return;
  }
  const double last = robotlink::seconds(until);
  if (stream->path != path_ || stream->generation != generation_ || last < end_) clear();
  path_ = stream->path;
  generation_ = stream->generation;
  const double from = std::max(rows_.empty() ? -1e18 : end_, last - kSpan);
  auto at = std::ranges::upper_bound(stream->messages, from, {}, [](const robotlink::StreamMessage& message) {
    return robotlink::seconds(message.time);
  });
  for (; at != stream->messages.end() && at->time <= until; ++at)
    if (const auto* state = dynamic_cast<const robotcontrol::BehaviorState*>(at->value.get()))
      add(robotlink::seconds(at->time), *state);
}

void OptionHistory::addState(double time, const QString& option, const QString& state,
                             const QString& reason) {
  auto row = std::ranges::find(rows_, option, &Row::option);
  if (row == rows_.end()) row = rows_.insert(rows_.end(), {option, {}});
  colors_.try_emplace(state, static_cast<int>(colors_.size()));
  auto& segments = row->segments;
  // The segment continues if the option was active in the previous message, too.
  if (!segments.empty() && segments.back().state == state && segments.back().to >= before_) {
    segments.back().to = time;
    return;
  }
  if (!segments.empty() && segments.back().to >= before_) segments.back().to = time;
  segments.push_back({time, time, state, reason});
}

void OptionHistory::add(double time, const robotcontrol::BehaviorState& state) {
  before_ = rows_.empty() ? time : end_;
  end_ = time;
  for (const auto& active : state.active())
    addState(time, QString::fromStdString(active.option()), QString::fromStdString(active.state()),
             QString::fromStdString(active.reason()));
  if (state.active().empty())
    addState(time, QString::fromStdString(state.solution()), QString::fromStdString(state.state()),
             QString::fromStdString(state.reason()));
  for (Row& row : rows_)
    std::erase_if(row.segments, [&](const Segment& segment) { return segment.to < end_ - kSpan; });
}

QRectF OptionHistory::rectOf(std::size_t row, const Segment& segment, double width) const {
  const double scale = std::max(1.0, width - kNames) / kSpan;
  const double left = kNames + std::max(0.0, segment.from - end_ + kSpan) * scale;
  const double right = kNames + (segment.to - end_ + kSpan) * scale;
  return {left, static_cast<double>(row) * kRow + 1, std::max(1.0, right - left), kRow - 2};
}

const OptionHistory::Segment* OptionHistory::at(const QPointF& point, double width) const {
  for (std::size_t row = 0; row < rows_.size(); ++row)
    for (const Segment& segment : rows_[row].segments)
      if (rectOf(row, segment, width).contains(point)) return &segment;
  return nullptr;
}

QString OptionHistory::toolTip(const Segment& segment) {
  const QString text =
      HistoryTexts::tr("%1 for %2 s").arg(segment.state).arg(segment.to - segment.from, 0, 'f', 1);
  if (segment.reason.isEmpty()) return text;
  return text.toHtmlEscaped() + QStringLiteral("<br>") + segment.reason.toHtmlEscaped();
}

void OptionHistory::paint(QPainter& painter, const QRectF& area, const QPalette& palette) const {
  painter.save();
  painter.translate(area.topLeft());
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    painter.setPen(palette.color(QPalette::Text));
    painter.drawText(QRectF(2, static_cast<double>(row) * kRow, kNames - 6, kRow), Qt::AlignVCenter,
                     rows_[row].option);
    for (const Segment& segment : rows_[row].segments) {
      const QRectF rect = rectOf(row, segment, area.width());
      painter.fillRect(
          rect, mixed(palette.color(QPalette::Base), curveColor(colors_.at(segment.state), palette), 0.45));
      if (rect.width() > 30) painter.drawText(rect.adjusted(3, 0, -2, 0), Qt::AlignVCenter, segment.state);
    }
  }
  painter.restore();
}

}  // namespace widgets
