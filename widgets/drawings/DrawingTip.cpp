// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drawings/DrawingTip.h"

#include <QCoreApplication>
#include <QHelpEvent>
#include <QImage>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/drawings/CurrentDrawings.h"

namespace widgets {
namespace {

constexpr int kTipReach = 4;         // pixels
constexpr int kMaxTipLetters = 200;  // of one value

QString sourceOf(const DrawingHit& hit, const QString& name) {
  if (hit.robot.empty()) return QCoreApplication::translate("DrawingTip", "stream %1").arg(name);
  if (isDrawnInShadow(hit.id))
    return QCoreApplication::translate("DrawingTip", "robot %1, debug key %2, of %3 in the shadow")
        .arg(QString::fromStdString(hit.robot), name.section(QLatin1Char('/'), 2),
             name.section(QLatin1Char('/'), 1, 1));
  return QCoreApplication::translate("DrawingTip", "robot %1, debug key %2")
      .arg(QString::fromStdString(hit.robot), name);
}

QString linesOf(const DrawingHit& hit) {
  const QString path = hit.id.section(QLatin1Char('/'), 1);
  const QString name = path.section(QLatin1Char('/'), -1);
  QStringList lines{QStringLiteral("<b>%1</b>").arg(name.toHtmlEscaped()),
                    sourceOf(hit, path).toHtmlEscaped()};
  for (const QString& value : hit.values.mid(0, kMaxTipValues))
    lines << value.left(kMaxTipLetters).toHtmlEscaped();
  return lines.join(QStringLiteral("<br>"));
}

}  // namespace

bool paintsAt(const QPointF& at, const std::function<void(QPainter&)>& paint) {
  constexpr int kSize = 2 * kTipReach + 1;
  QImage patch(kSize, kSize, QImage::Format_ARGB32_Premultiplied);
  patch.fill(Qt::transparent);
  {
    QPainter painter(&patch);
    painter.translate(QPointF(kTipReach, kTipReach) - QPointF(at.toPoint()));
    paint(painter);
  }
  for (int y = 0; y < kSize; ++y) {
    const auto* row = reinterpret_cast<const QRgb*>(patch.constScanLine(y));
    if (std::any_of(row, row + kSize, [](QRgb pixel) { return qAlpha(pixel) > 0; })) return true;
  }
  return false;
}

QString drawingTip(const std::vector<DrawingHit>& hits) {
  QStringList parts;
  for (const DrawingHit& hit : hits) {
    if (parts.size() < kMaxTipDrawings) parts << linesOf(hit);
  }
  if (parts.isEmpty()) return {};
  return QStringLiteral("<p style='white-space:pre'>%1</p>").arg(parts.join(QStringLiteral("<br><br>")));
}

bool showDrawingTip(QWidget& widget, const QHelpEvent& event, const std::vector<DrawingHit>& hits) {
  const QString tip = drawingTip(hits);
  if (tip.isEmpty()) return false;
  QRect around(0, 0, 2 * kTipReach + 1, 2 * kTipReach + 1);
  around.moveCenter(event.pos());
  QToolTip::showText(event.globalPos(), tip, &widget, around);
  return true;
}

}  // namespace widgets
