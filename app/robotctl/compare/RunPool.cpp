// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/RunPool.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iterator>
#include <thread>

namespace app {
namespace {

constexpr std::chrono::milliseconds kLookAtRunsEvery{50};
constexpr ::mode_t kFileMode = 0644;

/// Runs in the child between fork() and exec(): only calls that are safe there.
[[noreturn]] void becomeRun(const char* result, const char* texts, ::pid_t parent, char* const* arguments) {
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);  // it ended before that
  // Ctrl-C in a terminal is for the program that compares, which ends the runs.
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  const int in = ::open("/dev/null", O_RDONLY);
  const int out = ::open(result, O_WRONLY | O_CREAT | O_TRUNC, kFileMode);
  const int errors = ::open(texts, O_WRONLY | O_CREAT | O_TRUNC, kFileMode);
  if (in < 0 || out < 0 || errors < 0) ::_exit(127);
  ::dup2(in, STDIN_FILENO);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(errors, STDERR_FILENO);
  ::execv("/proc/self/exe", arguments);
  ::_exit(127);
}

}  // namespace

RunPool::~RunPool() {
  endAll();
}

bool RunPool::start(const PlannedRun& run) {
  if (!files_.prepare(run)) return false;
  std::vector<std::string> words{"robotctl"};
  words.insert(words.end(), run.arguments.begin(), run.arguments.end());
  std::vector<char*> list;
  for (std::string& word : words) list.push_back(word.data());
  list.push_back(nullptr);
  const std::string result = files_.unfinished(run).string(), texts = files_.texts(run).string();
  const ::pid_t parent = ::getpid();
  const ::pid_t pid = ::fork();
  if (pid == 0) becomeRun(result.c_str(), texts.c_str(), parent, list.data());
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
