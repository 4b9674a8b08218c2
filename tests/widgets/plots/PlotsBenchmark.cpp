// SPDX-License-Identifier: GPL-3.0-or-later
// How long a plot of many points takes to be drawn (offscreen, 1600 x 500), beside QCustomPlot's own graphs
// of the same points in the same run, and what live curves cost. Run it with QT_QPA_PLATFORM=offscreen.
#include <benchmark/benchmark.h>
#include <qcustomplot.h>

#include <QApplication>
#include <QHBoxLayout>
#include <cmath>

#include "widgets/plots/CurveModel.h"
#include "widgets/plots/PlotCanvas.h"

namespace {

constexpr std::size_t kCurves = 10, kPoints = 1'000'000;
constexpr double kInterval = 1e-3;  // s
constexpr double kLength = kInterval * kPoints;
constexpr int kWidth = 1600, kHeight = 500;

double valueAt(std::size_t curve, std::size_t i) {
  const double time = static_cast<double>(i) * kInterval;
  return std::sin(time * 0.05 * static_cast<double>(curve + 1)) + static_cast<double>(curve) +
         2e-4 * static_cast<double>((i + curve) * 2'654'435'761U % 1000U);
}

/// A canvas with the curves, and a plain QCustomPlot with them.
struct Plots {
  Plots() {
    for (std::size_t c = 0; c < kCurves; ++c) {
      curves.add({"red1/plots/" + std::to_string(c), {}, {}});
      QVector<double> times, values;
      for (std::size_t i = 0; i < kPoints; ++i) {
        times << static_cast<double>(i) * kInterval;
        values << valueAt(c, i);
        curves.curves().back()->live.append({times.back(), values.back()});
      }
      plain.addGraph()->setData(times, values, true);
    }
    canvas.resize(kWidth, kHeight);
    canvas.show();
    plain.resize(kWidth, kHeight);
    plain.setNotAntialiasedElements(QCP::aeAll);
    plain.yAxis->setRange(-2, kCurves + 2);
    plain.show();
    canvas.refresh(true, kLength, kLength);
    QCoreApplication::processEvents();
  }

  widgets::CurveModel curves;
  widgets::PlotCanvas canvas{curves};
  QCustomPlot plain;
};

Plots& plots() {
  static int count = 1;
  static char name[] = "plots", *arguments[] = {name, nullptr};
  static QApplication application(count, arguments);
  static Plots kPlots;
  return kPlots;
}

void redraw(benchmark::State& state, QCustomPlot& plot) {
  // The argument is the share of the time that is seen, in thousandths.
  const double length = kLength * static_cast<double>(state.range(0)) / 1000;
  plot.xAxis->setRange(kLength - length, kLength);
  for (auto unused : state) {
    static_cast<void>(unused);
    plot.replot(QCustomPlot::rpImmediateRefresh);
  }
}

void plainGraphs(benchmark::State& state) {
  redraw(state, plots().plain);
}
BENCHMARK(plainGraphs)->Arg(1000)->Arg(10)->Arg(1)->Unit(benchmark::kMillisecond);

void ourCanvas(benchmark::State& state) {
  redraw(state, *plots().canvas.findChild<QCustomPlot*>());
}
BENCHMARK(ourCanvas)->Arg(1000)->Arg(10)->Arg(1)->Unit(benchmark::kMillisecond);

/// Twenty curves at 1 kHz, of which 20 s are seen, drawn at 30 Hz: "core" is the share of a processor.
void live(benchmark::State& state) {
  constexpr std::size_t kLive = 20;
  constexpr std::size_t kNew = 33;
  constexpr double kSeen = 20, kPeriod = 0.033;  // s
  plots();
  widgets::CurveModel curves;
  for (std::size_t c = 0; c < kLive; ++c) curves.add({"red1/plots/" + std::to_string(c), {}, {}});
  widgets::PlotCanvas canvas(curves);
  canvas.resize(kWidth, kHeight);
  canvas.show();
  auto& plot = *canvas.findChild<QCustomPlot*>();
  std::size_t next = 0;
  const auto advance = [&](std::size_t points) {
    for (std::size_t c = 0; c < kLive; ++c) {
      for (std::size_t i = next; i < next + points; ++i)
        curves.curves()[c]->live.append({static_cast<double>(i) * kInterval, valueAt(c, i)});
    }
    next += points;
    canvas.refresh(true, static_cast<double>(next) * kInterval, kSeen);
    plot.replot(QCustomPlot::rpImmediateRefresh);
  };
  advance(static_cast<std::size_t>(kSeen / kInterval));
  const auto begin = state.iterations();
  for (auto unused : state) {
    static_cast<void>(unused);
    advance(kNew);
  }
  state.counters["core"] = benchmark::Counter(static_cast<double>(state.iterations() - begin) * kPeriod,
                                              benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(live)->Unit(benchmark::kMillisecond);

}  // namespace
