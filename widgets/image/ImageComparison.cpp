// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageComparison.h"

#include <QPainter>
#include <algorithm>

namespace widgets {
namespace {

QImage fitted(const QImage& second, const QSize& size) {
  const QImage same = second.size() == size ? second : second.scaled(size);
  return same.format() == QImage::Format_RGB32 ? same : same.convertToFormat(QImage::Format_RGB32);
}

int differenceOf(QRgb a, QRgb b) {
  return std::max(
      {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

}  // namespace

QImage blended(const QImage& first, const QImage& second, double share) {
  if (first.isNull() || second.isNull()) return first;
  QImage result = fitted(first, first.size()).copy();
  QPainter painter(&result);
  painter.setOpacity(std::clamp(share, 0.0, 1.0));
  painter.drawImage(0, 0, fitted(second, first.size()));
  return result;
}

QImage difference(const QImage& first, const QImage& second, int gain) {
  if (first.isNull() || second.isNull()) return first;
  QImage result = fitted(first, first.size()).copy();
  const QImage other = fitted(second, first.size());
  const auto amplified = [gain](int a, int b) { return std::min(255, gain * std::abs(a - b)); };
  for (int y = 0; y < result.height(); ++y) {
    auto* to = reinterpret_cast<QRgb*>(result.scanLine(y));
    const auto* from = reinterpret_cast<const QRgb*>(other.constScanLine(y));
    for (int x = 0; x < result.width(); ++x)
      to[x] = qRgb(amplified(qRed(to[x]), qRed(from[x])), amplified(qGreen(to[x]), qGreen(from[x])),
                   amplified(qBlue(to[x]), qBlue(from[x])));
  }
  return result;
}

DifferenceStatistics statisticsOf(const QImage& first, const QImage& second, int tolerance) {
  DifferenceStatistics statistics;
  if (first.isNull() || second.isNull()) return statistics;
  const QImage one = fitted(first, first.size()), other = fitted(second, first.size());
  qint64 different = 0;
  for (int y = 0; y < one.height(); ++y) {
    const auto* a = reinterpret_cast<const QRgb*>(one.constScanLine(y));
    const auto* b = reinterpret_cast<const QRgb*>(other.constScanLine(y));
    for (int x = 0; x < one.width(); ++x) {
      const int by = differenceOf(a[x], b[x]);
      statistics.largest = std::max(statistics.largest, by);
      different += by > tolerance ? 1 : 0;
    }
  }
  statistics.share = static_cast<double>(different) / (static_cast<double>(one.width()) * one.height());
  return statistics;
}

}  // namespace widgets
