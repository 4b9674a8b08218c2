// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plots/SeriesGraph.h"

#include <QTest>
#include <cmath>

#include "tests/widgets/Bench.h"

namespace widgets::test {
namespace {

using robotlink::Series;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const QColor kInk(Qt::blue);

/// A plot of 400 x 300 pixels without labels.
struct GraphPlot : QCustomPlot {
  GraphPlot() {
    resize(400, 300);
    setNotAntialiasedElements(QCP::aeAll);
    for (QCPAxis* axis : {xAxis, yAxis}) axis->setVisible(false);
    yAxis->setRange(-2, 2);
    xAxis->setRange(0, 10);
  }
  int ink() { return countNear(toPixmap().toImage(), kInk, 0); }
  /// Number of columns of pixels with anything drawn.
  int columns() {
    const QImage image = toPixmap().toImage();
    int count = 0;
    for (int x = 0; x < image.width(); ++x)
      count += countNear(image.copy(x, 0, 1, image.height()), kInk, 0) > 0;
    return count;
  }
};

std::shared_ptr<Series> seriesOf(int count, double (*value)(double)) {
  auto series = std::make_shared<Series>();
  for (int i = 0; i <= count; ++i) {
    const double time = 10.0 * i / count;
    series->append({time, value(time)});
  }
  return series;
}

double wave(double time) {
  return std::sin(time * 3) + 0.4 * std::sin(time * 977);
}

}  // namespace

class SeriesGraphTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void manyPointsLookAsIfAllWereDrawn() {
    for (const QCPRange seen : {QCPRange(0, 10), QCPRange(2.5, 6.1)}) {
      const auto series = seriesOf(50'000, wave);
      GraphPlot ours, plain;
      auto* graph = new SeriesGraph(ours.xAxis, ours.yAxis);
      graph->setSeries(series);
      QCPGraph* all = plain.addGraph();
      all->setAdaptiveSampling(false);
      for (std::size_t i = 0; i < series->size(); ++i) all->addData((*series)[i].time, (*series)[i].value);
      for (GraphPlot* plot : {&ours, &plain}) {
        plot->xAxis->setRange(seen);
        plot->plottable(0)->setPen(QPen(kInk, 1));
      }
      const QImage a = ours.toPixmap().toImage(), b = plain.toPixmap().toImage();
      int differing = 0;
      for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) differing += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
      }
      QVERIFY(plain.ink() > 10'000);
      QVERIFY2(differing < plain.ink() / 20,
               qPrintable(QStringLiteral("%1 of %2").arg(differing).arg(plain.ink())));
    }
  }

  void aLineReachesAcrossColumnsWithoutPoints() {
    GraphPlot plot;
    auto* graph = new SeriesGraph(plot.xAxis, plot.yAxis);
    graph->setPen(QPen(kInk, 1));
    // Nearly all points are in the middle.
    auto series = std::make_shared<Series>();
    series->append({-5, 1});
    for (int i = 0; i < 2000; ++i) series->append({4.5 + i * 5e-4, std::sin(i * 0.1)});
    series->append({15, -1});
    graph->setSeries(series);
    const int all = plot.columns();
    QVERIFY2(all >= plot.axisRect()->width() - 2, qPrintable(QString::number(all)));
    graph->setGaps(
        {{robotlink::Instant(robotlink::fromSeconds(6)), robotlink::Instant(robotlink::fromSeconds(14))}});
    const int before = plot.columns();
    QVERIFY2(before < all * 3 / 4 && before > all / 2, qPrintable(QString::number(before)));
  }

  void theLineIsInterruptedWhereThereIsNoNumber() {
    GraphPlot plot;
    auto* graph = new SeriesGraph(plot.xAxis, plot.yAxis);
    graph->setPen(QPen(kInk, 1));
    for (const int count : {100, 20'000}) {
      graph->setSeries(seriesOf(count, [](double time) { return time > 3 && time < 7 ? kNaN : 1.0; }));
      const int some = plot.columns();
      graph->setSeries(seriesOf(count, [](double) { return 1.0; }));
      const int all = plot.columns();
      QVERIFY2(some < all * 7 / 10 && some > all / 2, qPrintable(QStringLiteral("%1 %2").arg(some).arg(all)));
    }
  }

  void whatIsOutsideOfTheAxesIsNotDrawn() {
    GraphPlot plot;
    auto* graph = new SeriesGraph(plot.xAxis, plot.yAxis);
    graph->setPen(QPen(kInk, 1));
    for (const double height : {1e300, -1e300}) {
      auto series = std::make_shared<Series>();
      for (int i = 0; i < 20'000; ++i) series->append({i * 5e-4, height});
      graph->setSeries(series);
      QCOMPARE(plot.ink(), 0);
    }
    graph->setSeries(nullptr);
    QCOMPARE(plot.ink(), 0);
  }
};

const GuiTest<SeriesGraphTest> kSeriesGraphTest;

}  // namespace widgets::test

#include "SeriesGraphTest.moc"
