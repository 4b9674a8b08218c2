// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgramMain.h"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "app/core/own/CrashReport.h"
#include "app/core/own/OwnProgramServer.h"
#include "app/core/own/ProgramLink.h"
#include "app/core/plugins/Plugins.h"

namespace app {
namespace {

using robotcontrol::WireOrder;

constexpr std::chrono::hours kForever{24 * 365};
/// The time that a program may take to end after its host has ended.
constexpr std::chrono::milliseconds kGrace{1000};

/// Ends this process when the host has ended, whatever the program does then.
void watchHost() {
  // No robotlink::PacedThread: the thread waits for the socket, and is never joined but ends the process.
  std::thread([] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    pollfd look{kProgramSocket, 0, 0};
    while (::poll(&look, 1, -1) < 0) {
    }
    std::this_thread::sleep_for(kGrace);
    ::_exit(0);
  }).detach();
}

void limitMemory(std::uint64_t bytes) {
#ifndef ROBOTCONTROL_SANITIZED
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &limit);
#else
  (void)bytes;  // Sanitizers reserve far more than they use.
#endif
}

int run(const std::string& robot) {
  ::prctl(PR_SET_NAME, ("program " + robot).c_str());
  ::close_range(kProgramReports + 1, ~0U, 0);
  // Ctrl-C in a terminal is for the host, which then ends this process.
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  CrashReport::install(kProgramReports);
  watchHost();
  ProgramLink link(kProgramSocket);
  WireOrder order;
  if (link.receive(order, kForever) != ProgramLink::Outcome::kDone || !order.has_setup()) ::_exit(0);
  limitMemory(order.setup().memory_limit());
  {
    OwnProgramServer server(std::move(link), kProgramSocket, order.setup());
    server.make(order.setup());
    server.serve();
    // Threads of modules may never return, so the process exits without joining them.
    if (order.setup().threads()) ::_exit(0);
  }
  // exit() would look as if the program had called it.
  ::_exit(0);
}

}  // namespace

std::optional<int> ownProgramMain(int argc, char** argv) {
  if (argc < 3 || std::string(argv[1]) != kProgramArgument) return std::nullopt;
  // Failures were reported by the program that has started this one.
  loadPluginsOfParent();
  // Started by hand, there is no host at the other end.
  pollfd look{kProgramSocket, 0, 0};
  if (::poll(&look, 1, 0) < 0 || (look.revents & POLLNVAL) != 0) return 2;
  return run(argv[2]);
}

}  // namespace app
