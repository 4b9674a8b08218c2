// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/SpawnSelf.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

namespace app {

::pid_t spawnSelf(std::vector<std::string> arguments, const std::function<bool()>& connect) {
  arguments.insert(arguments.begin(), "robotctl");
  std::vector<char*> words;
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const ::pid_t parent = ::getpid();
  const ::pid_t child = ::fork();
  if (child != 0) return child;
  // From here on only calls that are safe between fork() and exec().
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);  // it ended before that
  // Ctrl-C in a terminal is for the parent, which passes it on.
  ::setpgid(0, 0);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  if (connect()) ::execv("/proc/self/exe", words.data());
  ::_exit(127);
}

}  // namespace app
