// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <qcustomplot.h>

// The look that all canvases of plots share. GUI thread.
namespace widgets {

/// Sets background, and colors and fonts of the axes of an axis rectangle.
void stylePlot(QCustomPlot& plot, QCPAxisRect& area, const QPalette& palette, const QFont& font);
/// Shows the values of an extent with a margin; nothing changes for one that is empty.
void showExtent(QCPAxis& axis, double min, double max);

/// Ticks at round numbers of seconds since an origin.
class TimeTicker final : public QCPAxisTicker {
 public:
  explicit TimeTicker(double origin) { setTickOrigin(origin); }

 protected:
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override;
};

}  // namespace widgets
