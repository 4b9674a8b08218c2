// SPDX-License-Identifier: GPL-3.0-or-later
// What it costs to hand a package from one process to another and back, each in its own thread, beside the
// least that any hand-over between threads needs: a mutex and a condition variable. Both are measured in
// turn, in one run, so that what else the machine does hits both alike; "ratio" is the median of their
// quotients.
#include <benchmark/benchmark.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <condition_variable>
#include <thread>
#include <vector>

#include "tests/robotlink/process/TestProcess.h"

namespace robotlink::test {
namespace {

constexpr int kRounds = 2000;
using Clock = std::chrono::steady_clock;

/// Keeps the calling thread on the n-th of the processors that the program may use.
void keepOnProcessor(int n) {
  static const cpu_set_t kAllowed = [] {
    cpu_set_t set;
    ::sched_getaffinity(0, sizeof(set), &set);
    return set;
  }();
  const int wanted = n % CPU_COUNT(&kAllowed);
  cpu_set_t one;
  CPU_ZERO(&one);
  for (std::size_t cpu = 0, seen = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &kAllowed) && static_cast<int>(seen++) == wanted) CPU_SET(cpu, &one);
  }
  ::pthread_setaffinity_np(::pthread_self(), sizeof(one), &one);
}

/// Seconds for a number to go there and back kRounds times, by hand.
double bareRounds() {
  std::mutex mutex;
  std::condition_variable changed;
  int there = 0;
  int back = 0;
  std::thread answering([&] {
    keepOnProcessor(1);
    for (int i = 1; i <= kRounds; ++i) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return there == i; });
      back = i;
      lock.unlock();
      changed.notify_one();
    }
  });
  const auto start = Clock::now();
  for (int i = 1; i <= kRounds; ++i) {
    {
      const std::lock_guard lock(mutex);
      there = i;
    }
    changed.notify_one();
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return back == i; });
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  answering.join();
  return seconds;
}

/// The same by two processes with blocking receivers, each frame a package.
double processRounds() {
  SteadyClock clock;
  TestProcess from("from", clock);
  TestProcess to("to", clock);
  Sender<Ball> there(from, "there", Blocking::kNo);
  Receiver<Ball> thereReceiver(to, "there", Blocking::kYes);
  Sender<Ball> back(to, "back", Blocking::kNo);
  Receiver<Ball> backReceiver(from, "back", Blocking::kYes);
  robotlink::connect(there, thereReceiver);
  robotlink::connect(back, backReceiver);
  const auto package = ball(1);
  from.body = [&] { there.send(package); };
  to.body = [&] { back.send(package); };
  std::thread answering([&] {
    keepOnProcessor(1);
    while (to.waitForFrame(std::chrono::seconds(1))) to.runFrame();
  });
  const auto start = Clock::now();
  there.send(package);
  for (int i = 1; i < kRounds && from.waitForFrame(std::chrono::seconds(1)); ++i) from.runFrame();
  from.waitForFrame(std::chrono::seconds(1));
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  to.stop();
  answering.join();
  return seconds;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void handOverBetweenProcesses(benchmark::State& state) {
  std::vector<double> bare;
  std::vector<double> processes;
  std::vector<double> ratios;
  keepOnProcessor(0);
  for (auto unused : state) {
    static_cast<void>(unused);
    const double bareSeconds = bareRounds();
    const double processSeconds = processRounds();
    state.SetIterationTime(processSeconds);
    bare.push_back(bareSeconds);
    processes.push_back(processSeconds);
    ratios.push_back(processSeconds / bareSeconds);
  }
  state.counters["bare_us"] = 1e6 * median(bare) / (2 * kRounds);
  state.counters["process_us"] = 1e6 * median(processes) / (2 * kRounds);
  state.counters["ratio"] = median(ratios);
}
BENCHMARK(handOverBetweenProcesses)->Iterations(15)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace robotlink::test
