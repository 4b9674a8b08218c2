// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/TimeScale.h"

#include <QStringList>
#include <algorithm>
#include <cmath>

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr double kSecond = 1e9;
/// ns; sums of larger instants would overflow.
constexpr double kMax = 4e18;

Duration duration(double ns) {
  return Duration(static_cast<Duration::rep>(std::clamp(ns, -kMax, kMax)));
}

}  // namespace

double TimeScale::x(Instant time) const {
  return left + static_cast<double>((time - from).count()) / nsPerPixel;
}

Instant TimeScale::time(double x) const {
  return from + duration((x - left) * nsPerPixel);
}

void TimeScale::zoomAt(double x, double factor) {
  constexpr double kFinest = 1e3, kCoarsest = 1e15;  // 1 us and about twelve days a pixel
  const Instant fixed = time(x);
  nsPerPixel = std::clamp(nsPerPixel / factor, kFinest, kCoarsest);
  from = fixed - duration((x - left) * nsPerPixel);
}

AxisMarks axisMarks(const TimeScale& scale, double spacing, Instant origin) {
  const double wanted = std::max(1e3, spacing * scale.nsPerPixel);
  double step = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    if (step * factor + 0.5 < wanted) continue;
    step *= factor;
    break;
  }
  AxisMarks marks;
  marks.step = Duration(std::llround(step));
  marks.first = origin + marks.step * ((scale.from - origin) / marks.step);
  while (marks.first < scale.from) marks.first += marks.step;
  return marks;
}

QString timeText(Duration time, Duration resolution) {
  const double step = static_cast<double>(std::max<Duration::rep>(1, resolution.count())) / kSecond;
  const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  return QString::number(robotlink::seconds(time), 'f', digits);
}

std::optional<Duration> timeFromText(const QString& text, Duration now) {
  QString rest = text.trimmed();
  if (rest.endsWith(QLatin1Char('s'))) rest = rest.chopped(1).trimmed();
  rest.replace(QLatin1Char(','), QLatin1Char('.'));
  const bool relative = rest.startsWith(QLatin1Char('+')) || rest.startsWith(QLatin1Char('-'));
  const double sign = rest.startsWith(QLatin1Char('-')) ? -1 : 1;
  if (relative) rest = rest.mid(1);
  const QStringList parts = rest.split(QLatin1Char(':'));
  if (parts.size() > 3) return std::nullopt;
  double value = 0;
  for (const QString& part : parts) {
    bool ok = false;
    const double number = part.toDouble(&ok);
    if (!ok || !std::isfinite(number) || number < 0) return std::nullopt;
    value = value * 60 + number;
  }
  if (value > kMax / kSecond) return std::nullopt;
  return relative ? now + duration(sign * value * kSecond) : duration(value * kSecond);
}

}  // namespace widgets
