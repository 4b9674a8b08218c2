// SPDX-License-Identifier: GPL-3.0-or-later
// What lies where in the chart, what it says, and what is seen; TimingViewTest has the mouse.
#include "widgets/timing/GanttPaint.h"

#include <QImage>
#include <QPainter>
#include <QPalette>
#include <QtTest>

#include "robotcontrol/Debugging.pb.h"
#include "tests/widgets/Bench.h"
#include "widgets/Theme.h"

namespace widgets::test {
namespace {

using robotlink::Instant;

Instant ganttTime(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

GanttFrame ganttFrame(double time, std::initializer_list<std::pair<const char*, double>> entries,
                      double period = 0) {
  auto times = std::make_shared<robotcontrol::StopwatchTimes>();
  GanttFrame frame{ganttTime(time), 7, 0, period, nullptr};
  for (const auto& [task, seconds] : entries) {
    auto& entry = *times->add_entries();
    entry.set_task(task);
    entry.set_solution("usual");
    entry.set_seconds(seconds);
    if (*task != 0) frame.seconds += seconds;
  }
  frame.times = times;
  return frame;
}

/// A second in 1000 pixels behind a gutter of 100, from 10 s on; one lane with a frame of 0.1 s.
GanttLook ganttLook() {
  GanttLook look;
  look.size = {1100, 220};
  look.scale = {100, ganttTime(10), 1e6};
  look.origin = ganttTime(10);
  look.shown = ganttTime(10.5);
  look.lanes.push_back({"cognition", {ganttFrame(10.2, {{"ball", 0.06}, {"pose", 0.04}})}, 0, 0});
  look.tasks = {"ball", "pose"};
  return look;
}

QImage ganttPicture(const GanttLook& look, const QPalette& palette) {
  QImage image(look.size, QImage::Format_RGB32);
  QPainter painter(&image);
  paintGantt(painter, look, palette);
  return image;
}

}  // namespace

class GanttPaintTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void lanesShareTheHeightWithinTheirBounds() {
    GanttLook look = ganttLook();
    QCOMPARE(ganttLaneRect(look, 0).height(), double{kMaxGanttLane});
    look.lanes.resize(4, look.lanes[0]);
    QCOMPARE(ganttLaneRect(look, 0).top(), double{kGanttRuler});
    QCOMPARE(ganttLaneRect(look, 3), QRectF(0, 20 + 3 * 50, 1100, 50));
    look.lanes.resize(20, look.lanes[0]);
    QCOMPARE(ganttLaneRect(look, 1).height(), double{kMinGanttLane});
    look.lanes.clear();
    QVERIFY(ganttLaneRect(look, 0).height() > 0);
  }

  void barsLieWhereTheirTimesAre() {
    const GanttLook look = ganttLook();
    const QRectF frame = ganttBar(look, {0, 0, -1}), ball = ganttBar(look, {0, 0, 0}),
                 pose = ganttBar(look, {0, 0, 1});
    QCOMPARE(frame.left(), 300.0);
    QCOMPARE(frame.width(), 100.0);
    QCOMPARE(ball.left(), 300.0);
    QCOMPARE(ball.width(), 60.0);
    QCOMPARE(pose.left(), 360.0);
    QCOMPARE(pose.width(), 40.0);
    QVERIFY(frame.bottom() < ball.top());
    QVERIFY(ganttLaneRect(look, 0).contains(pose));
  }

  void aFrameIsSeenHoweverShortItIs() {
    GanttLook look = ganttLook();
    look.lanes[0].frames = {ganttFrame(10.2, {{"ball", 1e-9}})};
    QCOMPARE(ganttBar(look, {0, 0, -1}).width(), 1.0);
  }

  void theTimeOfTheWholeFrameIsNoTaskWhereverItStands() {
    GanttLook look = ganttLook();
    look.lanes[0].frames = {ganttFrame(10.2, {{"ball", 0.06}, {"", 0.1}, {"pose", 0.04}})};
    QCOMPARE(ganttBar(look, {0, 0, 2}).left(), 360.0);
    QVERIFY2(ganttText(look, {0, 0, 2}).contains(QStringLiteral("begins at 0.2600 s")),
             qPrintable(ganttText(look, {0, 0, 2})));
    const QPointF below(350, ganttBar(look, {0, 0, 0}).center().y());
    QCOMPARE(ganttHit(look, below)->task, 0);
    QCOMPARE(ganttHit(look, {370, below.y()})->task, 2);
  }

  void whatIsUnderThePointerIsTheTaskOrTheFrame() {
    const GanttLook look = ganttLook();
    const double frame = ganttBar(look, {0, 0, -1}).center().y(),
                 task = ganttBar(look, {0, 0, 0}).center().y();
    QCOMPARE(ganttHit(look, {350, frame}), std::optional(GanttHit{0, 0, -1}));
    QCOMPARE(ganttHit(look, {350, task}), std::optional(GanttHit{0, 0, 0}));
    QCOMPARE(ganttHit(look, {390, task}), std::optional(GanttHit{0, 0, 1}));
    QCOMPARE(ganttHit(look, {401.5, task}), std::optional(GanttHit{0, 0, -1}));  // near it
    QVERIFY(!ganttHit(look, {403, task}));
    QVERIFY(!ganttHit(look, {297, frame}));
    QVERIFY(!ganttHit(look, {350, 5}));    // the ruler
    QVERIFY(!ganttHit(look, {350, 200}));  // below the lane
  }

  void namesHideWhatReachesBelowThem() {
    GanttLook look = ganttLook();
    look.lanes[0].frames = {ganttFrame(9.95, {{"ball", 0.1}})};
    const double y = ganttBar(look, {0, 0, -1}).center().y();
    QVERIFY(ganttHit(look, {120, y}));
    QVERIFY(!ganttHit(look, {80, y}));
  }

  void ofFramesThatOverlapTheLastOneIsMeant() {
    GanttLook look = ganttLook();
    look.lanes[0].frames.push_back(ganttFrame(10.25, {{"ball", 0.1}}));
    const double y = ganttBar(look, {0, 0, -1}).center().y();
    QCOMPARE(ganttHit(look, {340, y})->frame, std::size_t{0});
    QCOMPARE(ganttHit(look, {380, y})->frame, std::size_t{1});
  }

  void aFrameSaysHowMuchOfItsPeriodItTakes() {
    GanttLook look = ganttLook();
    QCOMPARE(ganttText(look, {0, 0, -1}),
             QStringLiteral("cognition, frame 7\nbegins at 0.2000 s\ntakes 100.0 ms"));
    look.lanes[0].frames[0].period = 0.08;
    QCOMPARE(ganttText(look, {0, 0, -1}),
             QStringLiteral("cognition, frame 7\nbegins at 0.2000 s\n"
                            "takes 100.0 ms, 125.0 % of the period of 80.000 ms\n"
                            "The frame overruns by 20.000 ms."));
    QCOMPARE(ganttText(look, {0, 0, 1}).section(QLatin1Char('\n'), 0, 2),
             QStringLiteral("pose (usual)\nbegins at 0.2600 s\ntakes 40.000 ms, 50.0 % of the period of "
                            "80.000 ms"));
  }

  void theGutterFitsTheLongestNameButTakesAThirdAtMost() {
    GanttLook look = ganttLook();
    const QFontMetricsF font{QFont()};
    const int usual = ganttGutter(look, font);
    const QString name = QStringLiteral("a process with quite a long name");
    look.lanes.push_back({name.toStdString(), {}, 0, 0});
    QVERIFY(ganttGutter(look, font) > usual);
    QVERIFY(ganttGutter(look, font) >= static_cast<int>(font.horizontalAdvance(name)));
    look.size.setWidth(150);
    QVERIFY(ganttGutter(look, font) <= 50 + 12);
  }

  void tasksHaveTheirColorsAndOverrunsAreRed() {
    const QPalette palette(Qt::white);
    GanttLook look = ganttLook();
    const QColor base = palette.color(QPalette::Base);
    const QColor bad = mixed(base, colorOf(Meaning::kBad, palette), 0.75);
    const QImage fine = ganttPicture(look, palette);
    QVERIFY(countNear(fine, mixed(base, curveColor(0, palette), 0.6)) > 500);
    QVERIFY(countNear(fine, mixed(base, curveColor(1, palette), 0.6)) > 300);
    QCOMPARE(countNear(fine, bad), 0);
    look.lanes[0].frames[0].period = 0.08;
    const QImage late = ganttPicture(look, palette);
    QVERIFY(countNear(late, bad) > 50);
    keepPicture(late, "gantt");
  }

  void whereManyFramesShareAPixelThoseThatOverrunAreSeen() {
    const QPalette palette(Qt::white);
    GanttLook look = ganttLook();
    auto& frames = look.lanes[0].frames;
    frames.clear();
    for (int i = 0; i < 1000; ++i)
      frames.push_back(ganttFrame(10.2 + 1e-6 * i, {{"ball", 1e-7}}, i == 500 ? 1e-8 : 1));
    const QColor bad = mixed(palette.color(QPalette::Base), colorOf(Meaning::kBad, palette), 0.75);
    QVERIFY(countNear(ganttPicture(look, palette), bad) > 3);
    frames[500].period = 1;
    QCOMPARE(countNear(ganttPicture(look, palette), bad), 0);
  }

  void theShownInstantIsALineUnlessItIsOutside() {
    const QPalette palette(Qt::white);
    GanttLook look = ganttLook();
    const QColor line = palette.color(QPalette::Highlight);
    QCOMPARE(QColor(ganttPicture(look, palette).pixel(600, 150)), line);
    look.shown = ganttTime(9.95);
    QCOMPARE(countNear(ganttPicture(look, palette), line, 1), 0);
    look.shown = ganttTime(30);
    QCOMPARE(countNear(ganttPicture(look, palette), line, 1), 0);
  }

  void aChartWithoutProcessesIsEmpty() {
    const QPalette palette(Qt::white);
    GanttLook look = ganttLook();
    look.lanes.clear();
    QCOMPARE(countNear(ganttPicture(look, palette), palette.color(QPalette::Base), 0), 1100 * 220);
    QVERIFY(!ganttHit(look, {350, 40}));
  }
};

const GuiTest<GanttPaintTest> kGanttPaintTest;

}  // namespace widgets::test

#include "GanttPaintTest.moc"
