// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotStyle.h"

#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {

void stylePlot(QCustomPlot& plot, QCPAxisRect& area, const QPalette& palette, const QFont& font) {
  const QColor& text = palette.color(QPalette::Text);
  const QColor& base = palette.color(QPalette::Base);
  plot.setBackground(base);
  const QList<QCPAxis*> axes = area.axes();
  for (QCPAxis* axis : axes) {
    axis->setBasePen(mixed(base, text, 0.6));
    axis->setTickPen(mixed(base, text, 0.6));
    axis->setSubTickPen(mixed(base, text, 0.3));
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->setTickLabelFont(font);
    axis->setLabelFont(font);
    axis->grid()->setPen(QPen(mixed(base, text, 0.18), 0, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(mixed(base, text, 0.35), 0));
  }
}

void showExtent(QCPAxis& axis, double min, double max) {
  if (!(min <= max)) return;
  const double size = max - min, center = (min + max) / 2;
  const double margin = size > 0 ? size * 0.06 : std::max(1e-3, std::abs(center) * 0.1);
  axis.setRange(min - margin, max + margin);
}

QString TimeTicker::getTickLabel(double tick, const QLocale& locale, QChar format, int precision) {
  return QCPAxisTicker::getTickLabel(tick - tickOrigin(), locale, format, precision);
}

}  // namespace widgets
