// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/ColumnsView.h"

#include <QComboBox>
#include <QImage>
#include <QLabel>
#include <QPainter>
#include <cmath>

#include "foxglove/Ranging.pb.h"
#include "tests/widgets/objects/ObjectsBench.h"

namespace widgets::test {

class ColumnsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aSensorOfTheSceneIsReadAndShown() {
    ObjectsBench bench;
    auto view = bench.open<ColumnsView>();
    QVERIFY(view->showSource("red1/laser"));
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t(1));
    QCOMPARE(bench.requests.back().read_ports().ports(0), std::string("red1/laser"));
    bench.publishReadings(0);
    bench.tick(*view);
    const auto& canvas = child<ColumnsCanvas>(*view, "columnsCanvas");
    QCOMPARE(canvas.graph().values, (std::vector<double>{1, 2, 4, 8}));
    QCOMPARE(canvas.graph().high, 8.0);
    keepPicture(*view, "columns");
  }

  void aSensorThatTheSceneDoesNotHaveIsNamed() {
    ObjectsBench bench;
    auto view = bench.open<ColumnsView>();
    const auto refused = view->showSource("red1/lasr");
    QVERIFY(!refused);
    QCOMPARE(refused.error().text,
             std::string("there is no sensor red1/lasr in this scene; did you mean 'red1/laser'?"));
    QVERIFY(view->showSource("red1/laser"));
    for (auto& object : *bench.objects.mutable_objects())
      if (object.path() == "red1/laser") object.mutable_port()->set_path("red1/other");
    bench.push("objects", bench.objects, 2);
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "emptyHint").text(),
             QStringLiteral("There is no sensor red1/laser in this scene. Choose another one above."));
  }

  void aListOfAnyStreamIsShown() {
    Bench bench;
    foxglove::LaserScan scan;
    for (const double range : {3.0, 2.0}) scan.add_ranges(range);
    bench.push("red1/range/laser", scan, 1);
    auto view = bench.open<ColumnsView>();
    QVERIFY(view->showSource("range/laser: ranges"));
    bench.tick(*view);
    QCOMPARE(child<ColumnsCanvas>(*view, "columnsCanvas").graph().values, (std::vector<double>{3, 2}));
    QCOMPARE(*view->numbers(), QStringLiteral("index\tvalue\n0\t3\n1\t2\n"));
  }

  void theValueUnderTheCursorIsShown() {
    ObjectsBench bench;
    auto view = bench.open<ColumnsView>();
    QVERIFY(view->showSource("red1/laser"));
    bench.publishReadings(0);
    bench.tick(*view);
    auto& canvas = child<ColumnsCanvas>(*view, "columnsCanvas");
    moveMouse(canvas, {canvas.width() - 20, canvas.height() / 2});
    QVERIFY(child<QLabel>(*view, "columnsValue").text().startsWith(QStringLiteral("[3]")));
    canvas.setFocus();
    QTest::keyClick(&canvas, Qt::Key_Left);
    QVERIFY(child<QLabel>(*view, "columnsValue").text().startsWith(QStringLiteral("[2]")));
  }

  void theSourceComesBackWithThePerspective() {
    ObjectsBench bench;
    auto view = bench.open<ColumnsView>();
    QVERIFY(view->showSource("red1/laser"));
    bench.requests.clear();
    ColumnsView other(bench.context);
    other.restoreState(view->saveState());
    QCOMPARE(child<QComboBox>(other, "columnsSource").currentText(), QStringLiteral("red1/laser"));
    other.tick();
    QCOMPARE(bench.requests.size(), std::size_t(1));  // the simulation is asked for it again
  }

  void withoutValuesThereIsNoAxisBehindTheHint() {
    QImage picture(200, 100, QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    paintColumns(painter, picture.size(), {}, QPalette());
    painter.end();
    for (int y = 0; y < picture.height(); y += 2)
      QCOMPARE(picture.pixelColor(120, y), picture.pixelColor(120, 50));
  }

  void columnsReachFromZeroToTheirValue() {
    ColumnGraph graph;
    graph.values = {-1, 3, std::nan("")};
    graph.fit(0, 0);
    QCOMPARE(graph.low, -1.0);
    QCOMPARE(graph.high, 3.0);
    graph.fit(-2, 2);
    QCOMPARE(graph.low, -1.0);
    QCOMPARE(graph.high, 2.0);
  }

  void theAxisFitsTheValuesWithinTheRangeOfTheSensor() {
    ColumnGraph graph;
    graph.values = {0.4, 5.7, 2.2};
    graph.fit(0.1, 32);
    QCOMPARE(graph.low, 0.0);
    QCOMPARE(graph.high, 6.0);
    graph.values = {31.5};
    graph.fit(0.1, 32);
    QCOMPARE(graph.high, 32.0);
    graph.values = {};
    graph.fit(0.1, 32);
    QCOMPARE(graph.high, 32.0);
  }

  void theAxisGrowsAtOnceAndShrinksLater() {
    SteadyLimits limits;
    const auto shown = [&](double value) {
      ColumnGraph graph;
      graph.values = {value};
      graph.fit(0, 32);
      limits.apply(graph);
      return graph.high;
    };
    QCOMPARE(shown(2), 2.0);
    QCOMPARE(shown(9), 10.0);
    for (int i = 0; i < SteadyLimits::kPatience / 2; ++i) QCOMPARE(shown(3), 10.0);
    double last = 10;
    for (int i = 0; i < 2 * SteadyLimits::kPatience; ++i) last = shown(3);
    QCOMPARE(last, 3.0);
    QCOMPARE(shown(20), 20.0);
  }
};

const GuiTest<ColumnsViewTest> kColumnsViewTest;

}  // namespace widgets::test

#include "ColumnsViewTest.moc"
