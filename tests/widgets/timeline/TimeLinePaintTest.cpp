// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/TimeLinePaint.h"

#include <QPainter>

#include "tests/widgets/LogBench.h"
#include "widgets/Theme.h"

namespace widgets::test {

using Kind = widgets::TimeLineLayout::Kind;

namespace {

QImage painted(const std::vector<widgets::TimeLineBand>& bands, const widgets::TimeLineLook& look) {
  QImage picture(look.size.toSize(), QImage::Format_RGB32);
  QPainter painter(&picture);
  widgets::paintTimeLine(painter, bands, look, QApplication::palette());
  widgets::paintPlayHead(painter, look, QApplication::palette());
  return picture;
}

}  // namespace

class TimeLinePaintTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void paintsImagesDensityTicksRangeAndPlayHead() {
    widgets::TimeLineBand band;
    band.title = QStringLiteral("game.mcap");
    band.log = std::make_shared<const widgets::LogOverview>(overviewOfTest(kFile));
    band.hasImages = true;
    for (const auto& stream : band.log->streams) band.streams.push_back(stream.path);
    widgets::TimeLineLook look;
    look.size = {1000, 300};
    look.gutter = look.scale.left = 200;
    look.begin = at(10);
    look.end = at(40);
    look.scale.from = at(10);
    look.scale.nsPerPixel = 30e9 / 800;
    look.shown = at(25);
    QImage orange(80, 60, QImage::Format_RGB32);
    orange.fill(QColor(250, 120, 10));
    for (const auto& slot : widgets::thumbnailSlots(band, look)) band.thumbnails[slot.time] = orange;
    const auto x = [&](double seconds) { return static_cast<int>(look.scale.x(at(seconds))); };
    const auto lane = [&](Kind kind, int index) {
      int found = 0;
      for (const auto& candidate : widgets::layOut({band}, look).lanes) {
        if (candidate.kind == kind && found++ == index) return candidate.rect.toRect();
      }
      return QRect();
    };
    const QImage picture = painted({band}, look);
    const QPalette palette = QApplication::palette();
    const auto isColor = [&](int px, int py, const QColor& color) {
      return isNear(picture.pixelColor(px, py), color);
    };
    QVERIFY(isColor(x(15), lane(Kind::kImages, 0).center().y(), QColor(250, 120, 10)));
    QVERIFY(isColor(x(18), lane(Kind::kTexts, 0).center().y(),
                    widgets::colorOf(widgets::Meaning::kWarning, palette)));
    QVERIFY(isColor(x(31), lane(Kind::kTexts, 0).center().y(),
                    widgets::colorOf(widgets::Meaning::kBad, palette)));
    QVERIFY(isColor(x(25), lane(Kind::kTexts, 0).center().y(), widgets::playHeadColor(palette)));
    const QRect joints = lane(Kind::kStream, 2);
    QVERIFY(!isColor(x(15), joints.bottom() - 4, palette.color(QPalette::Base)));
    QVERIFY(isColor(x(22), joints.bottom() - 4, palette.color(QPalette::Base)));  // the gap
    look.range = {at(26), at(30)};
    const QImage ranged = painted({band}, look);
    QVERIFY(ranged.pixelColor(x(28), joints.center().y()) != picture.pixelColor(x(28), joints.center().y()));
    QCOMPARE(ranged.pixelColor(x(33), joints.center().y()), picture.pixelColor(x(33), joints.center().y()));
  }
};

const GuiTest<TimeLinePaintTest> kTimeLinePaintTest;

}  // namespace widgets::test

#include "TimeLinePaintTest.moc"
