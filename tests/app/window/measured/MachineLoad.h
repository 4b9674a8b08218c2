// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <malloc.h>
#include <sched.h>
#include <unistd.h>

#include <QEventLoop>
#include <QTimer>
#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

// What a program takes of the machine, for tests that measure it.
namespace app::test {

/// The processor time of this process (CLOCK_PROCESS_CPUTIME_ID) or thread (CLOCK_THREAD_CPUTIME_ID), in s.
inline double cpuSeconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The memory of this process in MiB, without what was freed.
inline double residentMib() {
  ::malloc_trim(0);
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1U << 20U);
}

/// Restricts this thread, and those that it starts from now on, to two of the processors that it may use.
inline void useTwoCores() {
  cpu_set_t allowed, two;
  CPU_ZERO(&two);
  if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
  for (int cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&two) < 2; ++cpu) {
    if (CPU_ISSET(cpu, &allowed)) CPU_SET(cpu, &two);
  }
  ::sched_setaffinity(0, sizeof two, &two);
}

/// Lets the window live for a while in an event loop that waits, as that of the program does.
inline void letRun(std::chrono::milliseconds time) {
  QEventLoop loop;
  QTimer::singleShot(time, Qt::PreciseTimer, &loop, &QEventLoop::quit);
  loop.exec();
}

/// How busy the machine is from its construction on: by this process, and by others.
class MachineLoad {
 public:
  /// In s of real time.
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  /// The processor time of this process, in s.
  double own() const { return cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - own_; }
  /// How many processors others keep busy.
  double others() const { return std::max(0.0, (busy() - busy_ - own()) / seconds()); }
  /// Whether times say something about this program: it had two processors for itself.
  bool isQuiet() const { return std::thread::hardware_concurrency() >= 2 && others() < kQuiet; }

 private:
  static constexpr double kQuiet = 0.2;

  /// The processor time of all processes, in s.
  static double busy() {
    std::ifstream file("/proc/stat");
    std::string name;
    std::array<double, 8> ticks{};  // user, nice, system, idle, iowait, irq, softirq, steal
    file >> name;
    for (double& each : ticks) file >> each;
    const double sum = ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6] + ticks[7];
    return sum / static_cast<double>(::sysconf(_SC_CLK_TCK));
  }

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double own_ = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
  double busy_ = busy();
};

}  // namespace app::test
