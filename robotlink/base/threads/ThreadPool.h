// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace robotlink {

/// Threads that share the jobs of a caller, who takes part and waits for all of them. Which thread does which
/// job, and when, depends on the machine, so jobs that are to give the same bytes for any number of threads
/// write to places of their own and read nothing that another job writes.
///
/// Threads that wait for further jobs poll for them for a moment before they sleep; see BriefWait.
class ThreadPool {
 public:
  static constexpr int kMaxThreads = 256;

  /// `threads` with the caller's; limited to 1 to kMaxThreads.
  explicit ThreadPool(int threads);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const { return static_cast<int>(workers_.size()) + 1; }
  /// The number of threads that the machine runs at once; at least 1.
  static int cores();

  /// Calls job(0) to job(count - 1), each once, in any order, and returns when all have ended. If jobs throw,
  /// the rest is still done, and one of the exceptions is thrown here. Any thread; a call while another one
  /// is in progress, such as from a job, does its jobs in the calling thread.
  void run(std::size_t count, const std::function<void(std::size_t)>& job);

  /// Has a job be done some time by a thread that has nothing else to do. run() neither waits for it nor for
  /// that thread. It is not done where there is no thread but the caller's, or if the pool ends before; it
  /// must not throw. Any thread.
  void later(std::function<void()> job);

 private:
  /// The jobs of a call.
  struct Batch {
    const std::function<void(std::size_t)>& job;
    std::size_t count;
    std::atomic<std::size_t> next{0};
    std::mutex mutex{};
    /// Protected by the mutex.
    std::exception_ptr failure{};
  };
  static void work(Batch& batch);
  void loop();
  /// Takes the first job that waits, and does it without the lock.
  void doOneLater(std::unique_lock<std::mutex>& lock);

  /// Whether a call of run() is in progress.
  std::atomic<bool> isBusy_{false};
  /// Counts the calls; changed with the mutex locked.
  std::atomic<std::uint64_t> calls_{0};
  /// Threads that are working; changed with the mutex locked.
  std::atomic<int> working_{0};
  /// How many jobs of later() wait; changed with the mutex locked.
  std::atomic<std::size_t> waiting_{0};
  /// Protects the rest.
  std::mutex mutex_;
  std::condition_variable called_, ended_;
  Batch* batch_ = nullptr;
  std::deque<std::function<void()>> later_;
  bool isOver_ = false;
  /// The last member, since they use the others.
  std::vector<std::thread> workers_;
};

}  // namespace robotlink
