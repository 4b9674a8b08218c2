// SPDX-License-Identifier: GPL-3.0-or-later
// What a window full of views costs: how often they are painted, how long the window does not answer, how
// fast the simulation is beside them, and whether memory stays flat. tests/README.md says how to run it for
// an hour.
#include <QJsonArray>
#include <QJsonObject>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>

#include "app/robotcontrol/bars/StallWatch.h"
#include "robotcontrol/Debugging.pb.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/app/window/measured/MachineLoad.h"
#include "widgets/plots/PlotsView.h"

namespace app::test {
namespace {

using namespace std::chrono_literals;

constexpr int kFastPlots = 4, kManyImages = 8;

/// How far the simulation is, by what the robot publishes in each frame: what others publish does not count.
robotlink::Instant simulatedUntil(robotlink::Session& session) {
  const auto* image = session.store().latest("red1/camera/image", robotlink::Instant::max());
  return image != nullptr ? image->time : robotlink::Instant();
}

/// Publishes a value on each of its streams for each millisecond of real time, at times spread over what the
/// simulation has made of it.
class FastPlots final : public QObject {
 public:
  explicit FastPlots(robotlink::Session& session) : session_(session), last_(simulatedUntil(session)) {
    clock_.start();
    startTimer(10, Qt::PreciseTimer);
  }
  static std::string path(int plot) { return "red1/plots/fast/" + std::to_string(plot); }

 protected:
  void timerEvent(QTimerEvent*) override {
    const robotlink::Instant newest = simulatedUntil(session_);
    if (newest < last_) last_ = newest;  // a reset
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

/// Counts how often widgets are painted while it is on, in rounds: views are others in each of them.
class PaintCounter final : public QObject {
 public:
  void begin(const QMainWindow& window) {
    for (const char* name : {"imageCanvas", "plotCanvas", "sceneCanvas"}) {
      for (QWidget* canvas : window.findChildren<QWidget*>(QLatin1String(name))) {
        canvas->installEventFilter(this);
        counts_[canvas] = 0;
      }
    }
    isOn_ = true;
  }
  /// Adds what was painted least of those with each name.
  void end() {
    isOn_ = false;
    std::map<QString, int> least;
    for (const auto& [canvas, count] : counts_) {
      canvas->removeEventFilter(this);
      const auto known = least.try_emplace(canvas->objectName(), count).first;
      known->second = std::min(known->second, count);
    }
    for (const auto& [name, count] : least) sums_[name] += count;
    counts_.clear();
  }
  /// How often the one was painted that was painted least of those with this name, over all rounds.
  int least(const char* name) const {
    const auto found = sums_.find(QLatin1String(name));
    return found == sums_.end() ? 0 : found->second;
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (isOn_ && event->type() == QEvent::Paint) ++counts_[watched];
    return false;
  }

 private:
  std::map<QObject*, int> counts_;
  std::map<QString, int> sums_;
  bool isOn_ = false;
};

/// How far a simulation came in a time, times real time. It is not the mean of the speeds that it reports:
/// in that each report counts the same, whether it is about a long or a short time.
struct SpeedOverTime {
  double simulated = 0, real = 0;  ///< s
  double value() const { return real > 0 ? simulated / real : 0; }
};

/// Waits until the simulation was reset and has come so far, in s; returns how far it is.
double resetAndRun(Desk& desk, double seconds) {
  const auto simulated = [&] {
    return robotlink::seconds(simulatedUntil(desk.workbench.session()).time_since_epoch());
  };
  // That the time goes back can be seen only if it does so by more than what is simulated meanwhile.
  constexpr double kFar = 10;
  while (simulated() < kFar) letRun(20ms);
  const double before = simulated();
  if (const auto done = desk.workbench.commands().runLine("simulation.reset"); !done)
    qFatal("%s", done.error().describe().c_str());
  while (simulated() >= before) letRun(5ms);
  while (simulated() < seconds) letRun(5ms);
  return simulated();
}

/// What was measured of a desk: its window is shown with all views for a while, and with none for a while. So
/// both find the same machine, in the same window. What the views had published goes on being published
/// without them.
class DeskFigures {
 public:
  /// `openViews` opens the views; they are closed at the end of each measurement.
  DeskFigures(Desk& desk, std::function<void()> openViews)
      : desk_(desk), openViews_(std::move(openViews)), watch_(&desk.window, nullptr) {}

  /// Measures how fast the same stretch of simulated time is simulated with views and without: what a robot
  /// does changes what its programs and the physics cost, so that others could not be compared.
  void compareSpeeds() {
    for (int i = 0; i < kComparisons; ++i) {
      openViews_();
      stretch(withViews);
      desk_.window.docks().closeAll();
      stretch(without);
    }
  }

  /// Measures what the views do, and closes them for a while.
  void round() {
    openViews_();
    letRun(kSettle);
    watch_.reset();
    paints.begin(desk_.window);
    const double gui = cpuSeconds(CLOCK_THREAD_CPUTIME_ID), process = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    const MachineLoad load;
    letRun(kWithViews);
    seconds += load.seconds();
    guiSeconds += cpuSeconds(CLOCK_THREAD_CPUTIME_ID) - gui;
    processSeconds += cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - process;
    paints.end();
    if (watch_.stalls().longestCpu > worst) {
      worst = watch_.stalls().longestCpu;
      std::printf("after %.0f s: %.1f ms, %s\n", seconds, 1e-3 * static_cast<double>(worst.count()),
                  qPrintable(watch_.stalls().cause));
      std::fflush(stdout);
    }
    desk_.window.docks().closeAll();
    letRun(kSettle);
  }

  PaintCounter paints;
  SpeedOverTime withViews, without;
  std::chrono::microseconds worst{0};
  /// How long views were watched, in s.
  double seconds = 0;
  /// With views: the processor time of the window's thread and of all threads.
  double guiSeconds = 0, processSeconds = 0;

 private:
  /// Long enough for plots to have read what is on disk.
  static constexpr auto kSettle = 2000ms;
  static constexpr auto kWithViews = 3000ms;
  static constexpr int kComparisons = 4;
  /// From when to when the same is simulated, in s.
  static constexpr double kFrom = 10, kTo = 60;
  /// On a machine that is so busy that figures mean nothing, less is enough. In s.
  static constexpr double kLongest = 15;

  void stretch(SpeedOverTime& speed) {
    const double begin = resetAndRun(desk_, kFrom);
    const MachineLoad load;
    const auto simulated = [this] {
      return robotlink::seconds(simulatedUntil(desk_.workbench.session()).time_since_epoch());
    };
    while (simulated() < kTo && load.seconds() < kLongest) letRun(5ms);
    speed.real += load.seconds();
    speed.simulated += simulated() - begin;
  }

  Desk& desk_;
  const std::function<void()> openViews_;
  StallWatch watch_;
};

}  // namespace

class ManyViewsGuiTest : public WindowTest {
  Q_OBJECT
 private:
  static constexpr double kMinSpeed = 0.9;   // times that without views
  static constexpr double kMinFrames = 0.9;  // times what the window's ticks make
  static constexpr double kMaxGrowthMib = 20;
  /// What may be kept for rewinding; a short run does not fill it.
  static constexpr double kRewindMib = 256;
  static constexpr int kHistoryMib = 64, kDiskMib = 256;
  /// In a run from so many s on, it is waited for that.
  static constexpr double kLongRun = 600;

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
    const double images = figures.paints.least("imageCanvas"), seconds = figures.seconds;
    const double with = figures.withViews.value(), without = figures.without.value();
    std::printf(
        "views shown for %.1f s: images %.1f, plots %.1f, scene %.1f frames a second\n"
        "window: %.1f ms of processor time a frame, %.1f ms at worst; %.2f cores with all threads\n"
        "simulation: %.2f times real time with views, %.2f without, ratio %.3f; others used %.2f cores\n",
        seconds, images / seconds, figures.paints.least("plotCanvas") / seconds,
        figures.paints.least("sceneCanvas") / seconds, 1e3 * figures.guiSeconds / images,
        1e-3 * static_cast<double>(figures.worst.count()), figures.processSeconds / seconds, with, without,
        with / without, load.others());
    std::fflush(stdout);
  }
  /// Whether so much was simulated that what is kept for rewinding has reached its bound of 256 MiB: from
  /// then on memory has to stay as it is.
  static bool keepsAllForRewinding(Desk& desk) {
    constexpr double kEnough = 4500;  // s
    return robotlink::seconds(simulatedUntil(desk.workbench.session()).time_since_epoch()) >= kEnough;
  }
  /// What says something only of a machine that does nothing else.
  static void checkTimes(const DeskFigures& figures) {
    const double perSecond = kMinFrames * 1000 / kWindowTickMs, seconds = figures.seconds;
    QVERIFY2(figures.paints.least("imageCanvas") >= perSecond * seconds, "images are painted too seldom");
    QVERIFY2(figures.paints.least("plotCanvas") >= perSecond * seconds, "plots are painted too seldom");
    QVERIFY2(figures.withViews.value() >= kMinSpeed * figures.without.value(),
             "views slow the simulation down");
  }
  /// Opens all views, and waits until they can be seen.
  static void openAndWait(Desk& desk) {
    openViews(desk);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "imageCanvas", kManyImages), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "plotCanvas", kFastPlots), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(areVisible(desk, "sceneCanvas", 1), kWaitMs);
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
    // Once before, so that the robot publishes what the views show, with them and without.
    openAndWait(desk);
    DeskFigures figures(desk, [&desk] { openAndWait(desk); });
    MachineLoad load;
    figures.compareSpeeds();
    const bool wasQuiet = load.isQuiet();
    QTRY_VERIFY_WITH_TIMEOUT(store.bytes() >= std::size_t{kHistoryMib - 8} << 20U, 10 * kWaitMs);

    const double wanted = wantedSeconds();
    load = {};
    // At the ends of rounds, when no plot is open that keeps points.
    double before = 0;
    bool isFull = false;
    while (load.seconds() < wanted || before == 0) {
      figures.round();
      if (QTest::currentTestFailed()) return;
      if (before == 0 && load.seconds() >= wanted / 3 && (wanted < kLongRun || keepsAllForRewinding(desk)))
        before = residentMib(), isFull = keepsAllForRewinding(desk);
    }
    const double after = residentMib(), growth = after - before;
    print(figures, load);
    std::printf("memory: %.0f MiB, %.1f MiB more than at first\n", after, growth);
    std::fflush(stdout);

    QVERIFY2(growth <= kMaxGrowthMib + (isFull ? 0 : kRewindMib), "memory grows");
    QVERIFY2(figures.worst <= StallWatch::kLimit, "the window did not answer for too long");
    const int frames = figures.paints.least("imageCanvas");
    QVERIFY(frames > 0);
    QVERIFY2(1e3 * figures.guiSeconds / frames < kWindowTickMs,
             "frames cost more than the time between them");
    if (wasQuiet && load.isQuiet()) checkTimes(figures);
  }
};

const widgets::test::GuiTest<ManyViewsGuiTest> kManyViewsGuiTest;

}  // namespace app::test

#include "ManyViewsGuiTest.moc"
