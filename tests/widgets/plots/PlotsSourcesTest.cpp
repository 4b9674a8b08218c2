// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions, states, curves over each other, spectra, and what could be plotted.
#include "tests/widgets/plots/PlotBench.h"

#include <QAction>
#include <QComboBox>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "widgets/Theme.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/plots/PlotCanvas.h"
#include "widgets/plots/SpectrumCanvas.h"

namespace widgets::test {
namespace {

void pushBall(Bench& bench, double time, double x, double y, bool seen = true) {
  robotcontrol::BallModel ball;
  ball.mutable_position_in_robot()->set_x(x);
  ball.mutable_position_in_robot()->set_y(y);
  ball.set_known(seen);
  bench.push("red1/models/ball", ball, time);
}

const CurveModel& curvesOf(const View& view) {
  return *qobject_cast<CurveModel*>(child<QTreeView>(view, "plotsLegend").model());
}

QString legendCell(const View& view, int row, int column) {
  return child<QTreeView>(view, "plotsLegend").model()->index(row, column).data().toString();
}

QString textOf(const char* text) {
  return QLatin1String(text);
}

}  // namespace

class PlotsSourcesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aCurveIsRemovedByWhatAddedIt() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushBall(bench, 1, 3, 4);
    bench.tick(*view);
    for (const char* text : {"models/ball.position_in_robot.x", "red1/models/ball.position_in_robot.x",
                             "= 2 * models/ball.position_in_robot.x"}) {
      QVERIFY(view->addCurve(textOf(text)));
      QVERIFY(view->removeCurve(textOf(text)));
      QCOMPARE(view->curves(), QStringList());
    }
    QVERIFY(view->addCurve(textOf("models/ball.position_in_robot.x")));
    bench.tick(*view);
    QCOMPARE(view->curves(), QStringList(textOf("red1/models/ball: position_in_robot.x")));
    QCOMPARE(legendCell(*view, 0, CurveModel::kUnit), QStringLiteral("m"));
    QVERIFY(!view->removeCurve(textOf("models/ball.position_in_robot.y")));
  }

  void anExpressionThatIsTypedIsACurve() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushBall(bench, 1, 3, 4);
    bench.tick(*view);
    auto& field = child<QLineEdit>(*view, "plotsExpression");
    QTest::keyClicks(&field,
                     textOf("sqrt(models/ball.position_in_robot.x^2 + models/ball.position_in_robot.y^2)"));
    QTest::keyClick(&field, Qt::Key_Return);
    QCOMPARE(field.text(), QString());
    QCOMPARE(view->curves().front(), textOf("= sqrt(red1/models/ball.position_in_robot.x^2 + "
                                            "red1/models/ball.position_in_robot.y^2)"));
    pushBall(bench, 2, 6, 8);
    picture(bench, *view);
    QCOMPARE(legendCell(*view, 0, CurveModel::kValue), textOf("10"));
    QCOMPARE(curvesOf(*view).curves().front()->live.size(), std::size_t{2});
    QTest::keyClicks(&field, textOf("sqrt(models/ball.position_in_robot.x"));
    QTest::keyClick(&field, Qt::Key_Return);
    QVERIFY(!field.text().isEmpty());
    QVERIFY(child<QLabel>(*view, "plotsState").text().contains(textOf(")")));
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    QCOMPARE(again->curves(), view->curves());
  }

  void streamsAreJoinedByTheLastValueBefore() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    pushStatus(bench, 0.5, 100);
    pushBall(bench, 1, 1, 0);
    bench.tick(*view);
    QVERIFY(view->addCurve(textOf("= models/ball.position_in_robot.x + motion/status.velocity.x")));
    pushStatus(bench, 1.5, 200);
    pushBall(bench, 2, 2, 0);
    pushStatus(bench, 2, 300);
    bench.tick(*view);
    const auto& points = curvesOf(*view).curves().front()->live;
    std::vector<std::pair<double, double>> all;
    for (std::size_t i = 0; i < points.size(); ++i) all.emplace_back(points[i].time, points[i].value);
    const std::vector<std::pair<double, double>> expected{{1, 101}, {1.5, 201}, {2, 302}};
    QCOMPARE(all, expected);
    // What is misspelled is said, and the curve stays.
    QVERIFY(view->addCurve(textOf("= models/bal.position_in_robot.x")));
    bench.tick(*view);
    QCOMPARE(legendCell(*view, 1, CurveModel::kValue), textOf("missing"));
    QVERIFY(curvesOf(*view).index(1, 0).data(Qt::ToolTipRole).toString().contains(textOf("models/ball")));
  }

  void statesAreStripsWithTheirNames() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>({900, 600});
    for (int i = 0; i < 100; ++i) {
      pushBall(bench, 0.1 * i, std::sin(0.1 * i), 0, i / 25 % 2 == 1);
      pushPlot(bench, 0.1 * i, i % 7);
    }
    bench.tick(*view);
    view->addCurve(textOf(kPlot));
    const QImage without = picture(bench, *view);
    QVERIFY(view->addCurve(textOf("red1/models/ball: known")));
    const QImage with = picture(bench, *view);
    keepPicture(*view, "plot-states");
    const auto& curve = *curvesOf(*view).curves()[1];
    QVERIFY(curve.isStrip());
    QCOMPARE(legendCell(*view, 1, CurveModel::kValue), textOf("true"));
    const QColor base = view->palette().color(QPalette::Base);
    const QColor first = mixed(base, curveColor(curve.names.color(0), view->palette()), 0.4);
    const QColor second = mixed(base, curveColor(curve.names.color(1), view->palette()), 0.4);
    QVERIFY(countNear(without, second, 1) < 50);
    QVERIFY(countNear(with, first, 1) > 1000 && countNear(with, second, 1) > 1000);
    // The values of the other axis are those of the curve alone.
    const auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    QVERIFY(canvas.ranges().values.second > 6 && canvas.ranges().values.second < 7);
    auto& plot = child<QWidget>(*view, "plotCanvas");
    QString tip;
    for (int y = plot.height(); y > 0 && tip.isEmpty(); --y)
      tip = canvas.toolTipAt(QPoint(plot.width() / 2, y));
    QVERIFY2(tip.startsWith(textOf("red1/models/ball: known: ")), qPrintable(tip));
    // It can be a curve, too.
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    legend.setCurrentIndex(legend.model()->index(1, 0));
    child<QAction>(*view, "plotsStripAction").trigger();
    QVERIFY(!curve.isStrip());
    QVERIFY(countNear(picture(bench, *view), first, 1) < 50);
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    picture(bench, *again);
    QVERIFY(!curvesOf(*again).curves()[1]->isStrip());
    TestFolder folder;
    QVERIFY(view->saveTo(QString::fromStdString((folder / "points.csv").string())));
    const auto csv = robotlink::readFile(folder / "points.csv");
    QVERIFY(csv && csv->find("\"false\"") != std::string::npos);
    for (const char* name : {"points.tsv", "points.txt"}) {
      QVERIFY(view->saveTo(QString::fromStdString((folder / name).string())));
      const auto tabs = robotlink::readFile(folder / name);
      QVERIFY(tabs && tabs->starts_with("time_s\t"));
    }
    QVERIFY(!view->saveTo(QString::fromStdString((folder / "points.xyz").string())));
    QVERIFY(!std::filesystem::exists(folder / "points.xyz"));
  }

  void aCurveIsDrawnOverAnotherOne() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>({1100, 600});
    for (int i = 0; i <= 200; ++i) pushBall(bench, 0.05 * i, 2 * std::cos(0.05 * i), std::sin(0.05 * i));
    bench.tick(*view);
    QVERIFY(view->addCurve(textOf("red1/models/ball: position_in_robot.x")));
    QVERIFY(view->addCurve(textOf("red1/models/ball: position_in_robot.y")));
    picture(bench, *view);
    auto& paths = child<QWidget>(*view, "pathCanvas");
    QVERIFY(!paths.isVisible());
    auto& legend = child<QTreeView>(*view, "plotsLegend");
    child<QAction>(*view, "plotsAcrossAction").trigger();
    QVERIFY(!child<QLabel>(*view, "plotsState").text().isEmpty());
    legend.selectAll();
    child<QAction>(*view, "plotsAcrossAction").trigger();
    QCOMPARE(view->curves().last(),
             textOf("red1/models/ball: position_in_robot.y over red1/models/ball: position_in_robot.x"));
    child<QComboBox>(*view, "plotsWindow").setCurrentText(textOf("all"));
    bench.session.timeline().show(robotlink::Instant(robotlink::fromSeconds(5)));
    picture(bench, *view);
    QCoreApplication::processEvents();
    picture(bench, *view);
    QVERIFY(paths.isVisible());
    QCOMPARE(legendCell(*view, 2, CurveModel::kValue).count(QLatin1Char(';')), 1);
    const QColor color = curveColor(2, view->palette());
    const auto extent = [&] {
      const QImage image = paths.grab().toImage();
      QRect all;
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          if (isNear(image.pixelColor(x, y), color, 0)) all |= QRect(x, y, 1, 1);
        }
      }
      return all;
    };
    QVERIFY(extent().width() > 100);
    keepPicture(*view, "plot-paths");
    click(child<QToolButton>(*view, "plotsEqual"));
    for (int i = 0; i < 3; ++i) picture(bench, *view);
    const QRect equal = extent();
    QVERIFY2(std::abs(equal.width() - 2 * equal.height()) < 12,
             qPrintable(textOf("%1 x %2").arg(equal.width()).arg(equal.height())));
    TestFolder folder;
    for (const char* name : {"all.png", "all.svg"}) {
      const auto file = folder / name;
      QVERIFY(view->saveTo(QString::fromStdString(file.string())));
      QVERIFY(std::filesystem::file_size(file) > 3000);
    }
  }

  void theSpectrumOfACurveIsShownAndWritten() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>({900, 700});
    for (int i = 0; i < 1000; ++i)
      pushPlot(bench, 0.01 * i, 5 + 0.5 * std::sin(2 * std::numbers::pi * 4 * 0.01 * i));
    view->addCurve(textOf(kPlot));
    picture(bench, *view);
    TestFolder folder;
    const QString file = QString::fromStdString((folder / "a.spectrum.csv").string());
    QVERIFY(!view->saveTo(file));
    click(child<QToolButton>(*view, "plotsSpectrum"));
    picture(bench, *view);
    picture(bench, *view);
    auto& note = child<QLabel>(*view, "plotsSpectrumNote");
    QVERIFY2(note.text().contains(textOf("largest 0.")) && note.text().contains(textOf(" m at 4")),
             qPrintable(note.text()));
    child<QComboBox>(*view, "plotsSpectrumWindow").setCurrentIndex(4);
    const auto& spectrum = *view->findChild<widgets::SpectrumCanvas*>();
    QVERIFY(std::abs(*std::max_element(spectrum.spectra().front().amplitudes.begin() + 1,
                                       spectrum.spectra().front().amplitudes.end()) -
                     0.5) < 0.01);
    keepPicture(*view, "plot-spectrum");
    QVERIFY(view->saveTo(file));
    const auto csv = robotlink::readFile(file.toStdString());
    QVERIFY(csv && csv->starts_with("frequency_hz,"));
    // Between the cursors, if they are there.
    const std::size_t before = spectrum.spectra().front().amplitudes.size();
    click(child<QToolButton>(*view, "plotsCursors"));
    picture(bench, *view);
    picture(bench, *view);
    QVERIFY(spectrum.spectra().front().amplitudes.size() < before * 3 / 4);
    auto again = bench.open<widgets::PlotsView>();
    again->restoreState(view->saveState());
    QVERIFY(child<QToolButton>(*again, "plotsSpectrum").isChecked());
    QCOMPARE(child<QComboBox>(*again, "plotsSpectrumWindow").currentIndex(), 4);
  }

  void textsThatMatchAreMarked() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    for (int i = 0; i < 100; ++i) pushPlot(bench, 0.1 * i, 0);
    view->addCurve(textOf(kPlot));
    const QColor color = colorOf(Meaning::kWarning, view->palette());
    const int none = countNear(picture(bench, *view), color, 0);
    foxglove::Log log;
    log.set_level(foxglove::Log::WARNING);
    log.set_message("something else");
    bench.push("red1/log", log, 9.4);
    log.set_message("Ball lost");
    bench.push("red1/log", log, 9.5);
    child<QAction>(*view, "plotsMarkAction").trigger();
    auto& dialog = child<QInputDialog>(*view, "plotsMarkDialog");
    dialog.setTextValue(textOf("ball (lost|found)"));
    dialog.accept();
    picture(bench, *view);  // looks for them, and draws them with the next one
    QVERIFY(countNear(picture(bench, *view), color, 0) > none + 20);
    const auto& marks = TimeMarks::of(openLogs(bench.context)).texts();
    QCOMPARE(marks.size(), std::size_t{1});
    const auto& canvas = *view->findChild<widgets::PlotCanvas*>();
    const auto [from, to] = canvas.shownTimes();
    QVERIFY(from < 9.5 && to > 9.5);
    QString found;
    auto& plot = child<QWidget>(*view, "plotCanvas");
    for (int x = 0; x < plot.width(); ++x) {
      const QString tip = canvas.toolTipAt(QPoint(x, plot.height() / 2));
      if (!tip.isEmpty()) found = tip;
    }
    QCOMPARE(found, textOf("Ball lost"));
    auto& set = TimeMarks::of(openLogs(bench.context));
    QVERIFY(!set.setPattern(textOf("(")).isEmpty());
    QCOMPARE(set.pattern(), textOf("ball (lost|found)"));
    QCOMPARE(set.setPattern({}), QString());
    QCOMPARE(countNear(picture(bench, *view), color, 0), none);
    log.set_name("world");
    log.set_message("The world was rewound.");
    bench.push("red1/log", log, 9.6);
    picture(bench, *view);
    QCOMPARE(set.texts().size(), std::size_t{1});  // marked whatever the pattern is
    QCOMPARE(set.texts().front().text, textOf("The world was rewound."));
  }

  void whatIsNotPublishedIsListedInGray() {
    Bench bench;
    auto view = bench.open<widgets::PlotsView>();
    robotcontrol::KeyTable table;
    auto& off = *table.add_keys();
    off.set_name("ball-model/speed");
    off.set_stream("plots/ball-model/speed");
    off.set_in_use(true);
    table.add_keys()->set_name("package/models/ball");
    table.mutable_keys(1)->set_stream("models/ball");
    bench.push("red1/tables/keys", table, 1);
    robotcontrol::ProcessTable processes;
    auto& port = *processes.add_processes()->add_senders();
    port.set_package("models/ball");
    port.set_type("robotcontrol.BallModel");
    bench.push("red1/tables/processes", processes, 1);
    pushPlot(bench, 1, 2);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "plotsTree");
    tree.expandAll();
    const QColor muted = colorOf(Meaning::kMuted, view->palette());
    const auto colorOfRow = [&](const char* name) {
      const QModelIndex index = find(tree, textOf(name));
      return index.isValid() ? index.data(Qt::ForegroundRole).value<QBrush>().color() : QColor();
    };
    QCOMPARE(colorOfRow("speed"), muted);
    QCOMPARE(colorOfRow("position_in_robot.x"), muted);
    QVERIFY(colorOfRow("x") != muted);
    // Adding it asks for its key, and what was unfolded stays so when the list changes.
    const QModelIndex leaf = find(tree, textOf("speed"));
    tree.collapseAll();
    for (QModelIndex parent = leaf.parent(); parent.isValid(); parent = parent.parent()) tree.expand(parent);
    tree.setCurrentIndex(leaf);
    click(child<QToolButton>(*view, "plotsAdd"));
    QCOMPARE(view->curves().front(), textOf("red1/plots/ball-model/speed"));
    QVERIFY(!bench.requests.empty());
    QCOMPARE(bench.requests.back().set_key().name(), std::string("ball-model/speed"));
    QCOMPARE(legendCell(*view, 0, CurveModel::kValue), textOf("missing"));
    robotcontrol::PlotValue speed;
    speed.set_value(0.5);
    bench.push("red1/plots/ball-model/speed", speed, 2);
    bench.tick(*view);
    QVERIFY(tree.isExpanded(find(tree, textOf("speed")).parent()));
    QVERIFY(colorOfRow("speed") != muted);
    bench.tick(*view);
    QCOMPARE(legendCell(*view, 0, CurveModel::kValue), textOf("0.5"));
  }
};

const GuiTest<PlotsSourcesTest> kPlotsSourcesTest;

}  // namespace widgets::test

#include "PlotsSourcesTest.moc"
