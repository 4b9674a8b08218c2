// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/threads/IslandThreads.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <string_view>
#include <utility>

#include "robotlink/base/threads/BriefWait.h"
#include "simcore/physics/threads/OdeRandom.h"
#include "simcore/physics/threads/OdeThread.h"

namespace simcore {
namespace {

/// ODE shuffles the constraints of an island in every iteration whose number this divides, but not in the
/// first.
constexpr int kIterationsOfShuffle = 8;
/// The name of ODE's lock that it holds while a body moves its solids.
constexpr std::string_view kMovingLock = "StepBody";
/// With fewer joints and contacts a thread is done before another one is awake.
constexpr int kWorthThreads = 60;
/// How long a thread looks for what it waits for before it sleeps.
constexpr std::chrono::microseconds kAttention{500};

/// Looks for a condition for a moment, then waits for it.
template <typename Condition>
void await(std::mutex& mutex, std::condition_variable& changed, Condition condition) {
  if (robotlink::waitBriefly(kAttention, condition)) return;
  std::unique_lock lock(mutex);
  changed.wait(lock, condition);
}

}  // namespace

struct IslandThreads::Call {
  dThreadedCallFunction* function = nullptr;
  void* context = nullptr;
  dcallindex_t index = 0;
  /// Calls that have to end before.
  ddependencycount_t dependencies = 0;
  /// The call that depends on this one.
  dCallReleaseeID dependent = nullptr;
};

struct IslandThreads::Locks {
  std::vector<std::mutex> mutexes;
  /// Keyed by mutex.
  std::vector<bool> isForMoving;
};

class IslandThreads::Job : public OdeRandomWatch {
 public:
  explicit Job(IslandThreads& of) : of_(of) {}

  static Job*& current() {
    thread_local Job* job = nullptr;
    return job;
  }

  /// Makes a call and all that follow from it.
  void run(const Call& first) {
    prepareOdeForThread();
    Job* const before = std::exchange(current(), this);
    watchOdeRandom(this);
    ready_.push_back(std::make_unique<Call>(first));
    while (!ready_.empty()) {
      const std::unique_ptr<Call> call = std::move(ready_.back());
      ready_.pop_back();
      make(*call);
      release(call->dependent);
    }
    watchOdeRandom(nullptr);
    current() = before;
  }

  dCallReleaseeID post(const Call& call) {
    auto own = std::make_unique<Call>(call);
    const auto id = reinterpret_cast<dCallReleaseeID>(own.get());
    (call.dependencies > 0 ? waiting_ : ready_).push_back(std::move(own));
    return id;
  }
  void change(dCallReleaseeID id, ddependencychange_t by) {
    if (Call* call = find(id))
      call->dependencies =
          static_cast<ddependencycount_t>(static_cast<ddependencychange_t>(call->dependencies) + by);
  }

  void beforeNumber(int range) override {
    if (numbers_ == 0) setOdeRandomState(of_.randomStateOf(island_));
    // A shuffle begins with the range 2; with the second one it is clear how long all are.
    if (range == 2 && numbers_ > 0 && announced_ == 0) {
      announced_ = numbers_ * static_cast<std::uint64_t>(of_.shuffles_);
      of_.announceNumbers(island_, announced_);
    }
    ++numbers_;
  }
  void waitForTurn() { of_.waitForTurn(island_); }

 private:
  Call* find(dCallReleaseeID id) {
    for (const auto& call : waiting_) {
      if (reinterpret_cast<dCallReleaseeID>(call.get()) == id) return call.get();
    }
    return nullptr;
  }
  void release(dCallReleaseeID id) {
    change(id, -1);
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (waiting_[i]->dependencies > 0) continue;
      ready_.push_back(std::move(waiting_[i]));
      waiting_.erase(waiting_.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
  }
  /// An island is stepped by a call on which the search for the next one depends.
  void make(const Call& call) {
    const auto self = reinterpret_cast<dCallReleaseeID>(const_cast<Call*>(&call));
    if (find(call.dependent) == nullptr) {
      const std::lock_guard lock(of_.taking_);
      const std::size_t before = ready_.size();
      call.function(call.context, call.index, self);
      if (ready_.size() > before && find(ready_.back()->dependent) != nullptr) island_ = of_.islands_++;
      return;
    }
    numbers_ = announced_ = 0;
    call.function(call.context, call.index, self);
    of_.endIsland(island_, numbers_);
    assert(announced_ == 0 || announced_ == numbers_);
  }

  IslandThreads& of_;
  std::vector<std::unique_ptr<Call>> ready_, waiting_;
  /// The island that was taken last; the numbers that were drawn for it, and that were announced to be.
  std::size_t island_ = 0;
  std::uint64_t numbers_ = 0, announced_ = 0;
};

struct IslandThreads::Functions {
  static IslandThreads& of(dThreadingImplementationID id) { return *reinterpret_cast<IslandThreads*>(id); }

  static dMutexGroupID newLocks(dThreadingImplementationID, dmutexindex_t count, const char* const* names) {
    auto locks = std::make_unique<Locks>();
    locks->mutexes = std::vector<std::mutex>(count);
    for (dmutexindex_t i = 0; i < count; ++i) {
      const std::string_view name = names != nullptr && names[i] != nullptr ? names[i] : "";
      locks->isForMoving.push_back(name.find(kMovingLock) != std::string_view::npos);
    }
    return reinterpret_cast<dMutexGroupID>(locks.release());
  }
  static void deleteLocks(dThreadingImplementationID, dMutexGroupID group) {
    delete reinterpret_cast<Locks*>(group);
  }
  static void lock(dThreadingImplementationID, dMutexGroupID group, dmutexindex_t index) {
    auto& locks = *reinterpret_cast<Locks*>(group);
    if (Job* job = Job::current(); job != nullptr && locks.isForMoving[index]) job->waitForTurn();
    locks.mutexes[index].lock();
  }
  static void unlock(dThreadingImplementationID, dMutexGroupID group, dmutexindex_t index) {
    reinterpret_cast<Locks*>(group)->mutexes[index].unlock();
  }

  // A step has ended when step() returns, so that nothing is to be waited for.
  static dCallWaitID newWait(dThreadingImplementationID id) { return reinterpret_cast<dCallWaitID>(id); }
  static void nothing(dThreadingImplementationID, dCallWaitID) {}
  static void wait(dThreadingImplementationID, int* status, dCallWaitID, const dThreadedWaitTime*,
                   const char*) {
    if (status != nullptr) *status = 1;
  }

  static void post(dThreadingImplementationID id, int* fault, dCallReleaseeID* releasee,
                   ddependencycount_t dependencies, dCallReleaseeID dependent, dCallWaitID,
                   dThreadedCallFunction* function, void* context, dcallindex_t index, const char*) {
    if (fault != nullptr) *fault = 0;
    const Call call{function, context, index, dependencies, dependent};
    if (Job* job = Job::current()) {
      const dCallReleaseeID own = job->post(call);
      if (releasee != nullptr) *releasee = own;
      return;
    }
    IslandThreads& threads = of(id);
    if (dependencies == 0) return threads.runJobs(call);
    threads.group_ = std::make_unique<Call>(call);
    if (releasee != nullptr) *releasee = reinterpret_cast<dCallReleaseeID>(threads.group_.get());
  }
  static void change(dThreadingImplementationID, dCallReleaseeID releasee, ddependencychange_t by) {
    if (Job* job = Job::current()) job->change(releasee, by);
  }

  static unsigned threads(dThreadingImplementationID id) {
    IslandThreads& threads = of(id);
    return threads.asked_++ == 0 ? static_cast<unsigned>(threads.threads_) : 1U;
  }
  static int reserve(dThreadingImplementationID, ddependencycount_t) { return 1; }

  static const dThreadingFunctionsInfo& info() {
    static const dThreadingFunctionsInfo kInfo{sizeof(dThreadingFunctionsInfo),
                                               newLocks,
                                               deleteLocks,
                                               lock,
                                               unlock,
                                               newWait,
                                               nothing,
                                               nothing,
                                               post,
                                               change,
                                               wait,
                                               threads,
                                               reserve};
    return kInfo;
  }
};

IslandThreads::IslandThreads(std::shared_ptr<robotlink::ThreadPool> pool, dWorldID world)
    : pool_(std::move(pool)),
      world_(world),
      shuffles_((dWorldGetQuickStepNumIterations(world) - 1) / kIterationsOfShuffle) {
  dWorldSetStepThreadingImplementation(world, &Functions::info(),
                                       reinterpret_cast<dThreadingImplementationID>(this));
}

IslandThreads::~IslandThreads() = default;

void IslandThreads::step(double seconds, int joints) {
  threads_ = joints >= kWorthThreads ? pool_->threads() : 1;
  asked_ = 0;
  islands_ = 0;
  progress_.clear();
  states_.assign(1, odeRandomState());
  known_ = 1;
  ended_ = 0;
  dWorldQuickStep(world_, seconds);
  group_.reset();
}

void IslandThreads::runJobs(Call first) {
  threadsOfStep_ = asked_ == 2 ? threads_ : 1;
  pool_->run(static_cast<std::size_t>(threadsOfStep_), [&](std::size_t) { Job(*this).run(first); });
}

void IslandThreads::waitForTurn(std::size_t island) {
  await(mutex_, progressed_, [&] { return ended_ >= island; });
}

std::uint32_t IslandThreads::randomStateOf(std::size_t island) {
  await(mutex_, progressed_, [&] { return known_ > island; });
  const std::lock_guard lock(mutex_);
  return states_[island];
}

void IslandThreads::extend() {
  while (states_.size() <= progress_.size() && progress_[states_.size() - 1].isKnown)
    states_.push_back(odeRandomAfter(states_.back(), progress_[states_.size() - 1].numbers));
  known_ = states_.size();
  std::size_t ended = ended_;
  while (ended < progress_.size() && progress_[ended].hasEnded) ++ended;
  ended_ = ended;
}

void IslandThreads::announceNumbers(std::size_t island, std::uint64_t numbers) {
  {
    const std::lock_guard lock(mutex_);
    if (progress_.size() <= island) progress_.resize(island + 1);
    progress_[island].isKnown = true;
    progress_[island].numbers = numbers;
    extend();
  }
  progressed_.notify_all();
}

void IslandThreads::endIsland(std::size_t island, std::uint64_t numbers) {
  {
    const std::lock_guard lock(mutex_);
    if (progress_.size() <= island) progress_.resize(island + 1);
    progress_[island] = {true, true, numbers};
    extend();
  }
  progressed_.notify_all();
}

}  // namespace simcore
