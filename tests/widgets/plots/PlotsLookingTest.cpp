// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/plots/PlotBench.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>
#include <cmath>
#include <functional>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/timeline/MadeUpArchive.h"
#include "widgets/plots/PlotCanvas.h"

namespace widgets::test {

namespace {

/// How many instants the table of all points has.
int exportedPoints(Bench& bench, widgets::PlotsView& view) {
  bench.tick(view);
  return view.numbers().value_or(QString()).count(QLatin1Char('\n')) - 1;
}

}  // namespace

class PlotsLookingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void zoomingEndsFollowingAndFollowBringsTheNewestBack() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i < 100; ++i) pushPlot(bench, i * 0.1, i % 7);
    view->addCurve(QString::fromLatin1(kPlot));
    const QImage before = picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    QCOMPARE(plots.shownTimes().first, -0.1);
    QCOMPARE(plots.shownTimes().second, 9.9);
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    QWheelEvent wheel(QPointF(canvas.rect().center()), canvas.mapToGlobal(canvas.rect().center()), {},
                      {0, 120}, {}, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&canvas, &wheel);
    QVERIFY(!child<QToolButton>(*view, "plotsFollow").isChecked());
    QVERIFY(picture(bench, *view) != before);
    QVERIFY(plots.shownTimes().first > 0 && plots.shownTimes().second < 9.9);
    click(child<QToolButton>(*view, "plotsFit"));
    QCOMPARE(plots.shownTimes().first, 0.0);
    click(child<QToolButton>(*view, "plotsFollow"));
    picture(bench, *view);
    QCOMPARE(plots.shownTimes().first, -0.1);
    child<QComboBox>(*view, "plotsWindow").setCurrentIndex(1);
    picture(bench, *view);
    QCOMPARE(plots.shownTimes().first, 7.9);
    QCOMPARE(plots.shownTimes().second, 9.9);
  }

  void whatIsOnDiskIsReadAndStandsBeforeTheRest() {
    const TestFolder folder;
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    for (int i = 0; i < 300; ++i) {
      pushPlot(bench, 1 + i * 0.1, i % 7);
      if (i % 10 == 0) bench.session.tick();
    }
    auto view = bench.open<widgets::PlotsView>();
    QVERIFY(bench.session.store().find(kPlot)->messages.size() < 300);
    for (const char* filter : {"", " | integral"})
      QVERIFY(view->addCurve(QString::fromLatin1(kPlot) + QLatin1String(filter)));
    const auto file = folder / "plot.csv";
    const bool isRead = QTest::qWaitFor([&] {
      bench.tick(*view);
      if (!view->saveTo(QString::fromStdString(file.string()))) return false;
      const auto text = robotlink::readFile(file);
      return text && std::count(text->begin(), text->end(), '\n') == 301;
    });
    QVERIFY(isRead);
    keepPicture(picture(bench, *view), "plots-from-disk");
  }

  void whatComesWhileItIsHiddenOrPausedIsNotMissing() {
    Bench bench;
    bench.session.store().setBytes(20'000);
    auto view = bench.open<widgets::PlotsView>();
    QVERIFY(view->addCurve(QString::fromLatin1(kPlot)));
    const auto publish = [&bench](int from, const std::function<void()>& tick) {
      for (int i = from; i < from + 300; ++i) {
        pushPlot(bench, 1 + i * 0.1, i % 7);
        if (i % 10 != 0) continue;
        bench.session.tick();
        tick();
      }
    };
    publish(0, [&view] { view->tickHidden(); });
    QCOMPARE(exportedPoints(bench, *view), 300);
    click(child<QToolButton>(*view, "plotsPause"));
    publish(300, [&view] { view->tick(); });
    publish(600, [&view] { view->tickHidden(); });
    QCOMPARE(exportedPoints(bench, *view), 300);
    click(child<QToolButton>(*view, "plotsPause"));
    QCOMPARE(exportedPoints(bench, *view), 900);
    QVERIFY(bench.session.store().find(kPlot)->messages.size() < 300);
  }

  void whatCameWhileItWasClosedIsReadFromDisk() {
    Bench bench;
    bench.session.history().setArchive(std::make_unique<MadeUpArchive>(true));
    bench.session.store().setBytes(20'000);
    auto view = bench.open<widgets::PlotsView>();
    for (const char* filter : {"", " | integral"})
      QVERIFY(view->addCurve(QString::fromLatin1(kPlot) + QLatin1String(filter)));
    for (int i = 0; i < 600; ++i) {
      if (i == 100) view->hide();
      pushPlot(bench, 1 + i * 0.1, i % 7);
      if (i % 10 != 0) continue;
      bench.session.tick();
      if (i < 100) view->tick();
    }
    view->show();
    const bool isRead = QTest::qWaitFor([&] { return exportedPoints(bench, *view) == 600; });
    QVERIFY2(isRead, std::to_string(exportedPoints(bench, *view)).c_str());
  }

  void draggingThePlotEndsFollowing() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i < 100; ++i) pushPlot(bench, i * 0.1, i % 7);
    view->addCurve(QString::fromLatin1(kPlot));
    picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    const double before = plots.shownTimes().first;
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    const QPoint middle = canvas.rect().center();
    QTest::mousePress(&canvas, Qt::LeftButton, {}, middle);
    QMouseEvent move(QEvent::MouseMove, middle + QPoint(60, 0), Qt::NoButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas, &move);
    QTest::mouseRelease(&canvas, Qt::LeftButton, {}, middle + QPoint(60, 0));
    QVERIFY(!child<QToolButton>(*view, "plotsFollow").isChecked());
    pushPlot(bench, 10, 3);
    picture(bench, *view);
    QVERIFY(plots.shownTimes().first < before);
  }

  void zoomsAndPansAreUndoneAndRedone() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i < 100; ++i) pushPlot(bench, i * 0.1, i % 7);
    view->addCurve(QString::fromLatin1(kPlot));
    picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    QVERIFY(!child<QToolButton>(*view, "plotsUndo").isEnabled());
    const PlotRanges whole = plots.ranges();
    // A few notches of the wheel are one step.
    for (int i = 0; i < 3; ++i) turnWheel(canvas, canvas.rect().center(), 1);
    const PlotRanges zoomed = plots.ranges();
    QVERIFY(zoomed.times.first > whole.times.first && zoomed.values == whole.values);
    drag(canvas, Qt::LeftButton, canvas.rect().center(), canvas.rect().center() + QPoint(60, 30));
    const PlotRanges moved = plots.ranges();
    QVERIFY(moved.times.first < zoomed.times.first && moved.values.first > zoomed.values.first);
    picture(bench, *view);
    click(child<QToolButton>(*view, "plotsUndo"));
    QCOMPARE(plots.ranges(), zoomed);
    QTest::keyClick(&canvas, Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(plots.ranges(), whole);
    bench.tick(*view);
    QVERIFY(!child<QToolButton>(*view, "plotsUndo").isEnabled());
    click(child<QToolButton>(*view, "plotsRedo"));
    QCOMPARE(plots.ranges(), zoomed);
    click(child<QToolButton>(*view, "plotsFit"));
    QVERIFY(plots.ranges() != zoomed);
    bench.tick(*view);
    click(child<QToolButton>(*view, "plotsUndo"));
    QCOMPARE(plots.ranges(), zoomed);
    bench.tick(*view);
    QVERIFY(child<QToolButton>(*view, "plotsRedo").isEnabled());
    turnWheel(canvas, canvas.rect().center(), 1);
    bench.tick(*view);
    QVERIFY(!child<QToolButton>(*view, "plotsRedo").isEnabled());
  }

  void theRightButtonZoomsToABox() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i < 100; ++i) pushPlot(bench, i * 0.1, i % 7);
    view->addCurve(QString::fromLatin1(kPlot));
    picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    const PlotRanges before = plots.ranges();
    const QPoint middle = canvas.rect().center();
    drag(canvas, Qt::RightButton, middle - QPoint(50, 40), middle + QPoint(50, 40));
    const PlotRanges after = plots.ranges();
    QVERIFY(after.times.first > before.times.first && after.times.second < before.times.second);
    QVERIFY(after.values.first > before.values.first && after.values.second < before.values.second);
    QVERIFY(!child<QToolButton>(*view, "plotsFollow").isChecked());
    bench.tick(*view);
    click(child<QToolButton>(*view, "plotsUndo"));
    QCOMPARE(plots.ranges(), before);
  }

  void followingIsNoStepBack() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    view->addCurve(QString::fromLatin1(kPlot));
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    for (int i = 0; i < 10; ++i) {
      pushPlot(bench, i, i);
      if (i == 5) QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.rect().center());
      picture(bench, *view);
    }
    QVERIFY(child<QToolButton>(*view, "plotsFollow").isChecked());
    QVERIFY(!child<QToolButton>(*view, "plotsUndo").isEnabled());
  }

  void theTimesOfLinkedPlotsAreTheSame() {
    Bench bench;
    std::vector<std::unique_ptr<widgets::PlotsView>> views;
    for (int i = 0; i < 3; ++i) views.push_back(bench.open<widgets::PlotsView>());
    for (int i = 0; i < 100; ++i) pushPlot(bench, i * 0.1, i % 7);
    for (const auto& view : views) {
      view->addCurve(QString::fromLatin1(kPlot));
      picture(bench, *view);
    }
    const auto times = [&](int i) {
      return views[static_cast<std::size_t>(i)]->findChild<widgets::PlotCanvas*>()->shownTimes();
    };
    const auto before = times(2);
    for (int i = 0; i < 2; ++i) click(child<QToolButton>(*views[static_cast<std::size_t>(i)], "plotsLink"));
    auto& canvas = child<QWidget>(*views[0], "plotCanvas");
    turnWheel(canvas, canvas.rect().center(), 2);
    QCOMPARE(times(1), times(0));
    QVERIFY(times(0) != before);
    QCOMPARE(times(2), before);
    picture(bench, *views[1]);
    QCOMPARE(times(1), times(0));
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(views[0]->saveState());
    QVERIFY(child<QToolButton>(*again, "plotsLink").isChecked());
  }

  void whatIsBetweenTwoCursorsIsShown() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i <= 10; ++i) pushPlot(bench, i, i * i);
    view->addCurve(QString::fromLatin1(kPlot));
    picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    auto& table = child<QTreeView>(*view, "plotsStatistics");
    QAbstractItemModelTester tester(table.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QVERIFY(!table.isVisible());
    const QImage without = picture(bench, *view);
    plots.showTimes(0, 10);
    const auto clickAt = [&](double share, Qt::KeyboardModifiers keys) {
      // The axes take some pixels at the left; the numbers below allow for them.
      QTest::mouseClick(&canvas, Qt::LeftButton, keys,
                        QPoint(int(canvas.width() * share), canvas.height() / 2));
    };
    clickAt(0.3, {});
    clickAt(0.8, Qt::ShiftModifier);
    QVERIFY(table.isVisible() && child<QToolButton>(*view, "plotsCursors").isChecked());
    const auto cell = [&](int column) { return table.model()->index(0, column).data().toDouble(); };
    const double first = std::sqrt(cell(CursorModel::kFirst)), second = std::sqrt(cell(CursorModel::kSecond));
    QVERIFY(first == std::floor(first) && first >= 1 && second > first + 3);
    QCOMPARE(cell(CursorModel::kDifference), second * second - first * first);
    QCOMPARE(cell(CursorModel::kMin), (first + 1) * (first + 1));
    QCOMPARE(cell(CursorModel::kMax), second * second);
    QVERIFY(cell(CursorModel::kMean) > cell(CursorModel::kMin) &&
            cell(CursorModel::kMean) < cell(CursorModel::kMax));
    QVERIFY(cell(CursorModel::kDeviation) > 0);
    QVERIFY(picture(bench, *view) != without);
    keepPicture(*view, "plot-cursors");
    // A second curve gets a row.
    pushStatus(bench, 5, 0.25);
    view->addCurve(QStringLiteral("red1/motion/status: velocity.x"));
    bench.tick(*view);
    QCOMPARE(table.model()->rowCount(), 2);
    QCOMPARE(table.model()->index(1, CursorModel::kMean).data().toString(), QStringLiteral("0.25"));
    click(child<QToolButton>(*view, "plotsCursors"));
    QVERIFY(!table.isVisible());
  }

  void whatIsComputedOfACurveIsACurve() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    view->addCurve(QString::fromLatin1(kPlot));
    for (int i = 0; i <= 10; ++i) pushPlot(bench, 0.5 * i, 3 * i);
    picture(bench, *view);
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    const auto cell = [&](int row, int column) {
      return legend.model()->index(row, column).data().toString();
    };
    child<QAction>(*view, "plotsCompute-derivative").trigger();
    QCOMPARE(legend.model()->rowCount(), 1);
    legend.setCurrentIndex(legend.model()->index(0, 0));
    child<QAction>(*view, "plotsCompute-derivative").trigger();
    DialogAnswer number([](QDialog& dialog) {
      dialog.findChild<QDoubleSpinBox*>()->setValue(1.2);
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    child<QAction>(*view, "plotsCompute-median").trigger();
    QVERIFY(number.asked());
    QCOMPARE(cell(1, 0), QLatin1String(kPlot) + QStringLiteral(" | derivative"));
    QCOMPARE(cell(1, 1), QStringLiteral("6"));
    QCOMPARE(cell(1, 2), QStringLiteral("m/s"));
    QCOMPARE(cell(2, 0), QLatin1String(kPlot) + QStringLiteral(" | median 1.2"));
    QCOMPARE(cell(2, 1), QStringLiteral("27"));
    QVERIFY(!view->addCurve(QLatin1String(kPlot) + QStringLiteral(" | derivative")));
    QVERIFY(!view->addCurve(QLatin1String(kPlot) + QStringLiteral(" | nothing")));
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    QCOMPARE(again->curves(), view->curves());
    // What is computed starts over when the clock goes back.
    pushPlot(bench, 0.1, 7);
    picture(bench, *view);
    pushPlot(bench, 0.2, 8);
    picture(bench, *view);
    QCOMPARE(cell(1, 1), QStringLiteral("10"));
  }

  void aCurveHasItsAxisOnTheRight() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i <= 10; ++i) {
      pushPlot(bench, i, 1000 + i);
      pushStatus(bench, i, 0.01 * i);
    }
    view->addCurve(QString::fromLatin1(kPlot));
    view->addCurve(QStringLiteral("red1/motion/status: velocity.x"));
    picture(bench, *view);
    auto& plots = *view->findChild<widgets::PlotCanvas*>();
    QVERIFY(plots.ranges().values.first < 0 && plots.ranges().values.second > 1010);
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    legend.setCurrentIndex(legend.model()->index(1, 0));
    click(child<QToolButton>(*view, "plotsRight"));
    picture(bench, *view);
    QVERIFY(plots.ranges().values.first > 999);
    QVERIFY(plots.ranges().rightValues.second < 0.2 && plots.ranges().rightValues.second > 0.1);
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    picture(bench, *again);
    QVERIFY(again->findChild<widgets::PlotCanvas*>()->ranges().values.first > 999);
    click(child<QToolButton>(*view, "plotsRight"));
    picture(bench, *view);
    QVERIFY(plots.ranges().values.first < 0);
  }
};

const GuiTest<PlotsLookingTest> kPlotsLookingTest;

}  // namespace widgets::test

#include "PlotsLookingTest.moc"
