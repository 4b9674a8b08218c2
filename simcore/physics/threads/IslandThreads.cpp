// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/threads/IslandThreads.h"

#include <utility>

#include "robotlink/base/Random.h"
#include "simcore/physics/threads/OdeRandom.h"
#include "simcore/physics/threads/OdeThread.h"

namespace simcore {
namespace {

/// With fewer joints and contacts a thread is done before another one is awake.
constexpr int kWorthThreads = 60;

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

class IslandThreads::Job {
 public:
  /// The job that the calling thread executes.
  static Job& ofThread() {
    thread_local Job job;
    return job;
  }
  /// The same while it runs, otherwise null.
  static Job* current() {
    Job& job = ofThread();
    return job.of_ != nullptr ? &job : nullptr;
  }

  /// Makes a call of a step and all that follow from it.
  void run(IslandThreads& of, const Call& first) {
    prepareOdeForThread();
    of_ = &of;
    ready_.push_back(copyOf(first));
    while (!ready_.empty()) {
      std::unique_ptr<Call> call = std::move(ready_.back());
      ready_.pop_back();
      make(*call);
      release(call->dependent);
      spare_.push_back(std::move(call));
    }
    of_ = nullptr;
  }

  dCallReleaseeID post(const Call& call) {
    auto own = copyOf(call);
    const auto id = reinterpret_cast<dCallReleaseeID>(own.get());
    (call.dependencies > 0 ? waiting_ : ready_).push_back(std::move(own));
    return id;
  }
  void change(dCallReleaseeID id, ddependencychange_t by) {
    if (Call* call = find(id))
      call->dependencies =
          static_cast<ddependencycount_t>(static_cast<ddependencychange_t>(call->dependencies) + by);
  }

 private:
  std::unique_ptr<Call> copyOf(const Call& call) {
    if (spare_.empty()) return std::make_unique<Call>(call);
    std::unique_ptr<Call> own = std::move(spare_.back());
    spare_.pop_back();
    *own = call;
    return own;
  }
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
      const std::lock_guard lock(of_->taking_);
      const std::size_t before = ready_.size();
      call.function(call.context, call.index, self);
      if (ready_.size() > before && find(ready_.back()->dependent) != nullptr) island_ = of_->islands_++;
      return;
    }
    seedOdeRandom(robotlink::hashBits(of_->seed_, island_, 0));
    call.function(call.context, call.index, self);
  }

  IslandThreads* of_ = nullptr;
  /// Calls that can be made, that depend on others, and whose memory can be used again.
  std::vector<std::unique_ptr<Call>> ready_, waiting_, spare_;
  /// The island that was taken last.
  std::size_t island_ = 0;
};

struct IslandThreads::Functions {
  static IslandThreads& of(dThreadingImplementationID id) { return *reinterpret_cast<IslandThreads*>(id); }

  using Locks = std::vector<std::mutex>;
  static Locks& locksOf(dMutexGroupID group) { return *reinterpret_cast<Locks*>(group); }
  static dMutexGroupID newLocks(dThreadingImplementationID, dmutexindex_t count, const char* const*) {
    return reinterpret_cast<dMutexGroupID>(new Locks(count));
  }
  static void deleteLocks(dThreadingImplementationID, dMutexGroupID group) { delete &locksOf(group); }
  static void lock(dThreadingImplementationID id, dMutexGroupID group, dmutexindex_t index) {
    if (of(id).threadsOfStep_ > 1) locksOf(group)[index].lock();
  }
  static void unlock(dThreadingImplementationID id, dMutexGroupID group, dmutexindex_t index) {
    if (of(id).threadsOfStep_ > 1) locksOf(group)[index].unlock();
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
    : pool_(std::move(pool)), world_(world) {
  dWorldSetStepThreadingImplementation(world, &Functions::info(),
                                       reinterpret_cast<dThreadingImplementationID>(this));
}

IslandThreads::~IslandThreads() = default;

void IslandThreads::step(double seconds, int joints, std::uint64_t seed) {
  threads_ = pool_ && joints >= kWorthThreads ? pool_->threads() : 1;
  seed_ = seed;
  asked_ = 0;
  islands_ = 0;
  dWorldQuickStep(world_, seconds);
  group_.reset();
}

void IslandThreads::runJobs(Call first) {
  threadsOfStep_ = asked_ == 2 ? threads_ : 1;
  if (threadsOfStep_ == 1) return Job::ofThread().run(*this, first);
  pool_->run(static_cast<std::size_t>(threadsOfStep_),
             [&](std::size_t) { Job::ofThread().run(*this, first); });
}

}  // namespace simcore
