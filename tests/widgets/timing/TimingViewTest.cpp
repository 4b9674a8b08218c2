// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/TimingView.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QTabBar>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>
#include <QToolTip>

#include "robotlink/packages/Conversions.h"
#include "tests/widgets/Bench.h"
#include "widgets/Theme.h"
#include "widgets/timing/GanttCanvas.h"

namespace widgets::test {

using robotcontrol::KeyMode;

namespace {

robotcontrol::StopwatchTimes times(double ball, double pose) {
  robotcontrol::StopwatchTimes result;
  auto add = [&](const char* task, const char* solution, double seconds) {
    auto& entry = *result.add_entries();
    entry.set_task(task);
    entry.set_solution(solution);
    entry.set_seconds(seconds);
  };
  add("ball-percept", "scan-lines", ball);
  add("pose", "particles", pose);
  add("", "", ball + pose);
  return result;
}

QString shownCell(const QTableView& table, const QString& task, int column) {
  for (int row = 0; row < table.model()->rowCount(); ++row) {
    if (table.model()->index(row, widgets::TimingModel::kTask).data().toString() == task) {
      return table.model()->index(row, column).data().toString();
    }
  }
  return {};
}

/// A robot that runs at 25 Hz and takes 4 ms for a frame, but 60 ms for the eleventh.
struct Running : Bench {
  std::unique_ptr<widgets::TimingView> view = open<widgets::TimingView>({900, 700});
  GanttCanvas& chart = child<GanttCanvas>(*view, "timingChart");

  explicit Running(int frames = 20) {
    for (int i = 0; i < frames; ++i) frame(i);
    tick(*view);
  }
  void frame(int i) {
    robotcontrol::StopwatchTimes measured = times(0.001, i == 10 ? 0.059 : 0.003);
    auto value = std::make_shared<const robotcontrol::StopwatchTimes>(measured);
    session.push(
        {"red1/stopwatches/cognition", at(i), value, "cognition", static_cast<std::uint64_t>(i + 1)});
  }
  static robotlink::Instant at(int i) { return robotlink::Instant(robotlink::fromSeconds(1 + 0.04 * i)); }
  /// Where the bar of a frame is.
  QPoint bar(std::size_t frame, int task = -1) const {
    return ganttBar(chart.look(), {0, frame, task}).center().toPoint();
  }
  /// The index of a frame among those that are shown.
  std::size_t shownFrame(int i) const {
    const auto& frames = chart.look().lanes.at(0).frames;
    for (std::size_t k = 0; k < frames.size(); ++k)
      if (frames[k].time == at(i)) return k;
    qFatal("frame %d is not shown", i);
  }
};

/// A bench with the view, whose model is watched.
struct Watched : Bench {
  std::unique_ptr<widgets::TimingView> view = open<widgets::TimingView>();
  QTableView& table = child<QTableView>(*view, "timingTable");
  QAbstractItemModelTester tester{table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal};
};

}  // namespace

class TimingViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void showsMinimumMeanMaximumRateAndShare() {
    Watched bench;
    const auto& table = bench.table;
    bench.push("red1/stopwatches/cognition", times(0.001, 0.003), 1.0);
    bench.push("red1/stopwatches/cognition", times(0.003, 0.005), 1.04);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 3);
    using Model = widgets::TimingModel;
    const QString ball = QStringLiteral("ball-percept");
    QCOMPARE(shownCell(table, ball, Model::kProcess), QStringLiteral("cognition"));
    QCOMPARE(shownCell(table, ball, Model::kSolution), QStringLiteral("scan-lines"));
    QCOMPARE(shownCell(table, ball, Model::kLast), QStringLiteral("3.000"));
    QCOMPARE(shownCell(table, ball, Model::kMean), QStringLiteral("2.000"));
    QCOMPARE(shownCell(table, ball, Model::kMinimum), QStringLiteral("1.000"));
    QCOMPARE(shownCell(table, ball, Model::kMax), QStringLiteral("3.000"));
    QCOMPARE(shownCell(table, ball, Model::kRate), QStringLiteral("25.0"));
    QCOMPARE(shownCell(table, ball, Model::kShare), QStringLiteral("5.00 %"));
    QCOMPARE(shownCell(table, QStringLiteral("frame"), Model::kMean), QStringLiteral("6.000"));
  }

  void theRateIsThatOfTheLastSecondsThoughTimesWereNotPublishedOrTheClockWentBack() {
    using Model = widgets::TimingModel;
    Model model;
    const auto at = [](double time) { return robotlink::Instant(robotlink::fromSeconds(time)); };
    const auto rate = [&] {
      model.update();
      return model.index(0, Model::kRate).data().toString();
    };
    // 10 Hz at first; then nobody measures for ten seconds; then 25 Hz, of which every second frame is told.
    for (std::uint64_t i = 1; i <= 10; ++i)
      model.add("cognition", i, at(0.1 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("10.0"));
    for (std::uint64_t i = 0; i < 100; i += 2)
      model.add("cognition", 110 + i, at(11 + 0.04 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("25.0"));
    // The simulation is reset.
    for (std::uint64_t i = 1; i <= 5; ++i)
      model.add("cognition", i, at(0.04 * double(i)), times(0.001, 0.002));
    QCOMPARE(rate(), QStringLiteral("25.0"));
  }

  void aSolutionThatDoesNotRunAnyMoreHasNoRateAndNoShare() {
    using Model = widgets::TimingModel;
    Model model;
    const auto at = [](double time) { return robotlink::Instant(robotlink::fromSeconds(time)); };
    model.add("cognition", 1, at(1), times(0.001, 0.002));
    model.add("cognition", 2, at(1.04), times(0.001, 0.002));
    robotcontrol::StopwatchTimes other = times(0.001, 0.002);
    other.mutable_entries(0)->set_solution("oracle");
    model.add("cognition", 3, at(1.08), other);
    model.update();
    QCOMPARE(model.index(0, Model::kSolution).data().toString(), QStringLiteral("scan-lines"));
    QCOMPARE(model.index(0, Model::kRate).data().toString(), QString());
    QCOMPARE(model.index(0, Model::kShare).data().toString(), QString());
    QCOMPARE(model.index(1, Model::kRate).data().toString(), QStringLiteral("25.0"));
  }

  void whatAnotherLayoutDoesNotHaveIsNotListedAnyMore() {
    Watched bench;
    const auto& table = bench.table;
    bench.push("red1/stopwatches/cognition", times(0.001, 0.002), 1);
    bench.push("red1/stopwatches/sensing", times(0.001, 0.002), 1);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 6);
    robotcontrol::ProcessTable program;
    auto& process = *program.add_processes();
    process.set_name("cognition");
    process.add_tasks("pose");
    bench.push("red1/tables/processes", program, 2);
    bench.tick(*bench.view);
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(shownCell(table, QStringLiteral("pose"), widgets::TimingModel::kProcess),
             QStringLiteral("cognition"));
    QCOMPARE(shownCell(table, QStringLiteral("frame"), widgets::TimingModel::kProcess),
             QStringLiteral("cognition"));
  }

  void asksForTimesAndStopsAskingOnWish() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("timing/tasks"));
    QCOMPARE(bench.requests[0].set_key().mode().kind(), KeyMode::ALWAYS);
    click(child<QToolButton>(*view, "timingMeasure"));
    QCOMPARE(bench.requests.back().set_key().mode().kind(), KeyMode::OFF);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "emptyHint").text().contains(QStringLiteral("does not measure")));
  }

  void resetBeginsAnewAndTheTableIsCopied() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    bench.push("red1/stopwatches/cognition", times(0.5, 0.5), 1.0);
    bench.tick(*view);
    click(child<QToolButton>(*view, "timingReset"));
    bench.push("red1/stopwatches/cognition", times(0.001, 0.003), 1.04);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "timingTable");
    QCOMPARE(shownCell(table, QStringLiteral("pose"), widgets::TimingModel::kMax), QStringLiteral("3.000"));
    click(child<QToolButton>(*view, "timingCopy"));
    QVERIFY(QApplication::clipboard()->text().contains(
        QStringLiteral("cognition,pose,particles,3,3,3,3,3,3,3,0,0,0")));
  }

  void theChartShowsFramesWithTheirTasksAndFollowsTheTimeline() {
    Running bench;
    const auto& look = bench.chart.look();
    QCOMPARE(look.lanes.size(), std::size_t{1});
    QCOMPARE(look.lanes[0].frames.size(), std::size_t{20});
    QCOMPARE(look.shown, Running::at(19));
    // The last frame is near the right edge, and moves away from it.
    const double before = ganttBar(look, {0, bench.shownFrame(19), -1}).left();
    QVERIFY(before > bench.chart.width() * 0.9);
    bench.frame(20);
    bench.tick(*bench.view);
    QVERIFY(ganttBar(look, {0, bench.shownFrame(19), -1}).left() < before);
    // A paused timeline holds the chart.
    bench.session.history().pause();
    bench.frame(21);
    bench.tick(*bench.view);
    QCOMPARE(look.shown, Running::at(20));
    keepPicture(*bench.view, "timing");
  }

  void aToolTipNamesTheTaskWhenItBeganAndHowLongItTook() {
    Running bench;
    bench.chart.setSpan(0.2);
    bench.tick(*bench.view);
    const std::size_t frame = bench.shownFrame(18);
    moveMouse(bench.chart, bench.bar(frame, 1));
    QVERIFY(QToolTip::text().contains(QStringLiteral("pose (particles)")));
    QVERIFY(QToolTip::text().contains(QStringLiteral("begins at 1.7210 s")));
    QVERIFY(QToolTip::text().contains(QStringLiteral("takes 3.000 ms, 7.5 % of the period of 40.000 ms")));
    moveMouse(bench.chart, bench.bar(frame));
    QVERIFY(QToolTip::text().contains(QStringLiteral("cognition, frame 19")));
    QToolTip::hideText();
  }

  void aFrameThatOverrunsIsHighlightedAndCounted() {
    Running bench;
    const auto& look = bench.chart.look();
    QCOMPARE(look.lanes[0].overruns, std::size_t{1});
    const std::size_t late = bench.shownFrame(10);
    QVERIFY(look.lanes[0].frames[late].overruns());
    QVERIFY(ganttText(look, {0, late, -1}).contains(QStringLiteral("overruns by 20.000 ms")));
    QCOMPARE(shownCell(child<QTableView>(*bench.view, "timingTable"), QStringLiteral("frame"),
                       widgets::TimingModel::kOverruns),
             QStringLiteral("1"));
    const QColor bad = mixed(bench.chart.palette().color(QPalette::Base),
                             colorOf(Meaning::kBad, bench.chart.palette()), 0.75);
    QVERIFY(countNear(bench.chart.grab().toImage(), bad) > 10);
  }

  void aClickOnABarMovesTheTimelineThereAndTheChartStands() {
    Running bench;
    const QPoint where = bench.bar(bench.shownFrame(5));
    QTest::mouseClick(&bench.chart, Qt::LeftButton, {}, where);
    bench.tick(*bench.view);
    QCOMPARE(bench.session.timeline().shown(), Running::at(5));
    QVERIFY(!bench.session.timeline().live());
    QVERIFY(!child<QToolButton>(*bench.view, "timingFollow").isChecked());
    QCOMPARE(bench.bar(bench.shownFrame(5)), where);
    // Live again, it follows again.
    bench.session.history().goLive();
    bench.tick(*bench.view);
    QVERIFY(bench.chart.follows());
  }

  void theWheelZoomsAndDraggingMovesTheChartWhileTheRobotContinues() {
    Running bench;
    const double span = bench.chart.span();
    turnWheel(bench.chart, bench.chart.rect().center(), 2);
    QVERIFY(bench.chart.span() < span);
    QVERIFY2(bench.chart.follows(), "zooming does not lose the present");
    bench.tick(*bench.view);
    const auto from = bench.chart.look().scale.from;
    drag(bench.chart, Qt::LeftButton, bench.chart.rect().center(),
         bench.chart.rect().center() + QPoint(100, 0));
    QVERIFY(bench.chart.look().scale.from < from);
    const auto held = bench.chart.look().scale.from;
    bench.frame(20);
    bench.tick(*bench.view);
    QCOMPARE(bench.chart.look().scale.from, held);
    click(*bench.view, "timingFollow");
    bench.tick(*bench.view);
    QVERIFY(bench.chart.look().scale.from > held);
  }

  void theKeyboardZoomsAndMovesTheChart() {
    Running bench;
    bench.chart.setFocus();
    const double span = bench.chart.span();
    QTest::keyClick(&bench.chart, Qt::Key_Plus);
    QVERIFY(bench.chart.span() < span);
    QTest::keyClick(&bench.chart, Qt::Key_Left);
    QVERIFY(!bench.chart.follows());
    QTest::keyClick(&bench.chart, Qt::Key_F);
    QVERIFY(bench.chart.follows());
  }

  void theLatencyFromImageToCommandIsShownAndSaysHowItIsMeasured() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>({900, 700});
    for (int i = 0; i < 50; ++i) {
      const double time = 1 + 0.04 * i;
      robotcontrol::StopwatchTimes measured = times(0.001, 0.003);
      robotlink::assign(*measured.mutable_timestamp(), robotlink::Instant(robotlink::fromSeconds(time)));
      measured.set_clock_stands(true);
      auto& image = *measured.add_received();
      image.set_name("camera/image");
      image.set_of_platform(true);
      robotlink::assign(*image.mutable_timestamp(), robotlink::Instant(robotlink::fromSeconds(time - 0.02)));
      auto& command = *measured.add_sent();
      command = image;
      command.set_name("joints/request");
      command.set_seconds(0.004);
      bench.push("red1/stopwatches/cognition", measured, time);
    }
    bench.tick(*view);
    auto& state = child<QLabel>(*view, "timingState");
    QCOMPARE(state.text(), QStringLiteral("camera/image to joints/request: 24.0 ms, 95 %: 24.0 ms"));
    auto& tabs = child<QTabWidget>(*view, "timingTabs");
    QTest::mouseClick(tabs.tabBar(), Qt::LeftButton, {}, tabs.tabBar()->tabRect(1).center());
    auto& table = child<QTableView>(*view, "latencyTable");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(table.model()->rowCount(), 1);
    QCOMPARE(table.model()->index(0, LatencyModel::kWaiting).data().toString(), QStringLiteral("20.00"));
    QCOMPARE(table.model()->index(0, LatencyModel::kComputing).data().toString(), QStringLiteral("4.00"));
    QVERIFY(child<QLabel>(*view, "latencyHow").text().contains(QStringLiteral("timestamp")));
    click(*view, "timingCopy");
    QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("from,to,last_ms")));
    keepPicture(*view, "latency");
  }

  void theChoicesOfTheChartAreRemembered() {
    Running bench;
    bench.chart.setSpan(7);
    child<QTabWidget>(*bench.view, "timingTabs").setCurrentIndex(1);
    const QJsonObject state = bench.view->saveState();
    auto other = bench.open<widgets::TimingView>();
    other->restoreState(state);
    QCOMPARE(child<GanttCanvas>(*other, "timingChart").span(), 7.0);
    QCOMPARE(child<QTabWidget>(*other, "timingTabs").currentIndex(), 1);
  }

  void aClickOnAHeaderSorts() {
    Bench bench;
    auto view = bench.open<widgets::TimingView>();
    bench.push("red1/stopwatches/cognition", times(0.010, 0.009), 1.0);
    bench.tick(*view);
    auto& table = child<QTableView>(*view, "timingTable");
    auto& header = *table.horizontalHeader();
    const int x = header.sectionViewportPosition(widgets::TimingModel::kMean) + 10;
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, {x, header.height() / 2});
    const auto first = [&] { return table.model()->index(0, widgets::TimingModel::kTask).data().toString(); };
    const QString ascending = first();
    QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, {x, header.height() / 2});
    QCOMPARE(QSet<QString>({ascending, first()}),
             QSet<QString>({QStringLiteral("pose"), QStringLiteral("frame")}));
  }
};

const GuiTest<TimingViewTest> kTimingViewTest;

}  // namespace widgets::test

#include "TimingViewTest.moc"
