// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/WrittenPicture.h"

#include <QCoreApplication>
#include <QImage>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>
#include <QWidget>

namespace widgets {

robotlink::Result<void> writePicture(const QImage& picture, const QString& file) {
  if (!file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
    return robotlink::failure("picture.suffix", "pictures are written as .png", {file.toStdString(), 0, 0});
  QSaveFile out(file);
  if (!picture.isNull() && out.open(QIODevice::WriteOnly) && picture.save(&out, "PNG") && out.commit())
    return {};
  const QString reason = picture.isNull()
                             ? QCoreApplication::translate("widgets::PictureFile", "there is no picture yet")
                             : out.errorString();
  return robotlink::failure("picture.save", reason.toStdString(), {file.toStdString(), 0, 0});
}

robotlink::Result<void> writeVectorPicture(QWidget& shown, const QString& file) {
  QSaveFile out(file);
  if (out.open(QIODevice::WriteOnly)) {
    QSvgGenerator svg;
    svg.setOutputDevice(&out);
    svg.setSize(shown.size());
    svg.setViewBox(shown.rect());
    QPainter painter;
    if (painter.begin(&svg)) {
      shown.render(&painter);
      if (painter.end() && out.commit()) return {};
    }
  }
  return robotlink::failure("picture.save", out.errorString().toStdString(), {file.toStdString(), 0, 0});
}

}  // namespace widgets
