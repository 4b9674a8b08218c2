// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/CrashReport.h"

#include <cxxabi.h>
#include <execinfo.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "robotlink/process/Process.h"

namespace app {
namespace {

/// The first lines of reports: of one at the program's end, and of one that was requested.
constexpr std::string_view kEndHead = "end\n", kAskedHead = "report\n";
constexpr std::string_view kActivity = "activity ", kProcess = "process ", kStack = "stack\n";
constexpr int kMaxCalls = 64;
/// Calls that belong to the report itself: two of this file, and that of the system at a signal.
constexpr int kInSignal = 3, kInExit = 2;
/// Signals that end a program because of what it did.
constexpr std::array kFatal{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGXCPU, SIGTRAP};

// Data of signal handlers. Written before they can be called, except that watch() is called once later.
int reportTo = -1;                                          // NOLINT
const std::vector<robotlink::Process*>* watched = nullptr;  // NOLINT
std::array<char, 65536> signalStack;                        // NOLINT
/// The process that this thread executes; null: all.
thread_local const robotlink::Process* mine = nullptr;  // NOLINT

/// The threads of processes.
struct ProcessThread {
  std::atomic<const robotlink::Process*> process;
  std::atomic<::pid_t> thread;
};
std::array<ProcessThread, 64> processThreads;  // NOLINT
/// The thread from which a report is requested; 0: any.
std::atomic<::pid_t> suspected{0};  // NOLINT
/// The thread in which a module has called exit(); 0: none.
std::atomic<::pid_t> leaving{0};  // NOLINT

/// Finds out that a module calls exit(): what belongs to the calling thread is destroyed before anything
/// else.
struct ThreadEnd {
  ~ThreadEnd() {
    if (mine != nullptr && mine->activity() != nullptr) leaving = ::gettid();
  }
};

// Only what may be called in a handler of signals.
void put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(reportTo, text.data(), text.size());
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

/// `skipped`: the innermost calls, which belong to the report.
[[gnu::noinline]] void putReport(std::string_view head, int skipped) {
  put(head);
  for (std::size_t i = 0; watched != nullptr && i < watched->size(); ++i) {
    const robotlink::Process& process = *(*watched)[i];
    const std::string* activity = process.activity();
    if (activity == nullptr || (mine != nullptr && mine != &process)) continue;
    put(kActivity);
    put(*activity);
    put("\n");
    put(kProcess);
    put(process.name());
    put("\n");
    break;
  }
  put(kStack);
  std::array<void*, kMaxCalls> calls;
  const int count = ::backtrace(calls.data(), kMaxCalls);
  if (count > skipped) ::backtrace_symbols_fd(calls.data() + skipped, count - skipped, reportTo);
}

void onQuestion(int) {
  const int before = errno;
  // The system chooses the thread that gets a signal of another program.
  if (const ::pid_t thread = suspected.load(); thread != 0 && thread != ::gettid()) {
    ::tgkill(::getpid(), thread, SIGUSR1);
  } else {
    putReport(kAskedHead, kInSignal);
  }
  errno = before;
}

void handle(int signal, void (*handler)(int), int flags);

void onFatal(int signal) {
  // While a thread is in exit(), static objects are destroyed that the others use. It is exit() that ends the
  // program.
  if (const ::pid_t thread = leaving.load(); thread != 0 && thread != ::gettid()) {
    handle(signal, onFatal, static_cast<int>(SA_RESETHAND));
    while (true) ::pause();
  }
  putReport(kEndHead, kInSignal);
  // The signal is raised again, so that it ends the process when this handler returns.
  ::raise(signal);
}

void onExit(int status, void*) {
  putReport(kEndHead, kInExit);
  // The destructors of more static objects would run concurrently with the robot's program.
  ::_exit(status);
}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_ONSTACK | flags;
  // The report of an end is not interrupted by a requested one.
  sigaddset(&action.sa_mask, SIGUSR1);
  ::sigaction(signal, &action, nullptr);
}

/// "robotctl(_ZN3app3runEv+0x12) [0x55...]" becomes "app::run()+0x12 (robotctl)".
std::string readable(std::string_view line) {
  const auto open = line.rfind('('), close = line.rfind(')'),
             plus = line.find('+', open == line.npos ? 0 : open);
  if (open == line.npos || close == line.npos || close < open) return std::string(line);
  const std::string_view module = line.substr(0, open);
  const std::string file(module.substr(module.rfind('/') + 1));
  const bool named = plus != line.npos && plus > open + 1 && plus < close;
  const std::string offset(named ? line.substr(plus, close - plus) : line.substr(open + 1, close - open - 1));
  if (!named) return file + offset;
  const std::string symbol(line.substr(open + 1, plus - open - 1));
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> plain(
      abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status), &std::free);
  return (status == 0 && plain ? std::string(plain.get()) : symbol) + offset + " (" + file + ")";
}

/// Returns the position of a report's head, at the beginning of a line; npos if there is none.
std::size_t firstHead(std::string_view text, std::string_view head) {
  auto at = text.find(head);
  while (at != text.npos && at > 0 && text[at - 1] != '\n') at = text.find(head, at + 1);
  return at;
}

std::string takeLine(std::string_view& text) {
  const auto end = text.find('\n');
  std::string line(text.substr(0, end));
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  return line;
}

}  // namespace

int askSignal() {
  return SIGUSR1;
}

void CrashReport::install(int descriptor) {
  reportTo = descriptor;
  // Loads what backtrace() needs now, since a handler must not.
  std::array<void*, 4> calls;
  ::backtrace(calls.data(), static_cast<int>(calls.size()));
  stack_t stack = {};
  stack.ss_sp = signalStack.data();
  stack.ss_size = signalStack.size();
  ::sigaltstack(&stack, nullptr);
  for (const int signal : kFatal) handle(signal, onFatal, static_cast<int>(SA_RESETHAND));
  handle(askSignal(), onQuestion, SA_RESTART);
  ::on_exit(onExit, nullptr);
}

void CrashReport::watch(const std::vector<robotlink::Process*>& processes) {
  watched = &processes;
}

void CrashReport::enterThread(const robotlink::Process& process) {
  mine = &process;
  static thread_local const ThreadEnd end;
  // A stack overflow needs another stack for its report. It exists as long as the thread.
  static thread_local std::vector<char> stackOfThread(signalStack.size());
  stack_t stack = {};
  stack.ss_sp = stackOfThread.data();
  stack.ss_size = stackOfThread.size();
  ::sigaltstack(&stack, nullptr);
  for (ProcessThread& entry : processThreads) {
    const robotlink::Process* nobody = nullptr;
    if (!entry.process.compare_exchange_strong(nobody, &process)) continue;
    entry.thread = ::gettid();
    return;
  }
}

void CrashReport::suspect(const robotlink::Process* process) {
  suspected = 0;
  for (const ProcessThread& entry : processThreads) {
    if (process != nullptr && entry.process == process) suspected = entry.thread.load();
  }
}

bool CrashReport::hasEnd(std::string_view text) {
  return firstHead(text, kEndHead) != text.npos;
}

CrashReport CrashReport::parse(std::string_view text) {
  CrashReport report;
  const auto end = firstHead(text, kEndHead), asked = text.rfind(kAskedHead);
  if (end == text.npos && asked == text.npos) return report;
  text.remove_prefix(end != text.npos ? end + kEndHead.size() : asked + kAskedHead.size());
  while (!text.empty()) {
    if (text.starts_with(kStack)) break;
    const std::string line = takeLine(text);
    if (line.starts_with(kActivity)) report.activity = line.substr(kActivity.size());
    if (line.starts_with(kProcess)) report.process = line.substr(kProcess.size());
  }
  if (!text.empty()) text.remove_prefix(kStack.size());
  while (!text.empty()) {
    report.stack += readable(takeLine(text)) + "\n";
  }
  return report;
}

std::string CrashReport::place() const {
  return activity.empty() ? "" : " in " + activity + " of process " + process;
}

std::string endInWords(int status) {
  if (WIFEXITED(status)) return "called exit(" + std::to_string(WEXITSTATUS(status)) + ")";
  switch (WTERMSIG(status)) {
    case SIGSEGV:
      return "crashed with a segmentation fault (signal SIGSEGV)";
    case SIGABRT:
      return "was aborted (signal SIGABRT)";
    case SIGFPE:
      return "crashed with an arithmetic error, such as a division by zero (signal SIGFPE)";
    case SIGKILL:
      return "was killed (signal SIGKILL): by a user, or by the system when memory ran out";
    default: {
      const char* name = ::sigabbrev_np(WTERMSIG(status));
      const char* words = ::sigdescr_np(WTERMSIG(status));
      return "was ended by the signal " + (name != nullptr ? std::string("SIG") + name : "?") + " (" +
             (words != nullptr ? words : "unknown") + ")";
    }
  }
}

}  // namespace app
