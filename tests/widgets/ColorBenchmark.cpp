// SPDX-License-Identifier: GPL-3.0-or-later
// What a person waits for: from a stroke to the new table, and to the new picture on the screen (offscreen,
// 1280 x 960). Run it with QT_QPA_PLATFORM=offscreen.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QMouseEvent>
#include <chrono>

#include "tests/widgets/CameraBench.h"
#include "widgets/color/image/ColorCanvas.h"
#include "widgets/color/image/ColorImageView.h"

namespace {

using widgets::ColorBench;
using widgets::ColorCanvas;
using widgets::test::CameraBench;
using Clock = std::chrono::steady_clock;

constexpr int kWidth = 1280, kHeight = 960;

/// Tells when a widget was painted last.
class PaintClock final : public QObject {
 public:
  explicit PaintClock(QWidget& of) { of.installEventFilter(this); }
  bool eventFilter(QObject*, QEvent* event) override {
    painted = painted || event->type() == QEvent::Paint;
    return false;
  }
  bool painted = false;
};

/// The view with strokes in it, as in the middle of the work.
struct Desk {
  CameraBench world;
  ColorBench& bench{colorBench(world.context)};
  widgets::ColorImageView view{world.context};
  ColorCanvas& left = *widgets::test::child<ColorCanvas>(view, "colorLeft");
  ColorCanvas& right = *widgets::test::child<ColorCanvas>(view, "colorRight");

  explicit Desk(int strokes) {
    world.show(kWidth, kHeight);
    view.resize(1180, 560);
    view.show();
    view.tick();
    for (int i = 0; i < strokes; ++i) {
      bench.setCurrentClass(i % 9);
      const colortool::ImagePoint at[] = {{20.0 + i * 37 % (kWidth - 40), 20.0 + i * 53 % (kHeight - 40)}};
      bench.addStroke(colortool::brushArea(kWidth, kHeight, at, 3), "brush");
    }
    settle();
  }
  void settle() {
    while (!bench.upToDate()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    while (bench.quality() == nullptr || bench.quality()->task != bench.colors()->task)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }
};

/// A click of the mouse until the segmented image of the new table was painted.
void fromStrokeToScreen(benchmark::State& state) {
  Desk desk(static_cast<int>(state.range(0)));
  PaintClock paints(desk.right);
  int x = 60;
  desk.bench.setCurrentClass(1);
  double worst = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    x = 60 + (x * 7 + 13) % 300;
    const QPoint at(x, 200);
    const auto begin = Clock::now();
    QMouseEvent press(QEvent::MouseButtonPress, at, Qt::LeftButton, Qt::LeftButton, {});
    QApplication::sendEvent(&desk.left, &press);
    while (!desk.bench.upToDate()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    paints.painted = false;
    desk.right.update();
    while (!paints.painted) QCoreApplication::processEvents();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    state.SetIterationTime(seconds);
    worst = std::max(worst, seconds);
    QMouseEvent release(QEvent::MouseButtonRelease, at, Qt::LeftButton, {}, {});
    QApplication::sendEvent(&desk.left, &release);
    desk.settle();
  }
  state.counters["worst_ms"] = worst * 1e3;
}
BENCHMARK(fromStrokeToScreen)
    ->Arg(12)
    ->Arg(100)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(60);

/// An option that changes everything, until its picture was painted.
void fromOptionToScreen(benchmark::State& state) {
  Desk desk(static_cast<int>(state.range(0)));
  PaintClock paints(desk.right);
  double radius = 8;
  for (auto unused : state) {
    static_cast<void>(unused);
    radius = radius < 11 ? radius + 0.25 : 6;
    const auto begin = Clock::now();
    colortool::Samples next = desk.bench.samples();
    next.settings.votes.radius = radius;
    desk.bench.change(QStringLiteral("radius"), std::move(next), "radius");
    while (!desk.bench.upToDate()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    paints.painted = false;
    desk.right.update();
    while (!paints.painted) QCoreApplication::processEvents();
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    desk.settle();
  }
}
BENCHMARK(fromOptionToScreen)
    ->Arg(12)
    ->Arg(100)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(40);

}  // namespace
