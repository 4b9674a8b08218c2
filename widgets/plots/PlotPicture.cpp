// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/PlotPicture.h"

#include <qcustomplot.h>

#include <QSvgGenerator>

namespace widgets {
namespace {

/// The resolution of pictures, compared with the screen's.
constexpr double kPictureScale = 2;

/// The plots that are seen, with where they are.
std::vector<std::pair<QCustomPlot*, QRect>> plotsIn(const QWidget& area) {
  std::vector<std::pair<QCustomPlot*, QRect>> plots;
  for (QCustomPlot* plot : area.findChildren<QCustomPlot*>()) {
    if (plot->isVisibleTo(&area)) plots.emplace_back(plot, QRect(plot->mapTo(&area, QPoint()), plot->size()));
  }
  return plots;
}

}  // namespace

QPixmap plotsPicture(const QWidget& area) {
  QPixmap picture(area.size() * kPictureScale);
  picture.fill(area.palette().color(QPalette::Base));
  QPainter painter(&picture);
  for (const auto& [plot, place] : plotsIn(area)) {
    QPixmap one = plot->toPixmap(place.width(), place.height(), kPictureScale);
    one.setDevicePixelRatio(1);
    painter.drawPixmap(QRect(place.topLeft() * kPictureScale, place.size() * kPictureScale), one);
  }
  return picture;
}

bool savePlots(const QWidget& area, const QString& file) {
  if (!file.endsWith(QLatin1String(".svg"), Qt::CaseInsensitive)) return plotsPicture(area).save(file, "PNG");
  QSvgGenerator svg;
  svg.setFileName(file);
  svg.setSize(area.size());
  svg.setViewBox(area.rect());
  QCPPainter painter;
  if (!painter.begin(&svg)) return false;
  for (const auto& [plot, place] : plotsIn(area)) {
    painter.save();
    painter.translate(place.topLeft());
    plot->toPainter(&painter, place.width(), place.height());
    painter.restore();
  }
  return painter.end();
}

}  // namespace widgets
