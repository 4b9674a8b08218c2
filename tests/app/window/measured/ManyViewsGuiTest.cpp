// SPDX-License-Identifier: GPL-3.0-or-later
// What a window full of views costs: how often they are painted, how long the window does not answer, how
// fast the simulation is beside them, and whether memory stays flat. tests/README.md says how to run it for
// an hour.
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "app/robotcontrol/bars/StallWatch.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/series/Series.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/app/window/measured/MachineLoad.h"
#include "widgets/plots/PlotsView.h"

namespace app::test {
namespace {

using namespace std::chrono_literals;

constexpr int kFastPlots = 4, kManyImages = 8;

/// Publishes a value on each of its streams for each millisecond of real time, at times spread over what the
/// simulation has made of it.
class FastPlots final : public QObject {
 public:
  explicit FastPlots(robotlink::Session& session) : session_(session), last_(session.timeline().newest()) {
    clock_.start();
    startTimer(10, Qt::PreciseTimer);
  }
  static std::string path(int plot) { return "red1/plots/fast/" + std::to_string(plot); }
  /// What each stream got.
  qint64 samples() const { return samples_; }

 protected:
  void timerEvent(QTimerEvent*) override {
    const robotlink::Instant newest = session_.timeline().newest();
    const qint64 count = clock_.elapsed() - samples_;
    if (newest <= last_ || count <= 0) return;
    for (qint64 i = 1; i <= count; ++i) {
      for (int plot = 0; plot < kFastPlots; ++plot) {
        auto value = std::make_shared<robotcontrol::PlotValue>();
        value->set_value(plot + std::sin(0.01 * (plot + 1) * static_cast<double>(samples_ + i)));
        session_.push({path(plot), last_ + (newest - last_) * i / count, std::move(value)});
      }
    }
    samples_ += count;
    last_ = newest;
  }

 private:
  robotlink::Session& session_;
  robotlink::Instant last_;
  QElapsedTimer clock_;
  qint64 samples_ = 0;
};

/// Counts how often widgets are painted.
class PaintCounter final : public QObject {
 public:
  void watch(const QList<QWidget*>& canvases) {
    for (QWidget* canvas : canvases) {
      canvas->installEventFilter(this);
      counts_[canvas] = 0;
    }
  }
  bool isOn = false;
  /// How often the one was painted that was painted least of those with this name.
  int least(const char* name) const {
    int least = std::numeric_limits<int>::max();
    for (const auto& [canvas, count] : counts_) {
      if (canvas->objectName() == QLatin1String(name)) least = std::min(least, count);
    }
    return least;
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (isOn && event->type() == QEvent::Paint) ++counts_[watched];
    return false;
  }

 private:
  std::map<QObject*, int> counts_;
};

/// The mean of the speeds that the simulation reports of itself, times real time.
struct MeanSpeed {
  double sum = 0;
  int count = 0;
  double value() const { return count > 0 ? sum / count : 0; }
};

/// What was measured of a desk, in rounds: its window is shown for a while, and hidden for a while. So both
/// find the same simulation on the same machine.
class DeskFigures {
 public:
  explicit DeskFigures(Desk& desk) : desk_(desk), watch_(&desk.window, nullptr) {
    for (const char* name : {"imageCanvas", "plotCanvas", "sceneCanvas"})
      paints.watch(desk.window.findChildren<QWidget*>(QLatin1String(name)));
    listener_ = desk.workbench.session().addListener(
        {.message = [this](const robotlink::StreamMessage& message) { note(message); }});
  }
  ~DeskFigures() { desk_.workbench.session().removeListener(listener_); }

  void round() {
    desk_.window.show();
    letRun(kSettle);
    watch_.reset();
    paints.isOn = true;
    current_ = &shown;
    const MachineLoad load;
    const double cpu = cpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    letRun(kShown);
    guiSeconds += cpuSeconds(CLOCK_THREAD_CPUTIME_ID) - cpu;
    seconds += load.seconds();
    processSeconds += load.own();
    paints.isOn = false;
    current_ = nullptr;
    worst = std::max(worst, watch_.stalls().longestCpu);
    desk_.window.hide();
    letRun(kSettle);
    current_ = &hidden;
    letRun(kHidden);
    current_ = nullptr;
  }

  PaintCounter paints;
  MeanSpeed shown, hidden;
  std::chrono::microseconds worst{0};
  /// While the window was shown: real time, and the processor time of its thread and of all threads.
  double seconds = 0, guiSeconds = 0, processSeconds = 0;

 private:
  static constexpr auto kSettle = 500ms, kShown = 3000ms, kHidden = 2000ms;

  void note(const robotlink::StreamMessage& message) {
    if (current_ == nullptr || message.path != robotlink::streams::kSimulation) return;
    const auto* status = dynamic_cast<const robotcontrol::SimulationStatus*>(message.value.get());
    if (status == nullptr) return;
    current_->sum += status->speed();
    ++current_->count;
  }

  Desk& desk_;
  StallWatch watch_;
  std::uint64_t listener_ = 0;
  MeanSpeed* current_ = nullptr;
};

}  // namespace

class ManyViewsGuiTest : public WindowTest {
  Q_OBJECT
 private:
  static constexpr double kMinSpeed = 0.9;   // times that with a hidden window
  static constexpr double kMinFrames = 0.9;  // times what the window's ticks, and the limit of plots, make
  static constexpr double kPlotsPerSecond = 25;
  static constexpr double kMaxGrowthMib = 20;
  static constexpr int kHistoryMib = 64, kDiskMib = 256;

  /// How long it is measured, in s.
  static double wantedSeconds() {
    bool isNumber = false;
    const double seconds = qEnvironmentVariable("ROBOTCONTROL_SOAK_SECONDS").toDouble(&isNumber);
    return isNumber ? seconds : 20;
  }
  static void run(Desk& desk, const std::string& line) {
    if (const auto done = desk.workbench.commands().runLine(line); !done)
      qFatal("%s: %s", line.c_str(), done.error().describe().c_str());
  }
  /// The scene, and beside it four columns of two images and a plot.
  static void openViews(Desk& desk) {
    using enum ViewDocks::Place;
    const QString image = QStringLiteral("image");
    ViewDocks& docks = desk.window.docks();
    docks.closeAll();
    docks.add(QStringLiteral("scene"), kLeft);
    for (int column = 0; column < kFastPlots; ++column) {
      ads::CDockWidget* upper = docks.add(image, kRight);
      docks.add(QStringLiteral("plots"), kBottom, docks.add(image, kBottom, upper));
    }
    const auto plots = desk.window.findChildren<widgets::PlotsView*>();
    QCOMPARE(plots.size(), kFastPlots);
    for (int plot = 0; plot < kFastPlots; ++plot) {
      plots[plot]->restoreState(
          {{QStringLiteral("curves"), QJsonArray{QString::fromStdString(FastPlots::path(plot))}},
           {QStringLiteral("window"), 60},
           {QStringLiteral("tree"), false}});
    }
  }
  static bool areVisible(Desk& desk, const char* canvas, int count) {
    const auto all = desk.window.findChildren<QWidget*>(QLatin1String(canvas));
    return all.size() == count && std::ranges::all_of(all, [](const QWidget* each) {
             return each->isVisible() && each->width() >= 100 && each->height() >= 50;
           });
  }
  static void print(const DeskFigures& figures, const MachineLoad& load) {
    const double images = figures.paints.least("imageCanvas");
    std::printf(
        "views shown for %.1f s: images %.1f, plots %.1f, scene %.1f frames a second\n"
        "window: %.1f ms of processor time a frame, %.1f ms at worst; %.2f cores with all threads\n"
        "simulation: %.2f times real time with views, %.2f without, ratio %.3f; others used %.2f cores\n",
        figures.seconds, images / figures.seconds, figures.paints.least("plotCanvas") / figures.seconds,
        figures.paints.least("sceneCanvas") / figures.seconds, 1e3 * figures.guiSeconds / images,
        1e-3 * static_cast<double>(figures.worst.count()), figures.processSeconds / figures.seconds,
        figures.shown.value(), figures.hidden.value(), figures.shown.value() / figures.hidden.value(),
        load.others());
    std::fflush(stdout);
  }
  /// What says something only of a machine that does nothing else.
  static void checkTimes(const DeskFigures& figures) {
    const double images = figures.paints.least("imageCanvas") / figures.seconds;
    QVERIFY2(images >= kMinFrames * 1000 / kWindowTickMs, "images are painted too seldom");
    const double plots = figures.paints.least("plotCanvas") / figures.seconds;
    QVERIFY2(plots >= kMinFrames * kPlotsPerSecond, "plots are painted too seldom");
    QVERIFY2(figures.shown.value() >= kMinSpeed * figures.hidden.value(), "views slow the simulation down");
  }

 private Q_SLOTS:
  void eightImagesFourPlotsAndTheSceneArePaintedInTime() {
    useTwoCores();
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    for (const char* line : {"simulation.speed 0", "simulation.start"}) run(desk, line);
    run(desk, "timeline.memory " + std::to_string(kHistoryMib));
    run(desk, "timeline.disk " + std::to_string(kDiskMib));
    auto& store = desk.workbench.session().store();
    const FastPlots feed(desk.workbench.session());
    QTRY_VERIFY_WITH_TIMEOUT(store.find(FastPlots::path(kFastPlots - 1)) != nullptr, kWaitMs);
    openViews(desk);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "imageCanvas", kManyImages), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "plotCanvas", kFastPlots), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "sceneCanvas", 1), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(store.bytes() >= std::size_t{kHistoryMib - 8} << 20U, 10 * kWaitMs);

    DeskFigures figures(desk);
    const double wanted = wantedSeconds();
    const MachineLoad load;
    double before = 0, kept = 0;
    // Plots keep their points as long as they are open, within a limit of their own.
    const auto keptMib = [&feed] {
      return static_cast<double>(feed.samples() * kFastPlots) * robotlink::Series::kBytesPerPoint /
             (1U << 20U);
    };
    while (load.seconds() < wanted || before == 0) {
      figures.round();
      if (before > 0 || load.seconds() < std::min(60.0, wanted / 3)) continue;
      before = residentMib();
      kept = keptMib();
    }
    const double after = residentMib(), growth = after - before - (keptMib() - kept);
    print(figures, load);
    std::printf("memory: %.0f MiB, %.1f MiB more than at first, of which %.1f MiB are points of plots\n",
                after, after - before, keptMib() - kept);
    std::fflush(stdout);

    QVERIFY2(growth <= kMaxGrowthMib, "memory grows");
    QVERIFY2(figures.worst <= StallWatch::kLimit, "the window did not answer for too long");
    const int frames = figures.paints.least("imageCanvas");
    QVERIFY(frames > 0);
    QVERIFY2(1e3 * figures.guiSeconds / frames < kWindowTickMs,
             "frames cost more than the time between them");
    if (load.isQuiet()) checkTimes(figures);
  }
};

const widgets::test::GuiTest<ManyViewsGuiTest> kManyViewsGuiTest;

}  // namespace app::test

#include "ManyViewsGuiTest.moc"
