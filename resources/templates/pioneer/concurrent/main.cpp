// SPDX-License-Identifier: GPL-3.0-or-later
// A concurrent program: reading, control and planning are tasks of their own, each with its period, and it
// says how well they hold it. The robot object may be called from all of them.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::arcos::PioneerRobot;
using namespace std::chrono_literals;
using SteadyTime = std::chrono::steady_clock;

/// A task that does something every `period`, and how late it ever was.
struct PeriodicTask {
  const char* name;
  std::chrono::milliseconds period;
  long rounds = 0;
  std::chrono::duration<double, std::milli> latest{};

  template <typename Work>
  void run(const std::stop_token& stop, Work work) {
    for (auto due = SteadyTime::now(); !stop.stop_requested(); due += period) {
      std::this_thread::sleep_until(due);
      latest = std::max<decltype(latest)>(latest, SteadyTime::now() - due);
      work();
      ++rounds;
    }
  }
  bool report(double duration) const {
    std::cout << name << ": " << rounds << " rounds of " << period.count() << " ms, at most "
              << latest.count() << " ms late\n";
    return static_cast<double>(rounds) >= 0.95 * duration * 1000 / static_cast<double>(period.count());
  }
};

int main(int argc, char** argv) {
  PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 30;
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  PeriodicTask reading{"reading", 50ms}, control{"control", 100ms}, planning{"planning", 500ms};
  std::atomic<double> wantedHeading = robot.heading();  // from planning to control
  {
    const std::jthread reader(
        [&](const std::stop_token& stop) { reading.run(stop, [&] { robot.read(0ms); }); });
    const std::jthread controller([&](const std::stop_token& stop) {
      control.run(stop, [&] {
        const double off = robotlink::normalizedAngle(wantedHeading - robot.heading());
        robot.drive(robot.nearestEcho(-0.6, 0.6) > 0.9 && std::abs(off) < 0.5 ? 0.25 : 0,
                    std::clamp(off, -0.6, 0.6));
      });
    });
    const std::jthread planner([&](const std::stop_token& stop) {
      planning.run(stop, [&] {
        if (robot.nearestEcho(-0.6, 0.6) > 1.2) return;
        const bool leftIsFreer = robot.nearestEcho(0.6, 1.8) > robot.nearestEcho(-1.8, -0.6);
        wantedHeading = robot.heading() + (leftIsFreer ? 1.0 : -1.0);
      });
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(duration));
  }
  // Each reports, also if one before it has missed periods.
  bool held = reading.report(duration);
  held = control.report(duration) && held;
  held = planning.report(duration) && held;
  std::cout << (held ? "all periods were met\n" : "this machine is too busy to meet the periods\n");
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() && held ? 0 : 1;
}
