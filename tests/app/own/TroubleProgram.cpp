// SPDX-License-Identifier: GPL-3.0-or-later
// The executable in which the programs of these tests run: all modules, and a task with solutions that crash
// or hang.
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <thread>
#include <utility>
#include <vector>

#include "app/core/own/OwnProgramMain.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Packages.h"

using robotlink::Solution;
using robotlink::SolutionBuilder;
using robotlink::SolutionContext;
using robotlink::SolutionRegistration;

// Not an unnamed namespace: only what is exported has a name in a stack.
namespace trouble {

/// Does nothing in its first frames, then what the test wants.
template <void (*kTrouble)()>
class Troublemaker final : public Solution {
 public:
  explicit Troublemaker(SolutionContext& /*context*/) {}
  void execute() override {
    if (++frames_ > 5) kTrouble();
  }

 private:
  int frames_ = 0;
};

class Unmakeable final : public Solution {
 public:
  explicit Unmakeable(SolutionContext& /*context*/) { std::abort(); }
  void execute() override {}
};

}  // namespace trouble

namespace {

using trouble::Troublemaker, trouble::Unmakeable;

void nothing() {}
void writeNowhere() {
  // No null pointer, which the undefined behavior sanitizer would report before the system does.
  static volatile std::uintptr_t nowhere = alignof(std::max_align_t);
  *reinterpret_cast<volatile int*>(nowhere) = 1;
}
void abortAll() {
  std::abort();
}
void leave() {
  std::exit(3);
}
std::atomic<bool> isLeaving{false}, isCrashing{false};
/// Other threads run on while it is destroyed, and crash.
struct UsedByOthers {
  ~UsedByOthers() {
    isLeaving = true;
    while (!isCrashing) std::this_thread::yield();
    for (int i = 0; i < 1000; ++i) std::this_thread::yield();
  }
};
void leaveAmongOthers() {
  static const UsedByOthers used;
  std::thread([] {
    while (!isLeaving) std::this_thread::yield();
    isCrashing = true;
    writeNowhere();
  }).detach();
  std::exit(3);
}
void loop() {
  static std::atomic<int> turns = 0;
  for (;;) ++turns;
}
void takeMemory() {
  // As a whole vector of vectors: no single allocation is out of the ordinary.
  std::vector<std::vector<char>> all;
  while (all.size() < 4096) all.emplace_back(std::size_t{1} << 20U, 'x');
}
void sleepOnce() {
  static bool slept = false;
  if (!std::exchange(slept, true)) std::this_thread::sleep_for(std::chrono::milliseconds(300));
}

void sleepLongOnce() {
  static bool slept = false;
  if (!std::exchange(slept, true)) std::this_thread::sleep_for(std::chrono::milliseconds(1000));
}

const SolutionRegistration kCalm =
    SolutionBuilder<Troublemaker<nothing>>("trouble", "none", "Does nothing.").yields(robotlink::kDrivePath);
const SolutionRegistration kWrites =
    SolutionBuilder<Troublemaker<writeNowhere>>("trouble", "segfault", "Writes where nothing is.")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kAborts =
    SolutionBuilder<Troublemaker<abortAll>>("trouble", "abort", "Calls abort().")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kLeaves =
    SolutionBuilder<Troublemaker<leave>>("trouble", "exit", "Calls exit().").yields(robotlink::kDrivePath);
const SolutionRegistration kLeavesAmongOthers =
    SolutionBuilder<Troublemaker<leaveAmongOthers>>("trouble", "exit-among-others",
                                                    "Calls exit() while another thread runs.")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kLoops =
    SolutionBuilder<Troublemaker<loop>>("trouble", "loop", "Never returns.").yields(robotlink::kDrivePath);
const SolutionRegistration kTakes =
    SolutionBuilder<Troublemaker<takeMemory>>("trouble", "memory", "Allocates 4 GiB.")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kSleeps =
    SolutionBuilder<Troublemaker<sleepOnce>>("trouble", "late", "Returns late, once.")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kSleepsLong =
    SolutionBuilder<Troublemaker<sleepLongOnce>>("trouble", "very-late", "Returns very late, once.")
        .yields(robotlink::kDrivePath);
const SolutionRegistration kUnmakeable =
    SolutionBuilder<Unmakeable>("trouble", "unmakeable", "Calls abort() when it is made.")
        .yields(robotlink::kDrivePath);

}  // namespace

int main(int argc, char** argv) {
  return app::ownProgramMain(argc, argv).value_or(2);
}
