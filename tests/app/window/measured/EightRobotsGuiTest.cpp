// SPDX-License-Identifier: GPL-3.0-or-later
// Whether eight robots with cameras keep real time in the window as it is opened first.
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "tests/app/window/measured/MachineLoad.h"

namespace app::test {

using namespace std::chrono_literals;

class EightRobotsGuiTest : public WindowTest {
  Q_OBJECT
 private:
  static constexpr std::size_t kRobots = 8;
  /// What two processors have, but for a little that the desktop needs.
  static constexpr double kMaxCores = 1.9;
  static constexpr double kMinSpeed = 0.97;  // times real time

  /// The shipped scene with seven more robots, in a file of its own.
  std::filesystem::path scene() const {
    std::ifstream shipped(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf");
    std::string text{std::istreambuf_iterator<char>(shipped), std::istreambuf_iterator<char>()};
    std::string robots;
    for (std::size_t i = 1; i < kRobots; ++i) {
      const bool isBlue = i % 2 == 1;
      robots += "<include><uri>model://ers210</uri><name>" + std::string(isBlue ? "blue" : "red") +
                std::to_string(i / 2 + 1) + "</name><pose>" +
                std::to_string(-2 + 0.5 * static_cast<double>(i)) + (isBlue ? " -0.8" : " 0.8") +
                " 0.1138 0 0 0</pose></include>";
    }
    text.insert(text.rfind("</world>"), robots);
    const auto file = home_ / "eight.sdf";
    std::ofstream(file) << text;
    return file;
  }

 private Q_SLOTS:
  void eightRobotsKeepRealTime() {
    useTwoCores();
    Desk desk(home_, Desk::Opens::kNothing);
    RunOptions options = defaultSimulation();
    options.scene = scene();
    desk.workbench.open(SimulationFeed::opening(options));
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QCOMPARE(desk.workbench.session().robots().size(), kRobots);
    QVERIFY(desk.workbench.commands().runLine("simulation.speed 1"));
    QVERIFY(desk.workbench.commands().runLine("simulation.start"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > 2, 3 * kWaitMs);

    const auto now = [&] {
      return robotlink::seconds(desk.workbench.session().timeline().newest().time_since_epoch());
    };
    const double begin = now();
    const MachineLoad load;
    letRun(10s);
    const double simulated = now() - begin, speed = simulated / load.seconds();
    const double cores = load.own() / simulated;
    std::printf(
        "8 robots: %.3f times real time, %.2f s of processor time for each simulated second; others "
        "used %.2f cores\n",
        speed, cores, load.others());
    std::fflush(stdout);
    QVERIFY2(cores < kMaxCores, qPrintable(QStringLiteral("%1 cores").arg(cores)));
    if (load.isQuiet()) QVERIFY2(speed >= kMinSpeed, qPrintable(QStringLiteral("%1 x").arg(speed)));
  }
};

const widgets::test::GuiTest<EightRobotsGuiTest> kEightRobotsGuiTest;

}  // namespace app::test

#include "EightRobotsGuiTest.moc"
