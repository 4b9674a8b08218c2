// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/WrittenPicture.h"

#include <QCoreApplication>
#include <QImage>
#include <QSaveFile>

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

}  // namespace widgets
