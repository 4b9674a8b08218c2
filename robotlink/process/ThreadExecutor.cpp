// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/process/ThreadExecutor.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace robotlink {
namespace {

/// Returns the reason for a failure; empty on success.
std::string setNiceOfThisThread(int nice) {
  if (nice == 0) return {};
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  if (::setpriority(PRIO_PROCESS, thread, nice) == 0) return {};
  return std::strerror(errno);
}

}  // namespace

ThreadExecutor::ThreadExecutor(Options options) : options_(std::move(options)) {}

ThreadExecutor::~ThreadExecutor() {
  stop();
}

void ThreadExecutor::start() {
  for (Process* process : processes_) {
    threads_.emplace_back([this, process] { run(*process); });
  }
}

void ThreadExecutor::run(Process& process) {
  const std::string refused = setNiceOfThisThread(process.priority());
  if (!refused.empty() && options_.onPriorityRefused) options_.onPriorityRefused(process, refused);
  constexpr std::chrono::milliseconds kLimit{1000};
  while (process.waitForFrame(kLimit)) process.runFrame();
  if (!process.failure().empty() && options_.onFailed) options_.onFailed(process);
}

void ThreadExecutor::clockAdvanced() {
  for (Process* process : processes_) {
    if (process->period() > Duration::zero()) process->wake();
  }
}

void ThreadExecutor::stop() {
  for (Process* process : processes_) process->stop();
  for (std::thread& thread : threads_) {
    if (thread.joinable()) thread.join();
  }
  threads_.clear();
}

}  // namespace robotlink
