// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/LaunchedPrograms.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ostream>
#include <thread>
#include <utility>

#include "app/robotctl/SpawnSelf.h"

namespace app {
namespace {

constexpr int kLookMs = 50;
constexpr std::size_t kMaxLine = 65'536;  // longer ones are printed in pieces

}  // namespace

LaunchedPrograms::~LaunchedPrograms() {
  kill();
  for (Program& program : programs_) {
    if (program.pid != 0) ::waitpid(program.pid, nullptr, 0);
    if (program.output >= 0) ::close(program.output);
  }
}

robotlink::Result<void> LaunchedPrograms::start(const std::string& name,
                                                const std::vector<std::string>& arguments,
                                                const std::string& again) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    return robotlink::failure("launch.start",
                              "program " + name + " cannot be started: " + std::strerror(errno), {}, {name});
  }
  const ::pid_t pid = spawnSelf(
      arguments, [&] { return ::dup2(ends[1], STDOUT_FILENO) >= 0 && ::dup2(ends[1], STDERR_FILENO) >= 0; });
  ::close(ends[1]);
  if (pid < 0) {
    ::close(ends[0]);
    return robotlink::failure("launch.start",
                              "program " + name + " cannot be started: " + std::strerror(errno), {}, {name});
  }
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  programs_.push_back({name, again, pid, ends[0]});
  out_ << "Program " << name << " runs as process " << pid << ".\n";
  return {};
}

void LaunchedPrograms::look() {
  std::vector<pollfd> fds;
  for (const Program& program : programs_) {
    if (program.output >= 0) fds.push_back({program.output, POLLIN, 0});
  }
  if (fds.empty()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kLookMs));
  } else {
    ::poll(fds.data(), fds.size(), kLookMs);
  }
  for (Program& program : programs_) {
    read(program);
    noteEnd(program);
  }
  out_.flush();
}

void LaunchedPrograms::read(Program& program) {
  char bytes[4096];
  while (program.output >= 0) {
    const ssize_t count = ::read(program.output, bytes, sizeof bytes);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (count <= 0) {
      if (!program.line.empty()) printLine(program, program.line);
      ::close(program.output);
      program.output = -1;
      return;
    }
    program.line.append(bytes, static_cast<std::size_t>(count));
    for (auto end = program.line.find('\n'); end != std::string::npos; end = program.line.find('\n')) {
      printLine(program, program.line.substr(0, end));
      program.line.erase(0, end + 1);
    }
    if (program.line.size() > kMaxLine) printLine(program, std::exchange(program.line, {}));
  }
}

void LaunchedPrograms::printLine(const Program& program, const std::string& line) {
  out_ << program.name << ": " << line << '\n';
}

void LaunchedPrograms::noteEnd(Program& program) {
  int status = 0;
  if (program.pid == 0 || ::waitpid(program.pid, &status, WNOHANG) != program.pid) return;
  program.pid = 0;
  read(program);
  const bool isWell = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  failed_ = failed_ || (!isWell && !asked_);
  if (asked_) return;
  std::string what = "has ended";
  if (WIFSIGNALED(status)) {
    what = "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) +
           ")";
  } else if (!isWell) {
    what = "has failed with status " + std::to_string(WEXITSTATUS(status));
  }
  out_ << "Program " << program.name << " " << what;
  out_ << (anyRuns() ? "; the others continue. To restart it: " + program.again : ".") << '\n';
}

void LaunchedPrograms::signalAll(int signal) {
  asked_ = true;
  for (const Program& program : programs_) {
    if (program.pid != 0) ::kill(program.pid, signal);
  }
}

void LaunchedPrograms::interrupt() {
  signalAll(SIGTERM);  // SIGINT may be ignored: whoever started this program in the background has said so
}

void LaunchedPrograms::kill() {
  signalAll(SIGKILL);
}

bool LaunchedPrograms::anyRuns() const {
  return std::ranges::any_of(programs_, [](const Program& program) { return program.pid != 0; });
}

}  // namespace app
