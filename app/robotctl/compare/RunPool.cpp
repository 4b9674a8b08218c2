// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunPool.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <thread>

#include "app/robotctl/SpawnSelf.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kLookAtRunsEvery{50};
constexpr ::mode_t kFileMode = 0644;

}  // namespace

RunPool::~RunPool() {
  endAll();
}

bool RunPool::start(const PlannedRun& run) {
  if (!files_.prepare(run)) return false;
  const std::string result = files_.unfinished(run).string(), texts = files_.texts(run).string();
  const ::pid_t pid = spawnSelf(run.arguments, [&] {
    const int in = ::open("/dev/null", O_RDONLY);
    const int out = ::open(result.c_str(), O_WRONLY | O_CREAT | O_TRUNC, kFileMode);
    const int errors = ::open(texts.c_str(), O_WRONLY | O_CREAT | O_TRUNC, kFileMode);
    return ::dup2(in, STDIN_FILENO) >= 0 && ::dup2(out, STDOUT_FILENO) >= 0 &&
           ::dup2(errors, STDERR_FILENO) >= 0;
  });
  if (pid < 0) return false;
  children_.push_back({pid, run});
  return true;
}

void RunPool::collect(RunProgress& progress, std::vector<PlannedRun>& failed) {
  std::erase_if(children_, [&](const Child& child) {
    int status = 0;
    if (::waitpid(child.pid, &status, WNOHANG) != child.pid) return false;
    const bool isWell = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (isWell && files_.finish(child.run)) {
      ++progress.done;
    } else {
      ++progress.failed;
      failed.push_back(child.run);
    }
    return true;
  });
  progress.running = children_.size();
}

void RunPool::endAll() {
  for (const Child& child : children_) ::kill(child.pid, SIGTERM);
  for (const Child& child : children_) ::waitpid(child.pid, nullptr, 0);
  children_.clear();
}

std::vector<PlannedRun> RunPool::execute(std::vector<PlannedRun> runs,
                                         const std::function<bool(const RunProgress&)>& look) {
  RunProgress progress{.all = runs.size()};
  std::vector<PlannedRun> failed;
  auto next = runs.begin();
  while (next != runs.end() || !children_.empty()) {
    while (next != runs.end() && children_.size() < parallel_) {
      if (!start(*next)) {
        ++progress.failed;
        failed.push_back(*next);
      }
      ++next;
    }
    collect(progress, failed);
    if (!look(progress)) {
      for (const Child& child : children_) failed.push_back(child.run);
      endAll();
      std::copy(next, runs.end(), std::back_inserter(failed));
      return failed;
    }
    if (!children_.empty()) std::this_thread::sleep_for(kLookAtRunsEvery);
  }
  return failed;
}

}  // namespace app
