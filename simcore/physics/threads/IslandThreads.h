// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "robotlink/base/threads/ThreadPool.h"

namespace simcore {

/// Steps the islands of one ODE world (bodies that joints and contacts connect) in the threads of a pool,
/// with the same bytes for any number of threads.
///
/// ODE calls it as its threading implementation (ode/threading.h). ODE's own implementations also divide the
/// work within an island, which costs more than it gains and makes results depend on chance. Here an island
/// is computed by one thread, with random numbers of its own. In which order islands move their solids in the
/// spaces is left to chance: findContacts() depends on no order.
///
/// For that it relies on ODE 0.16 asking for the number of threads twice in a step, once for the memory of
/// islands and once for dividing them; if it is asked otherwise, the islands are stepped in one thread.
class IslandThreads {
 public:
  /// Without a pool one thread does everything. It must outlive the world.
  IslandThreads(std::shared_ptr<robotlink::ThreadPool> pool, dWorldID world);
  ~IslandThreads();
  IslandThreads(const IslandThreads&) = delete;
  IslandThreads& operator=(const IslandThreads&) = delete;

  /// Works like dWorldQuickStep; the random numbers of the islands follow from `seed`. With few `joints`,
  /// including contacts, one thread does it.
  void step(double seconds, int joints, std::uint64_t seed);

 private:
  /// A call that ODE wants to be made: when those that it depends on have ended.
  struct Call;
  /// The calls of one thread in a step.
  class Job;
  /// The functions that ODE calls.
  struct Functions;

  void runJobs(Call first);

  const std::shared_ptr<robotlink::ThreadPool> pool_;
  const dWorldID world_;
  std::uint64_t seed_ = 0;
  int threads_ = 1, threadsOfStep_ = 1;
  /// How often ODE has asked for the number of threads in this step.
  int asked_ = 0;
  /// Null while no step is made.
  std::unique_ptr<Call> group_;

  /// Held while a thread takes the next island.
  std::mutex taking_;
  /// Protected by `taking_`.
  std::size_t islands_ = 0;
};

}  // namespace simcore
