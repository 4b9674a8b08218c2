// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Icon.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QTest>

#include "tests/widgets/Bench.h"

namespace widgets::test {
namespace {

/// The mean lightness of what an icon paints, by how opaque it is; -1 if it paints nothing.
double lightness(const QIcon& icon, QIcon::Mode mode = QIcon::Normal) {
  const QImage image = icon.pixmap(QSize(24, 24), mode).toImage().convertToFormat(QImage::Format_ARGB32);
  double sum = 0, weight = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QColor color = image.pixelColor(x, y);
      sum += color.lightnessF() * color.alphaF();
      weight += color.alphaF();
    }
  }
  return weight > 0 ? sum / weight : -1;
}

void useText(const QColor& color) {
  QPalette palette = QApplication::palette();
  palette.setColor(QPalette::WindowText, color);
  QApplication::setPalette(palette);
}

}  // namespace

class IconTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void everyIconPaintsSomething() {
    const QDir folder(QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/resources/icons"));
    const QStringList files = folder.entryList({QStringLiteral("*.svg")});
    QVERIFY(files.size() > 40);
    for (const QString& file : files) {
      QVERIFY2(lightness(widgets::icon(QString(file).remove(QStringLiteral(".svg")))) >= 0, qPrintable(file));
    }
  }

  /// With ROBOTCONTROL_TEST_PICTURES=FOLDER: all icons on one sheet, to be looked at.
  void iconsFitTheirSquare() {
    const QDir folder(QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/resources/icons"));
    const QStringList files = folder.entryList({QStringLiteral("*.svg")});
    QImage sheet(11 * 64, (files.size() / 11 + 1) * 64, QImage::Format_RGB32);
    sheet.fill(QApplication::palette().color(QPalette::Window));
    QPainter painter(&sheet);
    for (int i = 0; i < files.size(); ++i) {
      const QPixmap large = widgets::icon(QString(files[i]).remove(QStringLiteral(".svg"))).pixmap(48, 48);
      painter.drawPixmap(i % 11 * 64 + 8, i / 11 * 64 + 8, large);
      const QImage image = large.toImage();
      for (int k = 0; k < 48; ++k) {  // strokes that are cut off touch the border
        const bool touches = image.pixelColor(k, 0).alpha() > 128 || image.pixelColor(0, k).alpha() > 128 ||
                             image.pixelColor(k, 47).alpha() > 128 || image.pixelColor(47, k).alpha() > 128;
        QVERIFY2(!touches, qPrintable(files[i]));
      }
    }
    painter.end();
    keepPicture(sheet, "icons");
  }

  void everyViewHasItsIcon() {
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
      QVERIFY2(lightness(widgets::icon(type.icon)) >= 0, type.id);
    }
  }

  void anIconTakesThePalettesTextColorWheneverItIsPainted() {
    const QIcon play = widgets::icon("play");
    useText(Qt::black);
    QVERIFY(lightness(play) < 0.1);
    useText(Qt::white);
    QVERIFY(lightness(play) > 0.9);
  }

  void fixedColorsStay() {
    useText(Qt::black);
    const double before = lightness(widgets::icon("warning"));
    useText(Qt::white);
    QCOMPARE(lightness(widgets::icon("warning")), before);
  }

  void anUnknownIconPaintsNothing() { QCOMPARE(lightness(widgets::icon("no-such-icon")), -1.0); }
};

const GuiTest<IconTest> kIconTest;

}  // namespace widgets::test

#include "IconTest.moc"
