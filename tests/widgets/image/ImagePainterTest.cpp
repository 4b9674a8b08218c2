// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImagePainter.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/widgets/GuiTest.h"

namespace widgets::test {

/// Captions of pictures.
class ImagePainterTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCaptionIsInTheCornerOfItsPane() {
    const QImage image = captioned(QStringLiteral("a"));
    QVERIFY(isDarkened(image, {100, 0, 20, 30}));
    QVERIFY(!isDarkened(image, {0, 0, 100, 80}));
    QVERIFY(!isDarkened(image, {150, 0, 50, 80}));
  }

  void aLongCaptionStaysInItsPane() {
    QVERIFY(!isDarkened(captioned(QStringLiteral("picture ").repeated(20)), {198, 0, 2, 80}));
  }

  void aLongCaptionHasLinesAndAWordThatIsTooLongIsShortened() {
    const auto bottom = [](const QString& text) {
      int y = 79;
      while (y > 0 && !isDarkened(captioned(text), {104, y, 20, 1})) --y;
      return y;
    };
    const int line = bottom(QStringLiteral("a"));
    QVERIFY(bottom(QStringLiteral("in the left picture")) >= 1.6 * line);
    QCOMPARE(bottom(QString(100, QLatin1Char('w'))), line);
    QVERIFY(!isDarkened(captioned(QString(100, QLatin1Char('w'))), {198, 0, 2, 80}));
  }

  void anEmptyCaptionPaintsNothing() { QVERIFY(!isDarkened(captioned({}), {0, 0, 200, 80})); }

 private:
  /// White, with a caption in its right half.
  static QImage captioned(const QString& text) {
    QImage image(200, 80, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintCaption(painter, {100, 0, 100, 80}, text);
    return image;
  }

  static bool isDarkened(const QImage& image, const QRect& part) {
    for (int y = part.top(); y <= part.bottom(); ++y) {
      for (int x = part.left(); x <= part.right(); ++x) {
        if (image.pixelColor(x, y) != QColor(Qt::white)) return true;
      }
    }
    return false;
  }
};

const GuiTest<ImagePainterTest> kImagePainterTest;

}  // namespace widgets::test

#include "ImagePainterTest.moc"
