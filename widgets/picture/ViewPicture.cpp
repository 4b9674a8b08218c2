// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture/ViewPicture.h"

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPainter>

#include "widgets/WrittenPicture.h"

namespace widgets {
namespace {

struct PictureText {
  Q_DECLARE_TR_FUNCTIONS(widgets::PictureFile)
};

}  // namespace

QImage paintedPicture(const QWidget& widget, const std::function<void(QPainter&)>& paint) {
  QImage picture(widget.size() * widget.devicePixelRatioF(), QImage::Format_RGB32);
  picture.setDevicePixelRatio(widget.devicePixelRatioF());
  picture.fill(Qt::black);
  QPainter painter(&picture);
  paint(painter);
  return picture;
}

bool savePicture(QWidget* view, const QImage& picture, const QString& file) {
  const auto written = writePicture(picture, file);
  if (written) return true;
  QMessageBox::warning(
      view, PictureText::tr("Save picture"),
      PictureText::tr("Nothing was saved to %1: %2").arg(file, QString::fromStdString(written.error().text)));
  return false;
}

void savePictureAs(QWidget* view, const QImage& picture, const QString& proposal) {
  QString file = QFileDialog::getSaveFileName(view, PictureText::tr("Save picture"), proposal,
                                              PictureText::tr("Pictures (*.png)"));
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) {
    file += QStringLiteral(".png");
    // The dialog has asked about the name without a suffix only.
    const bool mayWrite = !QFile::exists(file) ||
                          QMessageBox::question(view, PictureText::tr("Save picture"),
                                                PictureText::tr("Replace %1?").arg(file)) == QMessageBox::Yes;
    if (!mayWrite) return;
  }
  savePicture(view, picture, file);
}

void copyPicture(const QImage& picture) {
  QApplication::clipboard()->setImage(picture);
}

}  // namespace widgets
