// SPDX-License-Identifier: GPL-3.0-or-later
// Looking back at live robots in the timeline, and the shares of their streams.
#include <QAction>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSpinBox>
#include <QTableView>
#include <QToolButton>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/commands/CommandCatalog.h"
#include "tests/widgets/Bench.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/streams/StreamsView.h"
#include "widgets/timeline/HistoryLimits.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets::test {

using robotlink::Instant;

class TimeLineHistoryTest : public QObject {
  Q_OBJECT
 private:
  /// A robot that has sent something every 0.1 s up to now.
  struct Live {
    Live() {
      for (auto& command : robotlink::commandCatalog()) bench.commands.add(std::move(command));
      attach("timeline.pause", [this](const auto&) { bench.session.history().pause(); });
      attach("timeline.live", [this](const auto&) { bench.session.history().goLive(); });
      attach("timeline.step", [this](const auto& values) {
        const auto done =
            bench.session.history().stepFrames("red1", static_cast<int>(std::get<double>(values[0])));
        if (!done) qFatal("it cannot be stepped");
      });
      attach("timeline.seek", [this](const auto& values) {
        bench.session.history().show(Instant(robotlink::fromSeconds(std::get<double>(values[0]))));
      });
      attach("timeline.memory", [this](const auto& values) { memory = std::get<double>(values[0]); });
      attach("timeline.disk", [](const auto&) {});
      runTo(20);
    }
    template <typename F>
    void attach(const char* name, F run) {
      bench.commands.attach(name, [run](const auto& values) -> robotlink::Result<void> {
        run(values);
        return {};
      });
    }
    void runTo(double end) {
      for (; frame < end * 10; ++frame) {
        robotcontrol::FrameInfo info;
        info.set_number(static_cast<std::uint64_t>(frame));
        bench.push("red1/frames/cognition", info, 0.1 * frame);
      }
      bench.session.tick();
    }
    double shown() { return robotlink::seconds(bench.session.timeline().shown().time_since_epoch()); }

    Bench bench;
    int frame = 1;
    double memory = 0;
  };

  static QPoint spot(TimeLineView& view, double seconds) {
    auto& canvas = child<TimeLineCanvas>(view, "timeLineCanvas");
    const Instant time{robotlink::fromSeconds(seconds)};
    return {static_cast<int>(std::lround(canvas.look().scale.x(time))), canvas.viewport()->height() / 2};
  }

 private Q_SLOTS:
  void changesOfAValueAreSteppedByButtonsAndKeys() {
    Live live;
    std::vector<std::pair<std::string, std::string>> steps;
    live.attach("timeline.step-change", [&](const auto& values) {
      steps.emplace_back(std::get<std::string>(values[0]), std::get<std::string>(values[1]));
    });
    auto view = live.bench.open<TimeLineView>({1000, 300});
    auto& field = child<QComboBox>(*view, "timeLineStepBy");  // which has the focus, as in the window
    QTest::keyClicks(&field, QStringLiteral("frames/cognition.number > 7"));
    QTest::keyClick(&field, Qt::Key_Return);
    click(child<QToolButton>(*view, "timeLineChangeBack"));
    QTest::keyClick(&child<QWidget>(*view, "timeLineCanvas"), Qt::Key_Period, Qt::ControlModifier);
    const std::string value = "frames/cognition.number > 7";
    const std::vector<std::pair<std::string, std::string>> expected{
        {value, "next"}, {value, "previous"}, {value, "next"}};
    QCOMPARE(steps, expected);
    auto again = live.bench.open<TimeLineView>({1000, 300});
    again->restoreState(view->saveState());
    QCOMPARE(child<QLineEdit>(*again, "timeLineStepByText").text(), QString::fromStdString(value));
  }

  void draggingShowsAnEarlierInstantWhileTheRobotContinues() {
    Live live;
    auto view = live.bench.open<TimeLineView>({900, 240});
    QWidget& canvas = *child<TimeLineCanvas>(*view, "timeLineCanvas").viewport();
    drag(canvas, Qt::LeftButton, spot(*view, 15), spot(*view, 10));
    live.runTo(25);
    live.bench.tick(*view);
    QVERIFY(std::abs(live.shown() - 10) < 0.1);
    QVERIFY(!live.bench.session.timeline().live());
    QVERIFY(child<QAction>(*view, "historyPauseAction").isChecked());
    QTest::mouseClick(&child<QToolButton>(*view, "historyLive"), Qt::LeftButton);
    live.bench.tick(*view);
    QVERIFY(live.bench.session.timeline().live());
    QVERIFY(!child<QAction>(*view, "historyPauseAction").isChecked());
  }

  void keysPauseStepAndReturn() {
    Live live;
    auto view = live.bench.open<TimeLineView>({900, 240});
    auto& canvas = child<TimeLineCanvas>(*view, "timeLineCanvas");
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Space);
    QVERIFY(!live.bench.session.timeline().live());
    QTest::keyClick(&canvas, Qt::Key_Left);
    QVERIFY(std::abs(live.shown() - 19.8) < 0.01);
    QTest::keyClick(&canvas, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(std::abs(live.shown() - 18.8) < 0.01);
    QTest::keyClick(&canvas, Qt::Key_Right);
    QVERIFY(std::abs(live.shown() - 18.9) < 0.01);
    QTest::keyClick(&canvas, Qt::Key_Left, Qt::ControlModifier);
    QVERIFY(std::abs(live.shown() - 17.9) < 0.01);
    QTest::keyClick(&canvas, Qt::Key_Home);
    QVERIFY(std::abs(live.shown() - 0.1) < 0.01);
    QTest::keyClick(&canvas, Qt::Key_End);
    QVERIFY(live.bench.session.timeline().live());
  }

  void aRangeIsSelectedForExports() {
    Live live;
    auto view = live.bench.open<TimeLineView>({1000, 240});
    auto& canvas = child<TimeLineCanvas>(*view, "timeLineCanvas");
    auto& clear = child<QAction>(*view, "rangeClearAction");
    QVERIFY(!clear.isEnabled());
    drag(*canvas.viewport(), Qt::LeftButton, spot(*view, 5), spot(*view, 15), {}, Qt::ShiftModifier);
    live.bench.tick(*view);
    QVERIFY(live.bench.session.timeline().live());
    QVERIFY(canvas.look().range.has_value());
    QVERIFY(std::abs(robotlink::seconds(canvas.look().range->first.time_since_epoch()) - 5) < 0.1);
    QVERIFY(child<QLabel>(*view, "rangeText").text().contains(QStringLiteral("s (10.0")) ||
            child<QLabel>(*view, "rangeText").text().contains(QStringLiteral("s (9.9")));
    QVERIFY(clear.isEnabled() && child<QAction>(*view, "rangeExportAction").isEnabled());
    QVERIFY(!child<QAction>(*view, "rangeCutAction").isEnabled());
    QVERIFY(!child<QAction>(*view, "exportImages").isEnabled());
    QVERIFY(child<QAction>(*view, "exportView").isEnabled());
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Escape);
    live.bench.tick(*view);
    QVERIFY(!canvas.look().range.has_value());
    live.bench.session.history().show(Instant(std::chrono::seconds(12)));
    QTest::keyClick(&canvas, Qt::Key_I);
    live.bench.session.history().show(Instant(std::chrono::seconds(14)));
    QTest::keyClick(&canvas, Qt::Key_O);
    live.bench.tick(*view);
    QCOMPARE(canvas.look().range->first, Instant(std::chrono::seconds(12)));
    QCOMPARE(canvas.look().range->second, Instant(std::chrono::seconds(14)));
  }

  void whatWasDroppedIsHatched() {
    Live live;
    auto view = live.bench.open<TimeLineView>({900, 240});
    auto& canvas = child<TimeLineCanvas>(*view, "timeLineCanvas");
    const auto colorAt = [&](double seconds) {
      const auto lane = canvas.layout().lanes.front().rect.toRect();
      return canvas.viewport()->grab().toImage().pixelColor(spot(*view, seconds).x(), lane.center().y());
    };
    QCOMPARE(colorAt(3.3), colorAt(16.6));
    live.bench.session.store().setBytes(live.bench.session.store().bytes() / 2);
    live.bench.tick(*view);
    QVERIFY(colorAt(3.3) != colorAt(16.6));
    // It is the same from the beginning of the session on.
    QVERIFY(canvas.look().begin < Instant(robotlink::fromSeconds(0.2)));
    keepPicture(*view, "time-line-history");
  }

  void howMuchIsKeptIsAskedByTheContextMenu() {
    Live live;
    auto view = live.bench.open<TimeLineView>({900, 240});
    auto& canvas = child<TimeLineCanvas>(*view, "timeLineCanvas");
    QContextMenuEvent event(QContextMenuEvent::Mouse, {300, 60},
                            canvas.viewport()->mapToGlobal(QPoint(300, 60)));
    QApplication::sendEvent(canvas.viewport(), &event);
    auto& menu = child<QMenu>(*view, "timeLineMenu");
    child<QAction>(menu, "historyLimits").trigger();
    menu.close();
    auto& dialog = child<HistoryLimits>(*view, "historyLimitsDialog");
    QCOMPARE(dialog.memoryMib(), 1024);
    QVERIFY(child<QLabel>(dialog, "historyUsed").text().contains(QStringLiteral("19.8 s back")));
    child<QSpinBox>(dialog, "historyMemory").setValue(2048);
    dialog.accept();
    QCOMPARE(live.memory, 2048.0);
  }

  void theStreamsHaveTheirShares() {
    Live live;
    live.bench.push("red1/large", [] {
      auto value = std::make_shared<robotcontrol::PlotValue>();
      value->set_unit(std::string(1'000'000, 'm'));
      return value;
    }());
    live.bench.session.tick();
    auto view = live.bench.open<StreamsView>({900, 240});
    auto& table = child<QTableView>(*view, "streamsTable");
    QCOMPARE(table.model()->rowCount(), 2);
    const QModelIndex path = table.model()->index(1, StreamListModel::kPath);
    QCOMPARE(path.data().toString(), QStringLiteral("red1/large"));
    QVERIFY(path.sibling(1, StreamListModel::kBytes).data().toString().contains(QStringLiteral("MB")));
    QVERIFY(!path.data(Qt::CheckStateRole).isValid());
    QVERIFY(!(path.flags() & Qt::ItemIsUserCheckable));
  }
};

const GuiTest<TimeLineHistoryTest> kTimeLineHistoryTest;

}  // namespace widgets::test

#include "TimeLineHistoryTest.moc"
