// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/plots/PlotBench.h"

#include <QComboBox>
#include <QLabel>
#include <QToolButton>
#include <QTreeView>
#include <cmath>

#include "logplayer/base/LogWriter.h"
#include "robotcontrol/Modeling.pb.h"
#include "tests/widgets/LogBench.h"
#include "widgets/Theme.h"
#include "widgets/plots/LoggedCurves.h"
#include "widgets/plots/PlotCanvas.h"

namespace widgets::test {
namespace {

constexpr char kBallX[] = "red1/models/ball: position_in_robot.x";

/// An open log whose file exists: the ball moves by 1 m in each frame.
struct LogOnDisk : LogBench {
  static constexpr int kFrames = 60;

  LogOnDisk() {
    auto writer = logplayer::LogWriter::create(file, {});
    if (!writer) qFatal("the log cannot be written");
    for (int i = 0; i < kFrames; ++i) {
      auto ball = std::make_shared<robotcontrol::BallModel>();
      ball->mutable_position_in_robot()->set_x(i);
      if (!(*writer)->write({{"red1/models/ball", at(i * 0.04), ball}})) qFatal("the log cannot be written");
    }
    if (!(*writer)->container().close()) qFatal("the log cannot be written");
    shapeOverview = [](LogOverview& overview) {
      overview.robots = {"red1"};
      overview.streams.push_back(
          {"red1/models/ball", "robotcontrol.BallModel", kFrames, 0, at(0), at(kFrames * 0.04)});
    };
    openLog(file.string());
  }
  /// Ticks until the log was read; returns the points of the first curve.
  const robotlink::Series& readAll(widgets::PlotsView& view) {
    const auto& curves = *qobject_cast<CurveModel*>(child<QTreeView>(view, "plotsLegend").model());
    const LoggedCurve* curve = nullptr;
    const bool done = QTest::qWaitFor([&] {
      tick(view);
      const QString text = child<QLabel>(view, "plotsState").text();
      if (!text.isEmpty()) said = text;
      curve = curves.curves().front()->logged.get();
      return curve != nullptr && curve->isComplete;
    });
    if (!done) qFatal("the log was not read");
    return curve->series;
  }

  TestFolder folder;
  std::filesystem::path file = folder / "game.mcap";
  /// What was said last while reading.
  QString said;
};

}  // namespace

class PlotsLogTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theWholeLogIsReadWithoutPlayingItAndTheProgressIsSaid() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX));
    const auto& curve = log.readAll(*view);
    QCOMPARE(curve.size(), std::size_t{LogOnDisk::kFrames});
    QCOMPARE(curve.back().value, LogOnDisk::kFrames - 1.0);
    QVERIFY2(log.said.contains(QStringLiteral("game.mcap")), qPrintable(log.said));
    QCOMPARE(child<QLabel>(*view, "plotsState").text(), QString());
    auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    child<QComboBox>(*view, "plotsWindow").setCurrentText(QStringLiteral("all"));
    picture(log, *view);
    QCOMPARE(canvas.shownTimes(), std::pair(curve.front().time, curve.back().time));
  }

  void whatFollowsThePlayHeadIsSeen() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX));
    const auto& curve = log.readAll(*view);
    auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    child<QComboBox>(*view, "plotsWindow").setCurrentText(QStringLiteral("1 s"));
    // The session's time is 1 s, the log ends at 2.36 s.
    const QColor head = colorOf(Meaning::kBad, view->palette());
    QVERIFY(countNear(picture(log, *view), head, 0) > 0);
    QCOMPARE(canvas.shownTimes(), std::pair(0.5, 1.5));
    child<QComboBox>(*view, "plotsWindow").setCurrentText(QStringLiteral("2 s"));
    picture(log, *view);
    QCOMPARE(canvas.shownTimes(), std::pair(0.0, 2.0));
    log.session.timeline().show(at(2.2));
    picture(log, *view);
    QCOMPARE(canvas.shownTimes().second, curve.back().time);
  }

  void theLogOfACurveMovesWithItsOffset() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX));
    const auto& curve = log.readAll(*view);
    const double before = curve.front().time;
    log.status.mutable_logs(0)->set_offset(robotlink::fromSeconds(5).count());
    log.publish();
    log.tick(*view);
    QCOMPARE(curve.front().time, before + 5);
  }

  void theFilterOfACurveIsAppliedToTheWholeLogAlsoIfItMoves() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX) + QStringLiteral(" | derivative"));
    log.readAll(*view);
    log.tick(*view);
    const auto& curve =
        *qobject_cast<CurveModel*>(child<QTreeView>(*view, "plotsLegend").model())->curves().front();
    const auto check = [&](double begin) {
      QCOMPARE(curve.points().size(), std::size_t{LogOnDisk::kFrames - 1});
      QVERIFY(std::abs(curve.points().front().time - begin - 0.04) < 1e-9);
      QVERIFY(std::abs(curve.points().back().value - 25) < 1e-6);
    };
    check(0);
    log.status.mutable_logs(0)->set_offset(robotlink::fromSeconds(5).count());
    log.publish();
    log.tick(*view);
    check(5);
  }

  void bookmarksAreMarkedAsLongAsTheyAreThere() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX));
    log.readAll(*view);
    child<QComboBox>(*view, "plotsWindow").setCurrentText(QStringLiteral("all"));
    const QColor color = colorOf(Meaning::kNote, view->palette());
    const int none = countNear(picture(log, *view), color, 0);
    log.readings.at(log.file.string())->bookmarks.emplace(logplayer::Bookmarks::open(log.file));
    log.tick(*view);
    const auto id = log.logs().addBookmark(*log.logs().logs().front(), at(1), at(1), QStringLiteral("here"));
    const int one = countNear(picture(log, *view), color, 0);
    QVERIFY(one > none + 20);
    log.logs().addBookmark(*log.logs().logs().front(), at(1.5), at(2), QStringLiteral("there"));
    QVERIFY(countNear(picture(log, *view), color, 0) > one + 40);
    log.logs().removeBookmark(*log.logs().logs().front(), id);
    log.logs().undoStack().undo();
    log.logs().undoStack().undo();
    QCOMPARE(countNear(picture(log, *view), color, 0), one);
  }

  void aLogWithTooManyValuesIsSaid() {
    CurveModel curves;
    QVERIFY(curves.add(PlotSource::fromText(QLatin1String(kBallX))));
    auto logged = std::make_shared<LoggedCurve>();
    logged->series.append({1, 2});
    curves.curves().front()->logged = logged;
    const auto toolTip = [&] { return curves.index(0, 0).data(Qt::ToolTipRole).toString(); };
    QVERIFY(!toolTip().contains(QStringLiteral("memory")));
    logged->isCut = true;
    QVERIFY(toolTip().contains(QStringLiteral("memory")));
  }

  void whatAFilterMakesOfALogIsBoundedAndSaid() {
    constexpr std::size_t kBytes = 200'000;
    CurveModel curves;
    QVERIFY(curves.add(PlotSource::fromText(QLatin1String(kBallX) + QStringLiteral(" | scale 2"))));
    auto logged = std::make_shared<LoggedCurve>();
    for (int i = 0; i < 100'000; ++i) logged->series.append({0.01 * i, 1});
    auto& curve = *curves.curves().front();
    curve.logged = logged;
    QVERIFY(curve.takeLogged(kBytes));
    QVERIFY(curve.isFilteredCut);
    QVERIFY(curve.points().size() > 5000 && curve.bytes() < kBytes + 40'000);
    QVERIFY(curves.index(0, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("memory")));
  }

  void anExpressionIsReadOfTheWholeLog() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    QVERIFY(view->addCurve(QStringLiteral("= 2 * red1/models/ball.position_in_robot.x + 1")));
    const auto& curve = log.readAll(*view);
    QCOMPARE(curve.size(), std::size_t{LogOnDisk::kFrames});
    QCOMPARE(curve.back().value, 2.0 * (LogOnDisk::kFrames - 1) + 1);
    log.tick(*view);
    // The session has nothing of it, and that is said.
    QCOMPARE(child<QTreeView>(*view, "plotsLegend").model()->index(0, CurveModel::kValue).data().toString(),
             QStringLiteral("in the log only"));
  }

  void whatOnlyTheLogHasIsListedInGray() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    auto& tree = child<QTreeView>(*view, "plotsTree");
    tree.expandAll();
    const QModelIndex index = find(tree, QStringLiteral("position_in_robot.x"));
    QVERIFY(index.isValid());
    QCOMPARE(index.data(Qt::ForegroundRole).value<QBrush>().color(),
             colorOf(Meaning::kMuted, view->palette()));
    QVERIFY(index.data(Qt::ToolTipRole).toString().contains(QStringLiteral("log")));
  }

  void theWholeLogIsNotReadOnWish() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    click(child<QToolButton>(*view, "plotsWholeLog"));
    view->addCurve(QLatin1String(kBallX));
    log.tick(*view);
    auto& curves = LoggedCurves::of(log.logs());
    QCOMPARE(curves.stateText(), QString());
    auto again = log.openView<widgets::PlotsView>();
    again->restoreState(view->saveState());
    QVERIFY(!child<QToolButton>(*again, "plotsWholeLog").isChecked());
    log.tick(*again);
    QCOMPARE(curves.stateText(), QString());
    click(child<QToolButton>(*again, "plotsWholeLog"));
    QCOMPARE(log.readAll(*again).size(), std::size_t{LogOnDisk::kFrames});
  }

  void whatIsComputedAnewIsDrawnOverThePalerLog() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    view->addCurve(QLatin1String(kBallX));
    log.readAll(*view);
    child<QComboBox>(*view, "plotsWindow").setCurrentText(QStringLiteral("all"));
    const QColor full = curveColor(0, view->palette());
    const auto pixels = [&](const QColor& color) { return countNear(picture(log, *view), color, 0); };
    const int asLogged = pixels(full);
    QVERIFY(asLogged > 0);
    auto& package = *log.status.add_packages();
    package.set_package("red1/models/ball");
    package.set_logged(true);
    package.set_source(robotcontrol::ControlReplay::RECOMPUTED);
    log.publish();
    QCOMPARE(pixels(full), 0);
    robotcontrol::BallModel ball;
    for (int i = 0; i < 20; ++i) {
      ball.mutable_position_in_robot()->set_x(LogOnDisk::kFrames - i);
      log.push("red1/models/ball", ball, i * 0.04);
    }
    const int computed = pixels(full);
    QVERIFY2(computed > 0 && computed < asLogged, qPrintable(QString::number(computed)));
  }

  void aLogThatCannotBeReadIsSaid() {
    LogOnDisk log;
    auto view = log.openView<widgets::PlotsView>();
    std::filesystem::remove(log.file);
    view->addCurve(QLatin1String(kBallX));
    QTRY_VERIFY((log.tick(*view),
                 child<QLabel>(*view, "plotsState").text().contains(QStringLiteral("cannot be read"))));
  }
};

const GuiTest<PlotsLogTest> kPlotsLogTest;

}  // namespace widgets::test

#include "PlotsLogTest.moc"
