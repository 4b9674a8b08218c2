// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/widgets/plots/PlotBench.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>
#include <cmath>

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/TestFolder.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/LogBench.h"
#include "widgets/Theme.h"
#include "widgets/plots/PlotCanvas.h"

namespace widgets::test {
namespace {

/// Counts how often a widget is painted.
class PlotPaints final : public QObject {
 public:
  explicit PlotPaints(QWidget& watched) { watched.installEventFilter(this); }
  int count = 0;

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() == QEvent::Paint) ++count;
    return false;
  }
};

}  // namespace

class PlotsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void plotValuesAndNumbersOfAllStreamsCanBeFoundAndAdded() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    pushStatus(bench, 1, 0.12);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    QAbstractItemModelTester tester(tree.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QTest::keyClicks(&child<QLineEdit>(*view, "plotsSearch"), QStringLiteral("velocity.x"));
    QVERIFY(!find(tree, QStringLiteral("ball-model")).isValid());
    tree.setCurrentIndex(find(tree, QStringLiteral("velocity.x")));
    QTest::keyClick(&tree, Qt::Key_Return);
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    QCOMPARE(legend.model()->rowCount(), 1);
    QCOMPARE(legend.model()->index(0, 0).data().toString(), QStringLiteral("red1/motion/status: velocity.x"));
    QCOMPARE(legend.model()->index(0, 1).data().toString(), QStringLiteral("0.12"));
    child<QLineEdit>(*view, "plotsSearch").clear();
    tree.setCurrentIndex(find(tree, QStringLiteral("x")));
    click(child<QToolButton>(*view, "plotsAdd"));
    QCOMPARE(legend.model()->rowCount(), 2);
    QCOMPARE(legend.model()->index(1, 2).data().toString(), QStringLiteral("m"));
  }

  void whatIsNewIsDrawnInEachTick() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    QVERIFY(view->addCurve(QLatin1String(kPlot)));
    picture(bench, *view);
    PlotPaints paints(child<QWidget>(*view, "plotCanvas"));
    for (int tick = 1; tick <= 12; ++tick) {
      paints.count = 0;
      pushPlot(bench, 1 + 0.033 * tick, tick);
      bench.tick(*view);
      // The first call draws what is queued, the second one paints it.
      QCoreApplication::processEvents();
      QCoreApplication::processEvents();
      QVERIFY2(paints.count > 0, qPrintable(QString::number(tick)));
    }
  }

  void elementsOfLongListsAreBelowOneRow() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    foxglove::LaserScan scan;
    for (int i = 0; i < 40; ++i) scan.add_ranges(i);
    for (int i = 0; i < 32; ++i) scan.add_intensities(i);
    bench.push("red1/scan", scan, 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    const QModelIndex list = find(tree, QStringLiteral("ranges[0 … 39]"));
    QVERIFY(list.isValid() && !tree.isExpanded(list));
    QCOMPARE(tree.model()->rowCount(list), 40);
    QCOMPARE(find(tree, QStringLiteral("ranges[39]")).parent(), list);
    QCOMPARE(find(tree, QStringLiteral("intensities[31]")).parent(), list.parent());
    tree.setCurrentIndex(find(tree, QStringLiteral("ranges[7]")));
    click(child<QToolButton>(*view, "plotsAdd"));
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    QCOMPARE(legend.model()->index(0, 0).data().toString(), QStringLiteral("red1/scan: ranges[7]"));
  }

  void valuesAreInTheNaturalOrderWithUnitsAndTheNamesOfJoints() {
    Bench bench;
    auto robot = std::make_shared<robotlink::RobotDescription>();
    for (const char* joint : {"headTilt", "headPan"}) robot->joints.push_back({.name = joint});
    bench.context.robots["red1"] = robot;
    auto view = bench.open<widgets::PlotsView>();
    robotcontrol::JointRequest request;
    for (int i = 0; i < 12; ++i) request.add_positions(0.1 * i);
    request.set_stiffness(1);
    for (const char* stream : {"red1/plots/10", "red1/plots/9", "red1/plots/x"})
      bench.push(stream, robotcontrol::PlotValue(), 1);
    bench.push("red1/motion/joints", request, 1);
    pushStatus(bench, 1, 0.12);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    QStringList names;
    const QModelIndex joints = find(tree, QStringLiteral("joints"));
    for (int row = 0; row < tree.model()->rowCount(joints); ++row)
      names << tree.model()->index(row, 0, joints).data().toString();
    QCOMPARE(names.mid(0, 3),
             QStringList({QStringLiteral("positions[0] headTilt"), QStringLiteral("positions[1] headPan"),
                          QStringLiteral("positions[2]")}));
    QVERIFY(names.indexOf(QStringLiteral("positions[11]")) ==
            names.indexOf(QStringLiteral("positions[2]")) + 9);
    QCOMPARE(find(tree, QStringLiteral("positions[1] headPan"), 1).data().toString(), QStringLiteral("rad"));
    QCOMPARE(find(tree, QStringLiteral("velocity.x"), 1).data().toString(), QStringLiteral("m/s"));
    QVERIFY(find(tree, QStringLiteral("9")).row() < find(tree, QStringLiteral("10")).row());
    view->addCurve(QStringLiteral("red1/motion/status: velocity.x"));
    QCOMPARE(child<QTreeView>(*view, "plotsLegend").model()->index(0, 2).data().toString(),
             QStringLiteral("m/s"));
  }

  void noLineIsDrawnWhereNothingWasHeard() {
    const auto at = [](int seconds) { return robotlink::Instant(std::chrono::seconds(seconds)); };
    const auto lineLength = [](const std::vector<robotlink::LineGap>& gaps) {
      Bench bench;
      auto view = bench.open<widgets::PlotsView>();
      view->addCurve(QLatin1String(kPlot));
      bench.session.setRemoteRobots({{"red1", {"ws://hall:8765", true, "connected", gaps}}});
      for (const double time : {1.0, 2.0, 5.0, 6.0}) pushPlot(bench, time, 0.5);
      const QImage image = picture(bench, *view);
      const QRgb color = curveColor(0, view->palette()).rgb();
      int pixels = 0;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) pixels += image.pixel(x, y) == color ? 1 : 0;
      }
      return pixels;
    };
    const int whole = lineLength({});
    const int cut = lineLength({{at(2), at(5)}});
    QVERIFY(cut > 0);
    QVERIFY2(cut < whole / 2 && cut > whole / 4, qPrintable(QStringLiteral("%1 %2").arg(whole).arg(cut)));
  }

  void theValueUnderTheCursorIsShown() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i <= 10; ++i) pushPlot(bench, i, i);
    view->addCurve(QString::fromLatin1(kPlot));
    const QImage before = picture(bench, *view);
    auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    auto& plot = child<QWidget>(*view, "plotCanvas");
    const auto legend = [&view](int column) {
      return child<QTreeView>(*view, "plotsLegend").model()->index(0, column).data().toString();
    };
    QCOMPARE(legend(3), QString());
    const auto [from, to] = canvas.shownTimes();
    QMouseEvent move(QEvent::MouseMove, QPointF(plot.width() * 3 / 4, plot.height() / 2), Qt::NoButton,
                     Qt::NoButton, {});
    QCoreApplication::sendEvent(&plot, &move);
    const double value = legend(3).toDouble();
    QVERIFY2(value >= 3 && value <= 9 && value == std::floor(value), qPrintable(legend(3)));
    QVERIFY(from < value && value < to);
    const auto time = [&] {
      return child<QTreeView>(*view, "plotsLegend")
          .model()
          ->headerData(3, Qt::Horizontal)
          .toString()
          .section(QLatin1Char(' '), 1, 1)
          .toDouble();
    };
    const double sinceZero = time();
    bench.session.timeline().setOrigin(robotlink::Instant(std::chrono::seconds(2)));
    bench.tick(*view);
    QVERIFY(std::abs(sinceZero - 2 - time()) < 1e-6);
    QVERIFY(picture(bench, *view) != before);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&plot, &leave);
    QCOMPARE(legend(3), QString());
  }

  void aCurveIsDrawnAndNewValuesChangeThePicture() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    const QImage empty = picture(bench, *view);
    pushPlot(bench, 1, 0.5);
    pushPlot(bench, 2, 0.7);
    view->addCurve(QString::fromLatin1(kPlot));
    const QImage two = picture(bench, *view);
    QVERIFY(two != empty);
    pushPlot(bench, 3, -0.5);
    QVERIFY(picture(bench, *view) != two);
  }

  void pauseHoldsThePictureAndNothingIsLost() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    view->addCurve(QString::fromLatin1(kPlot));
    const QImage before = picture(bench, *view);
    click(child<QToolButton>(*view, "plotsPause"));
    pushPlot(bench, 2, 0.9);
    QVERIFY(picture(bench, *view) == before);
    click(child<QToolButton>(*view, "plotsPause"));
    QVERIFY(picture(bench, *view) != before);
    QCOMPARE(child<QTreeView>(*view, "plotsLegend").model()->index(0, 1).data().toString(),
             QStringLiteral("0.9"));
  }

  void aPackageThatIsNotPublishedYetIsRequestedAndTheViewSaysSo() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    robotcontrol::ProcessTable processes;
    auto& port = *processes.add_processes()->add_senders();
    port.set_package("motion/status");
    port.set_type("robotcontrol.MotionStatus");
    robotcontrol::KeyTable keys;
    keys.add_keys()->set_name("package/motion/status");
    bench.push("red1/tables/processes", processes, 1);
    bench.push("red1/tables/keys", keys, 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    tree.setCurrentIndex(find(tree, QStringLiteral("velocity.y")));
    QVERIFY(tree.currentIndex().isValid());
    click(child<QToolButton>(*view, "plotsAdd"));
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("package/motion/status"));
    QCOMPARE(bench.requests[0].set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
    QVERIFY(child<QLabel>(*view, "plotsState").text().contains(QStringLiteral("package/motion/status")));
  }

  void whatIsNoTableOfKeysIsNotTakenForOne() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    // As any server or log may have it.
    bench.push("red1/tables/keys", robotcontrol::PlotValue(), 1);
    view->addCurve(QString::fromLatin1(kPlot));
    bench.tick(*view);
    QVERIFY(bench.requests.empty());
  }

  void whatALogHoldsIsNotAskedFor() {
    LogBench bench;
    auto& package = *bench.status.add_packages();
    package.set_package("nao/motion/status");
    package.set_logged(true);
    package.set_source(robotcontrol::ControlReplay::AS_LOGGED);
    bench.openLog("/logs/game.mcap");
    auto view = bench.openView<widgets::PlotsView>();
    view->restoreState(
        {{QStringLiteral("curves"), QJsonArray{QStringLiteral("nao/motion/status: velocity.x")}}});
    robotcontrol::KeyTable keys;
    keys.add_keys()->set_name("package/motion/status");
    bench.push("nao/tables/keys", keys, 11);
    bench.tick(*view);
    QVERIFY(bench.requests.empty());
    bench.status.mutable_packages(0)->set_source(robotcontrol::ControlReplay::RECOMPUTED);
    bench.publish();
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("package/motion/status"));
  }

  void aValueIsDroppedIntoThePlot() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    const QModelIndex value = find(tree, QStringLiteral("x"));
    QVERIFY(value.flags().testFlag(Qt::ItemIsDragEnabled));
    std::unique_ptr<QMimeData> data(tree.model()->mimeData({value}));
    auto& canvas = child<QWidget>(*view, "plotCanvas");
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({10, 10}, Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QCoreApplication::sendEvent(&canvas, &drop);
    QCOMPARE(child<QTreeView>(*view, "plotsLegend").model()->rowCount(), 1);
  }

  void theTreeOfValuesIsHiddenOnWish() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    auto& tree = child<QTreeView>(*view, "plotsTree");
    QVERIFY(tree.isVisible());
    click(child<QToolButton>(*view, "plotsShowTree"));
    QVERIFY(!tree.isVisible());
  }

  void curvesAreRemoved() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    view->addCurve(QString::fromLatin1(kPlot));
    bench.tick(*view);
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    legend.setCurrentIndex(legend.model()->index(0, 0));
    click(child<QToolButton>(*view, "plotsRemove"));
    QCOMPARE(legend.model()->rowCount(), 0);
  }

  void pointsAndPictureAreExported() {
    Bench bench;
    QTemporaryDir folder;
    auto view = bench.open<widgets::PlotsView>();
    view->setFileQuestion([&](const QString&, const QString& suffix) {
      return folder.filePath(QStringLiteral("out.") + suffix);
    });
    pushPlot(bench, 1, 0.5);
    pushStatus(bench, 2, 0.25);
    view->addCurve(QString::fromLatin1(kPlot));
    view->addCurve(QStringLiteral("red1/motion/status: velocity.x"));
    bench.tick(*view);
    click(child<QToolButton>(*view, "plotsCsv"));
    QFile csv(folder.filePath(QStringLiteral("out.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readAll(),
             QByteArray("time_s,\"red1/plots/ball-model/position/x\",\"red1/motion/status: velocity.x\"\n"
                        "1.000000,0.5,\n2.000000,,0.25\n"));
    click(child<QToolButton>(*view, "plotsPng"));
    QVERIFY(!QImage(folder.filePath(QStringLiteral("out.png"))).isNull());
    click(child<QToolButton>(*view, "plotsSvg"));
    QFile svg(folder.filePath(QStringLiteral("out.svg")));
    QVERIFY(svg.open(QIODevice::ReadOnly));
    QVERIFY(svg.readAll().contains("<polyline"));
    click(child<QToolButton>(*view, "plotsCopy"));
    QVERIFY(QGuiApplication::clipboard()->image().width() > 100);
  }

  void theTimeAxisFollowsAnotherLog() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    pushPlot(bench, 2, 0.75);
    view->addCurve(QString::fromLatin1(kPlot));
    picture(bench, *view);
    click(child<QToolButton>(*view, "plotsFit"));
    auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    picture(bench, *view);
    QVERIFY(canvas.shownTimes().second < 3);
    bench.session.restart();
    bench.session.timeline().setOrigin(robotlink::Instant(std::chrono::seconds(1000)));
    pushPlot(bench, 1000, 0.5);
    pushPlot(bench, 1001, 0.75);
    picture(bench, *view);
    QCOMPARE(canvas.shownTimes().second, 1001.0);
  }

  void exportedTimesCountFromTheOriginAsThoseOfThePlot() {
    Bench bench;
    const TestFolder folder;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1000, 0.5);
    pushPlot(bench, 1002.5, 0.75);
    view->addCurve(QString::fromLatin1(kPlot));
    bench.session.timeline().setOrigin(robotlink::Instant(std::chrono::seconds(1000)));
    bench.tick(*view);
    QVERIFY(view->saveTo(QString::fromStdString((folder / "points.csv").string())));
    QCOMPARE(QString::fromStdString(robotlink::readFile(folder / "points.csv").value_or("")),
             QStringLiteral("time_s,\"red1/plots/ball-model/position/x\"\n0.000000,0.5\n2.500000,0.75\n"));
  }

  void theFileOfAnExportIsAskedFor() {
    Bench bench;
    QTemporaryDir folder;
    auto view = bench.open<widgets::PlotsView>();
    pushPlot(bench, 1, 0.5);
    view->addCurve(QString::fromLatin1(kPlot));
    bench.tick(*view);
    DialogAnswer table = DialogAnswer::file(folder.filePath(QStringLiteral("asked.csv")));
    click(child<QToolButton>(*view, "plotsCsv"));
    QVERIFY(table.asked());
    QVERIFY(QFile::exists(folder.filePath(QStringLiteral("asked.csv"))));
    DialogAnswer nothing([](QDialog& dialog) { DialogAnswer::press(dialog, QDialogButtonBox::RejectRole); });
    click(child<QToolButton>(*view, "plotsPng"));
    QVERIFY(nothing.asked());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 1);
  }

  void ofAVeryLongStateOnlyTheFirstCurvesAreTaken() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    QJsonArray curves;
    for (int i = 0; i < 5000; ++i) curves.append(QStringLiteral("red1/plots/ball-model/p%1 value").arg(i));
    view->restoreState({{QStringLiteral("curves"), curves}});
    QCOMPARE(view->saveState()[QStringLiteral("curves")].toArray().size(), widgets::PlotsView::kMaxRestored);
    const QString said = child<QLabel>(*view, "plotsState").text();
    QVERIFY2(said.contains(QStringLiteral("5000")) && said.contains(QStringLiteral("100")), qPrintable(said));
  }

  void curvesComeBackEvenBeforeTheirData() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    view->addCurve(QString::fromLatin1(kPlot));
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    auto& legend = child<QTreeView>(*again, "plotsLegend");
    QCOMPARE(legend.model()->rowCount(), 1);
    QCOMPARE(legend.model()->index(0, 1).data().toString(), QStringLiteral("missing"));
    pushPlot(bench, 1, 0.5);
    picture(bench, *again);
    QCOMPARE(legend.model()->index(0, 1).data().toString(), QStringLiteral("0.5"));
  }
};

const GuiTest<PlotsViewTest> kPlotsViewTest;

}  // namespace widgets::test

#include "PlotsViewTest.moc"
