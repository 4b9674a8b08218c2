// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/ProgramChild.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <thread>
#include <utility>

#include "app/core/own/OwnProgramMain.h"

namespace app {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kOrderlyEnd{1000}, kLook{2}, kReport{500};

/// Above the numbers that the program gets them as.
int movedUp(int descriptor) {
  const int moved = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 10);
  ::close(descriptor);
  return moved;
}

/// Starts the executable with a socket and a pipe at their numbers; returns an error number.
int spawn(pid_t& pid, const std::string& executable, const std::string& name, int socket, int reports) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, socket, kProgramSocket);
  posix_spawn_file_actions_adddup2(&actions, reports, kProgramReports);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  // The name that lists of processes show.
  std::error_code unknown;
  const auto target = std::filesystem::read_symlink(executable, unknown);
  std::string program = unknown ? executable : target.string(), argument = kProgramArgument, robot = name;
  std::array<char*, 4> arguments{program.data(), argument.data(), robot.data(), nullptr};
  const int failed =
      ::posix_spawn(&pid, executable.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

}  // namespace

robotlink::Result<ProgramChild> ProgramChild::start(const std::filesystem::path& executable,
                                                    const std::string& name) {
  const auto failed = [&](int number) {
    return robotlink::failure("program.start",
                              "the program of " + name + " cannot be started in its own process: " +
                                  std::strerror(number) + "; let it run in the workbench, or close something",
                              {executable.string(), 0, 0}, {name});
  };
  std::array<int, 2> sockets{}, pipes{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return failed(errno);
  ProgramLink mine(sockets[0]);
  if (::pipe2(pipes.data(), O_CLOEXEC) != 0) {
    const int number = errno;
    ::close(sockets[1]);
    return failed(number);
  }
  const int socket = movedUp(sockets[1]), reports = movedUp(pipes[1]);
  pid_t pid = 0;
  const int number = socket < 0 || reports < 0 ? EMFILE : spawn(pid, executable, name, socket, reports);
  ::close(socket);
  ::close(reports);
  if (number != 0) {
    ::close(pipes[0]);
    return failed(number);
  }
  ::fcntl(pipes[0], F_SETFL, O_NONBLOCK);
  ProgramChild child(pid, -1, pipes[0]);
  child.link_ = std::move(mine);
  return child;
}

ProgramChild::ProgramChild(pid_t pid, int socket, int reports)
    : pid_(pid), link_(socket), reports_(reports) {}

ProgramChild::ProgramChild(ProgramChild&& other) noexcept
    : pid_(std::exchange(other.pid_, 0)),
      link_(std::move(other.link_)),
      reports_(std::exchange(other.reports_, -1)),
      written_(std::move(other.written_)),
      status_(other.status_) {}

ProgramChild::~ProgramChild() {
  if (pid_ > 0 && !status_) {
    link_.finish();
    if (!endsWithin(kOrderlyEnd)) wait();
  }
  if (reports_ >= 0) ::close(reports_);
}

bool ProgramChild::isDebugged() const {
  std::ifstream in("/proc/" + std::to_string(pid_) + "/status");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("TracerPid:")) return line.find_first_of("123456789") != std::string::npos;
  }
  return false;
}

std::optional<int> ProgramChild::endsWithin(milliseconds limit) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!status_) {
    int status = 0;
    const pid_t ended = ::waitpid(pid_, &status, WNOHANG);
    if (ended == pid_) status_ = status;
    // Another caller has reaped the child: it has ended, but its status is unknown.
    if (ended < 0 && errno != EINTR) status_ = 0;
    if (status_ || std::chrono::steady_clock::now() >= end) break;
    readReports();  // A full pipe would hold it up.
    std::this_thread::sleep_for(kLook);
  }
  return status_;
}

void ProgramChild::kill() {
  if (!status_) ::kill(pid_, SIGKILL);
}

int ProgramChild::wait() {
  if (const auto status = endsWithin(kOrderlyEnd)) return *status;
  kill();
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  status_ = status;
  return status;
}

void ProgramChild::readReports() {
  std::array<char, 4096> part;
  for (ssize_t read = 0; (read = ::read(reports_, part.data(), part.size())) > 0;)
    written_.append(part.data(), static_cast<std::size_t>(read));
}

CrashReport ProgramChild::report() {
  readReports();
  return CrashReport::parse(written_);
}

CrashReport ProgramChild::ask() {
  readReports();
  // A program that does not answer may be about to end, and then has written the reason.
  if (!CrashReport::hasEnd(written_)) written_.clear();
  const std::size_t begin = written_.size();
  ::kill(pid_, askSignal());
  // Complete when nothing more comes for a moment.
  const auto end = std::chrono::steady_clock::now() + kReport;
  for (std::size_t before = begin; std::chrono::steady_clock::now() < end; before = written_.size()) {
    pollfd look{reports_, POLLIN, 0};
    ::poll(&look, 1, written_.size() == begin ? static_cast<int>(kReport.count()) : 20);
    readReports();
    if (written_.size() > begin && written_.size() == before) break;
  }
  return CrashReport::parse(std::string_view(written_).substr(begin));
}

}  // namespace app
