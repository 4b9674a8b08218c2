// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs where the program of a robot with a camera runs: the CPU time of `robotctl sim`, with all of
// its processes and its start, as its program runs inside, in a process of its own, and inside a simulation
// that is offered while nobody is connected. They are measured in turn, in one run, so that what else the
// machine does hits all alike; the ratios are medians of quotients to the first. "own_ratio" is to be at most
// 1.5, "listen_ratio" near 1.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

namespace {

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The CPU time of this process and of all that have ended below it, s.
double cpuSeconds() {
  double sum = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    ::getrusage(who, &usage);
    sum += secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime);
  }
  return sum;
}

/// The CPU time of a game of so many simulated seconds, s; nothing if it fails.
std::optional<double> costOf(std::int64_t seconds, const std::string& options) {
  const std::string line =
      std::string(ROBOTCTL " sim " ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf --speed 0 ") +
      options + " --seconds " + std::to_string(seconds) + " >/dev/null 2>&1";
  const double before = cpuSeconds();
  if (std::system(line.c_str()) != 0) return std::nullopt;
  return cpuSeconds() - before;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void programOfARobot(benchmark::State& state) {
  const std::int64_t seconds = state.range(0);
  std::vector<double> inside, own, served;
  for (auto unused : state) {
    static_cast<void>(unused);
    const auto base = costOf(seconds, "");
    const auto inItsProcess = costOf(seconds, "--own-process all");
    const auto offered = costOf(seconds, "--listen 127.0.0.1:0");
    if (!base || !inItsProcess || !offered) {
      state.SkipWithError("a game failed; run robotctl sim to see why");
      return;
    }
    inside.push_back(*base);
    own.push_back(*inItsProcess / *base);
    served.push_back(*offered / *base);
    state.SetIterationTime(*base);
  }
  state.counters["cpu_per_simulated"] = median(inside) / static_cast<double>(seconds);
  state.counters["own_ratio"] = median(own);
  state.counters["listen_ratio"] = median(served);
}
BENCHMARK(programOfARobot)
    ->ArgName("seconds")
    ->Arg(20)
    ->Iterations(5)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
