// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robotlink/base/threads/ThreadPool.h"

namespace simcore {

/// Steps the islands of one ODE world (bodies that joints and contacts connect) in the threads of a pool,
/// with the same bytes as dWorldQuickStep gives in one thread.
///
/// ODE calls it as its threading implementation (ode/threading.h). ODE's own implementations also divide the
/// work within an island, which costs more than it gains and makes results depend on chance. Here an island
/// is computed by one thread. What ODE does for one island after the other, and what depends on their order,
/// is done in that order: drawing random numbers, and moving the solids in their spaces.
///
/// For that it relies on ODE 0.16 asking for the number of threads twice in a step, once for the memory of
/// islands and once for dividing them; if it is asked otherwise, the islands are stepped in one thread.
class IslandThreads {
 public:
  /// The pool must outlive it, and it must outlive the world.
  IslandThreads(std::shared_ptr<robotlink::ThreadPool> pool, dWorldID world);
  ~IslandThreads();
  IslandThreads(const IslandThreads&) = delete;
  IslandThreads& operator=(const IslandThreads&) = delete;

  /// As dWorldQuickStep, with the random numbers that the calling thread has been seeded with. With few
  /// `joints`, contacts included, one thread does it.
  void step(double seconds, int joints);
  /// How many threads took part in the last step.
  int threadsOfStep() const { return threadsOfStep_; }

 private:
  /// A call that ODE wants to be made: when those that it depends on have ended.
  struct Call;
  /// The calls of one thread in a step.
  class Job;
  /// The functions that ODE calls.
  struct Functions;
  /// Locks that ODE has asked for, by their names.
  struct Locks;

  void runJobs(Call first);
  /// Waits until all islands before `island` have been stepped.
  void waitForTurn(std::size_t island);
  /// Waits until the state of the random numbers at the beginning of an island is known, and returns it.
  std::uint32_t randomStateOf(std::size_t island);
  /// Says that so many numbers are drawn for an island altogether.
  void announceNumbers(std::size_t island, std::uint64_t numbers);
  void endIsland(std::size_t island, std::uint64_t numbers);

  const std::shared_ptr<robotlink::ThreadPool> pool_;
  const dWorldID world_;
  /// How often the constraints of an island are shuffled.
  const int shuffles_;
  int threads_ = 1, threadsOfStep_ = 0;
  /// How often ODE has asked for the number of threads in this step.
  int asked_ = 0;
  /// Null while no step is made.
  std::unique_ptr<Call> group_;

  /// Held while a thread takes the next island.
  std::mutex taking_;
  /// Protected by `taking_`.
  std::size_t islands_ = 0;

  /// Protects the rest.
  std::mutex mutex_;
  std::condition_variable progressed_;
  /// The states at the beginning of islands, as far as they are known in order.
  std::vector<std::uint32_t> states_;
  /// Keyed by island: the numbers that it draws, if known; and whether it has been stepped.
  struct Progress {
    bool isKnown = false, hasEnded = false;
    std::uint64_t numbers = 0;
  };
  std::vector<Progress> progress_;
  /// Islands that have ended without one before them that has not.
  std::atomic<std::size_t> ended_{0};
  /// As many as states_ has.
  std::atomic<std::size_t> known_{0};
  void extend();
};

}  // namespace simcore
