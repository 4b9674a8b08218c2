// SPDX-License-Identifier: GPL-3.0-or-later
// The time line's picture and what a person does to it.
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QToolTip>

#include "foxglove/Robot.pb.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/LogBench.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {

using robotcontrol::ControlReplay;
using Kind = widgets::TimeLineLayout::Kind;

namespace {

/// Where on the canvas something lies.
class Spots {
 public:
  explicit Spots(TimeLineView& view) : canvas_(child<TimeLineCanvas>(view, "timeLineCanvas")) {}
  TimeLineCanvas& canvas() { return canvas_; }
  QWidget& viewport() { return *canvas_.viewport(); }
  int x(double seconds) const { return static_cast<int>(std::lround(canvas_.look().scale.x(at(seconds)))); }
  QRect lane(Kind kind, const std::string& stream = {}, int band = 0) const {
    for (const auto& lane : canvas_.layout().lanes) {
      if (lane.kind == kind && lane.band == band && (stream.empty() || lane.stream == stream))
        return lane.rect.toRect();
    }
    qFatal("there is no such lane");
  }
  QPoint ruler(double seconds) const { return {x(seconds), 8}; }
  QPoint on(Kind kind, double seconds, const std::string& stream = {}) const {
    return {x(seconds), lane(kind, stream).center().y()};
  }

 private:
  TimeLineCanvas& canvas_;
};

double secondsOf(std::int64_t ns) {
  return robotlink::seconds(robotlink::Duration(ns));
}
bool isAbout(std::int64_t ns, double seconds, double tolerance = 0.1) {
  return std::abs(secondsOf(ns) - seconds) <= tolerance;
}

QString toolTipAt(QWidget& widget, const QPoint& point) {
  QHelpEvent event(QEvent::ToolTip, point, widget.mapToGlobal(point));
  QApplication::sendEvent(&widget, &event);
  return QToolTip::text();
}

}  // namespace

class TimeLineTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void saysHowToOpenALogWhereNoneIsOpen() {
    LogBench bench;
    auto view = bench.openView<TimeLineView>();
    auto& hint = child<QLabel>(*view, "emptyHint");
    QVERIFY(hint.isVisible());
    QVERIFY(hint.text().contains(QStringLiteral("Open log")));
    bench.openLog(kFile);
    bench.tick(*view);
    QVERIFY(!hint.isVisible());
    bench.status.clear_logs();
    bench.publish();
    bench.tick(*view);
    QVERIFY(hint.isVisible());
    QVERIFY(child<TimeLineCanvas>(*view, "timeLineCanvas").bands().empty());
  }

  void dragInTheRulerMovesThePlayHeadAtOnceButOneJumpAtATimeIsOnItsWay() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    QTest::mousePress(&spots.viewport(), Qt::LeftButton, {}, spots.ruler(15));
    QCOMPARE(bench.asked().action(), ControlReplay::JUMP_TO_TIME);
    QVERIFY(isAbout(bench.asked().time(), 15));
    QCOMPARE(bench.requests.size(), std::size_t{1});
    for (double t = 16; t <= 30; ++t) moveMouse(spots.viewport(), spots.ruler(t), Qt::LeftButton);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QVERIFY(isAbout(spots.canvas().look().shown.time_since_epoch().count(), 30));
    bench.answer(true);
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QVERIFY(isAbout(bench.asked().time(), 30));
    QTest::mouseRelease(&spots.viewport(), Qt::LeftButton, {}, spots.ruler(30));
    bench.answer(true);
    bench.showTime(30);
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t{2});
  }

  void aClickOnARowGoesToItsNearestMessageAndDraggingSelects() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    const QPoint near = spots.on(Kind::kStream, 12, "nao/camera/image") + QPoint(2, 0);
    QTest::mouseClick(&spots.viewport(), Qt::LeftButton, {}, near);
    QCOMPARE(bench.asked().action(), ControlReplay::JUMP_TO_TIME);
    QVERIFY(isAbout(bench.asked().time(), 12, 1e-6));
    drag(spots.viewport(), Qt::LeftButton, spots.on(Kind::kStream, 28, "nao/joints/states"),
         spots.on(Kind::kStream, 22, "nao/joints/states"));
    QVERIFY(bench.asked().has_range());
    QVERIFY(isAbout(bench.asked().range().from(), 22));
    QVERIFY(isAbout(bench.asked().range().to(), 28));
    drag(spots.viewport(), Qt::LeftButton, spots.ruler(12), spots.ruler(14), {}, Qt::ShiftModifier);
    QVERIFY(isAbout(bench.asked().range().from(), 12));
    QVERIFY(isAbout(bench.asked().range().to(), 14));
  }

  void theEndsOfARangeAreDraggedAndEscapeDropsIt() {
    LogBench bench;
    bench.openLog(kFile);
    bench.setRange(20, 30);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    QVERIFY(child<QLabel>(*view, "rangeText").text().contains(QStringLiteral("10.000 s")));
    drag(spots.viewport(), Qt::LeftButton, spots.on(Kind::kTexts, 30), spots.on(Kind::kTexts, 35));
    QVERIFY(isAbout(bench.asked().range().from(), 20));
    QVERIFY(isAbout(bench.asked().range().to(), 35));
    QTest::keyClick(&spots.canvas(), Qt::Key_Escape);
    QVERIFY(bench.asked().has_range());
    QCOMPARE(bench.asked().range().from(), bench.asked().range().to());
  }

  void theRangeIsPlayedInALoop() {
    LogBench bench;
    bench.openLog(kFile);
    bench.setRange(20, 30);
    auto view = bench.openView<TimeLineView>();
    click(child<QToolButton>(*view, "rangeLoop"));
    QCOMPARE(bench.requests.size(), std::size_t{3});
    QVERIFY(bench.requests[0].control_replay().loop());
    QVERIFY(isAbout(bench.requests[1].control_replay().time(), 20));
    QCOMPARE(bench.requests[2].control_replay().action(), ControlReplay::PLAY);
    click(child<QToolButton>(*view, "rangeClear"));
    QCOMPARE(bench.asked().range().from(), bench.asked().range().to());
  }

  void keysPlayAsInVideoPlayers() {
    LogBench bench;
    bench.openLog(kFile);
    bench.showTime(20);
    auto view = bench.openView<TimeLineView>();
    auto& canvas = child<TimeLineCanvas>(*view, "timeLineCanvas");
    const auto asked = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
      QTest::keyClick(&canvas, key, modifiers);
      return bench.asked();
    };
    QCOMPARE(asked(Qt::Key_Space).action(), ControlReplay::PLAY);
    bench.status.set_playing(true);
    bench.publish();
    QCOMPARE(asked(Qt::Key_Space).action(), ControlReplay::PAUSE);
    QCOMPARE(asked(Qt::Key_Right).count(), 1);
    QCOMPARE(bench.asked().action(), ControlReplay::STEP_FRAME);
    QCOMPARE(asked(Qt::Key_Left).count(), -1);
    QCOMPARE(asked(Qt::Key_Left, Qt::ShiftModifier).count(), -10);
    QCOMPARE(asked(Qt::Key_Period).action(), ControlReplay::STEP_MESSAGE);
    QCOMPARE(bench.asked().stream(), std::string("nao/camera/image"));
    QCOMPARE(asked(Qt::Key_Comma).count(), -1);
    QVERIFY(isAbout(asked(Qt::Key_I).range().from(), 20));
    QVERIFY(isAbout(bench.asked().range().to(), 40));
    QVERIFY(isAbout(asked(Qt::Key_O).range().to(), 20));
    QVERIFY(isAbout(asked(Qt::Key_End).time(), 40));
    bench.answer(true);
    bench.publish();
    QVERIFY(isAbout(asked(Qt::Key_Home).time(), 10));
  }

  void theWheelZoomsAtTheCursorAndShiftPans() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    const QPoint where = spots.on(Kind::kStream, 25, "nao/log");
    const double before = spots.canvas().look().scale.nsPerPixel;
    turnWheel(spots.viewport(), where, 4);
    QVERIFY(spots.canvas().look().scale.nsPerPixel < before / 2);
    QVERIFY(std::abs(spots.x(25) - where.x()) <= 2);
    const auto from = spots.canvas().look().scale.from;
    drag(spots.viewport(), Qt::MiddleButton, where, where - QPoint(100, 0));
    QVERIFY(spots.canvas().look().scale.from > from);
    QTest::keyClick(&spots.canvas(), Qt::Key_F);
    QVERIFY(std::abs(spots.canvas().look().scale.nsPerPixel - before) < 1);
  }

  void thePlayHeadIsFollowedUnlessItIsNotWanted() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    turnWheel(spots.viewport(), spots.on(Kind::kStream, 12, "nao/log"), 8);
    bench.showTime(35);
    bench.tick(*view);
    QVERIFY(spots.x(35) > spots.canvas().look().gutter && spots.x(35) < spots.viewport().width());
    click(child<QToolButton>(*view, "timeLineFollow"));
    bench.showTime(11);
    bench.tick(*view);
    QVERIFY(spots.x(11) < spots.canvas().look().gutter);
  }

  void wantsTheImagesThatAreSeenAndShowsThem() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    auto& reading = *bench.readings.at(kFile);
    QCOMPARE(reading.wanted.stream, std::string("nao/camera/image"));
    QVERIFY(reading.wanted.times.size() >= 7);
    QImage green(80, 60, QImage::Format_RGB32);
    green.fill(QColor(20, 200, 30));
    for (const auto time : reading.wanted.times) reading.thumbnails.push_back({time, green});
    bench.tick(*view);
    QVERIFY(reading.wanted.times.empty());
    const QRect strip =
        spots.lane(Kind::kImages).adjusted(spots.x(10), 0, spots.x(40) - spots.viewport().width(), 0);
    QVERIFY(countNear(spots.viewport().grab(strip).toImage(), QColor(20, 200, 30)) >
            strip.width() * strip.height() * 8 / 10);
  }

  void imagesOfAnotherStreamAreNotMixedIn() {
    LogBench bench;
    bench.openLog(kFile);
    auto& log = *bench.logs().logs().front();
    auto& reading = *bench.readings.at(kFile);
    bench.logs().wantThumbnails(log, {at(20)}, 60);
    bench.logs().setImageStream(log, "nao/lower/image");
    QCOMPARE(reading.wanted.stream, std::string("nao/lower/image"));
    reading.thumbnails.push_back({at(20), QImage(80, 60, QImage::Format_RGB32)});
    bench.logs().setImageStream(log, "nao/camera/image");
    bench.logs().tick();
    QVERIFY(log.thumbnails.empty());
  }

  void toolTipsShowWhatWasLogged() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    QVERIFY(toolTipAt(spots.viewport(), spots.on(Kind::kTexts, 18))
                .contains(QStringLiteral("the ball was lost")));
    QVERIFY(toolTipAt(spots.viewport(), spots.on(Kind::kTexts, 31))
                .contains(QStringLiteral("a servo does not answer")));
    QVERIFY(toolTipAt(spots.viewport(), spots.on(Kind::kStream, 31, "nao/joints/states"))
                .contains(QStringLiteral("foxglove.JointStates")));
  }

  void aDoubleClickOnAStreamLetsItBeStepped() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    const QPoint name(40, spots.lane(Kind::kStream, "nao/joints/states").center().y());
    QTest::mouseDClick(&spots.viewport(), Qt::LeftButton, {}, name);
    QCOMPARE(bench.logs().replay().steppedStream(), std::string("nao/joints/states"));
    QTest::keyClick(&spots.canvas(), Qt::Key_Period);
    QCOMPARE(bench.asked().stream(), std::string("nao/joints/states"));
  }

  void streamsOfASecondRobotOfThatNameAreSteppedByTheNameItHasHere() {
    LogBench bench;
    bench.openLog(kFile);
    bench.status.mutable_logs(0)->add_robots("nao");
    bench.openLog("/logs/other.mcap");
    bench.status.mutable_logs(1)->add_robots("nao-2");
    bench.publish();
    auto view = bench.openView<TimeLineView>({1000, 600});
    Spots spots(*view);
    const QPoint name(40, spots.lane(Kind::kStream, "nao/joints/states", 1).center().y());
    QTest::mouseClick(&spots.viewport(), Qt::LeftButton, {}, name);
    QCOMPARE(bench.logs().replay().steppedStream(), std::string("nao-2/joints/states"));
    bench.tick(*view);
    QCOMPARE(spots.canvas().look().stream, std::pair(1, std::string("nao/joints/states")));
  }

  void theMenuOfARowHidesItsStream() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    const QPoint where = spots.on(Kind::kStream, 20, "nao/joints/states");
    QContextMenuEvent event(QContextMenuEvent::Mouse, where, spots.viewport().mapToGlobal(where));
    QApplication::sendEvent(&spots.viewport(), &event);
    auto& menu = child<QMenu>(*view, "timeLineMenu");
    for (QAction* action : menu.actions()) {
      if (action->text() == QStringLiteral("Hide nao/joints/states")) action->trigger();
    }
    menu.close();
    bench.tick(*view);
    QVERIFY(bench.logs().logs()[0]->hidden.contains("nao/joints/states"));
    QCOMPARE(spots.canvas().bands()[0].streams.size(), std::size_t{3});
  }

  void aBandIsCollapsedByItsTriangle() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    const auto lanes = spots.canvas().layout().lanes.size();
    QTest::mouseClick(&spots.viewport(), Qt::LeftButton, {},
                      QPoint(10, spots.lane(Kind::kHeader).center().y()));
    QCOMPARE(spots.canvas().layout().lanes.size(), lanes - 4);
  }

  void twoLogsAreAlignedByAnEventThatIsInBoth() {
    LogBench bench;
    bench.openLog(kFile);
    bench.openLog("/logs/other.mcap", 5);
    auto view = bench.openView<TimeLineView>({1000, 600});
    Spots spots(*view);
    const auto choose = [&](int band, double seconds, const char* action) {
      const QPoint where(spots.x(seconds), spots.lane(Kind::kHeader, {}, band).center().y());
      QContextMenuEvent event(QContextMenuEvent::Mouse, where, spots.viewport().mapToGlobal(where));
      QApplication::sendEvent(&spots.viewport(), &event);
      auto& menu = *view->findChildren<QMenu*>(QStringLiteral("timeLineMenu")).back();
      auto* entry = menu.findChild<QAction*>(QLatin1String(action));
      if (entry != nullptr) entry->trigger();
      menu.close();
      return entry != nullptr;
    };
    QVERIFY(!choose(1, 25, "alignEvent"));
    QVERIFY(choose(0, 20, "markEvent"));
    QVERIFY(!choose(0, 20, "alignEvent"));
    QVERIFY(choose(1, 28, "alignEvent"));
    QCOMPARE(bench.asked().offsets(0).log(), std::string("/logs/other.mcap"));
    QVERIFY(isAbout(bench.asked().offsets(0).offset(), 5 - 8, 0.1));
  }

  void severalLogsHaveABandEachWhoseOffsetIsDraggedOrTyped() {
    LogBench bench;
    bench.openLog(kFile);
    bench.openLog("/logs/other.mcap", 5);
    auto view = bench.openView<TimeLineView>({1000, 600});
    Spots spots(*view);
    QCOMPARE(spots.canvas().bands().size(), std::size_t{2});
    const QRect offset =
        widgets::offsetRect(spots.lane(Kind::kHeader, {}, 1), spots.canvas().look()).toRect();
    const double secondsPerPixel = spots.canvas().look().scale.nsPerPixel * 1e-9;
    drag(spots.viewport(), Qt::LeftButton, offset.center(), offset.center() + QPoint(20, 0));
    QCOMPARE(bench.asked().offsets_size(), 1);
    QCOMPARE(bench.asked().offsets(0).log(), std::string("/logs/other.mcap"));
    QVERIFY(isAbout(bench.asked().offsets(0).offset(), 5 + 20 * secondsPerPixel, 0.001));
    QTest::mouseDClick(&spots.viewport(), Qt::LeftButton, {}, offset.center());
    auto& edit = child<QLineEdit>(*view, "offsetEdit");
    edit.selectAll();
    QTest::keyClicks(&edit, QStringLiteral("-2.5"));
    QTest::keyClick(&edit, Qt::Key_Return);
    QVERIFY(isAbout(bench.asked().offsets(0).offset(), -2.5, 1e-9));
  }

  void rowsScrollWhereThereAreMoreThanFit() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>({1000, 190});
    Spots spots(*view);
    const int before = spots.lane(Kind::kStream, "nao/log").top();
    turnWheel(spots.viewport(), QPoint(50, 100), -3);
    QVERIFY(spots.lane(Kind::kStream, "nao/log").top() < before);
    QVERIFY(spots.canvas().verticalScrollBar()->value() > 0);
  }

  void aDamagedLogSaysWhatWasLost() {
    LogBench bench;
    bench.shapeOverview = [](widgets::LogOverview& overview) {
      overview.damage = QStringLiteral("12 messages could not be read");
    };
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    QVERIFY(child<QWidget>(*view, "logDamageBar").isVisible());
    QVERIFY(child<QLabel>(*view, "logDamageText").text().contains(QStringLiteral("12 messages")));
    QVERIFY(child<QToolButton>(*view, "logRepair").isVisible());
    click(child<QToolButton>(*view, "logDamageDismiss"));
    bench.tick(*view);
    QVERIFY(!child<QWidget>(*view, "logDamageBar").isVisible());
  }

  void showsTheFocus() {
    LogBench bench;
    bench.openLog(kFile);
    auto view = bench.openView<TimeLineView>();
    Spots spots(*view);
    spots.canvas().setFocus();
    const QColor focused = spots.viewport().grab().toImage().pixelColor(1, 200);
    child<QToolButton>(*view, "timeLineFit").setFocus();
    QVERIFY(spots.viewport().grab().toImage().pixelColor(1, 200) != focused);
  }

  void looksWellInLightAndDark() {
    LogBench bench;
    bench.openLog(kFile);
    bench.openLog("/logs/other.mcap", 3.25);
    bench.setRange(22, 27);
    bench.showTime(24);
    auto view = bench.openView<TimeLineView>({1200, 420});
    keepPicture(*view, "time-line");
  }

  void gapsOfRobotsElsewhereAreShownWithoutALog() {
    Bench bench;
    auto view = bench.open<TimeLineView>({900, 260});
    for (double time = 1; time <= 20; time += 0.5)
      if (time < 8 || time > 12) bench.push("red1/log", foxglove::Log(), time);
    bench.session.setRemoteRobots(
        {{"red1",
          {"ws://10.0.0.1:8765", true, "connected", {{at(8), at(12), "nothing is heard of the robot"}}}}});
    bench.tick(*view);
    bench.tick(*view);
    Spots spots(*view);
    const QRect lane = spots.lane(Kind::kHeader);
    const QImage picture = spots.viewport().grab().toImage();
    const auto colorAt = [&](double seconds) {
      return picture.pixelColor(spots.x(seconds), lane.bottom() - 2);
    };
    QCOMPARE(colorAt(10), colorAt(9));
    QVERIFY(colorAt(10) != colorAt(5));
    QCOMPARE(colorAt(5), colorAt(15));
    const QString tip = toolTipAt(spots.viewport(), {spots.x(10), lane.center().y()});
    QVERIFY2(tip.contains(QStringLiteral("nothing is heard of the robot")), qPrintable(tip));
    QVERIFY(toolTipAt(spots.viewport(), {spots.x(5), lane.center().y()})
                .contains(QStringLiteral("show it in all")));
    // There is no log whose play head could be moved, but the history of the robot.
    QTest::mouseClick(&spots.viewport(), Qt::LeftButton, {}, {spots.x(5), lane.center().y()});
    bench.tick(*view);
    QVERIFY(bench.requests.empty());
    QVERIFY(std::abs(robotlink::seconds(bench.session.timeline().shown() - at(5))) < 0.1);
    keepPicture(*view, "time-line-gaps");
    // One that lasts reaches up to now.
    bench.session.setRemoteRobots(
        {{"red1", {"ws://10.0.0.1:8765", false, "silent", {{at(15), {}, "silent"}}}}});
    bench.tick(*view);
    QVERIFY(toolTipAt(spots.viewport(), {spots.x(19), lane.center().y()}).contains(QStringLiteral("silent")));
  }
};

const GuiTest<TimeLineTest> kTimeLineTest;

}  // namespace widgets::test

#include "TimeLineTest.moc"
