// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/StateStrip.h"

#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {

using robotlink::Series;

void StateStrip::setColors(const QPalette& palette, const QFont& font) {
  palette_ = palette;
  font_ = font;
}

void StateStrip::draw(QCPPainter* painter) {
  painter->setFont(font_);
  painter->setAntialiasing(false);
  for (const Part& part : parts_) {
    if (part.series && !part.series->empty()) drawPart(*painter, part);
  }
}

void StateStrip::drawState(QCPPainter& painter, const QRect& where, double value) const {
  if (where.width() <= 0) return;
  constexpr int kTextMargin = 3, kMinText = 14;
  const QColor &base = palette_.color(QPalette::Base), &text = palette_.color(QPalette::Text);
  const QColor color = curveColor(names_ ? names_->color(value) : 0, palette_);
  painter.fillRect(where, mixed(base, color, 0.4));
  painter.fillRect(QRect(where.left(), where.top(), 1, where.height()), mixed(color, text, 0.3));
  if (where.width() < kMinText || !names_) return;
  const QRect room = where.adjusted(kTextMargin, 0, -kTextMargin, 0);
  painter.setPen(text);
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft | Qt::TextSingleLine,
                   painter.fontMetrics().elidedText(names_->name(value), Qt::ElideRight, room.width()));
}

void StateStrip::drawPart(QCPPainter& painter, const Part& part) const {
  const Series& series = *part.series;
  const QRect area = keyAxis()->axisRect()->rect();
  const double from = keyAxis()->range().lower, to = keyAxis()->range().upper;
  const int count = area.width();
  if (count <= 0 || !(to > from)) return;
  const int top = static_cast<int>(std::lround(valueAxis()->coordToPixel(part.top))) + 1;
  const int bottom = static_cast<int>(std::lround(valueAxis()->coordToPixel(part.bottom))) - 1;
  const auto pixelAt = [&](double time) {
    const double share = std::clamp((time - from) / (to - from), 0.0, 1.0);
    return area.left() + static_cast<int>(share * count);
  };
  const auto rect = [&](int left, int right) { return QRect(left, top, right - left, bottom - top); };
  std::optional<double> state;
  int since = area.left();
  if (const std::size_t first = series.firstFrom(from); first > 0) state = series[first - 1].value;
  const auto endAt = [&](int x) {
    if (state && !std::isnan(*state)) drawState(painter, rect(since, x), *state);
  };
  const QColor mixedStates = mixed(palette_.color(QPalette::Base), palette_.color(QPalette::Text), 0.55);
  for (const Series::Column& column : series.columns(from, to, static_cast<std::size_t>(count))) {
    const double last = series[column.end - 1].value;
    const bool isOne = column.extent.min == column.extent.max;
    if (isOne && state == last) continue;
    const int x = std::min(pixelAt(series[column.begin].time), area.right());
    endAt(x);
    if (!isOne) painter.fillRect(rect(x, x + 1), mixedStates);
    since = isOne ? x : x + 1;
    state = last;
  }
  endAt(pixelAt(std::max(end_, series.back().time)));
  for (const auto& [begin, end] : gaps_)
    painter.fillRect(rect(pixelAt(begin), pixelAt(end)), palette_.color(QPalette::Base));
}

}  // namespace widgets
