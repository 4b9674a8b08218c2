// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/threads/HandoverSignal.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace robotlink {

HandoverSignal::HandoverSignal() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
    throw std::system_error(errno, std::generic_category(), "no pipe between two threads");
  read_ = ends[0];
  write_ = ends[1];
}

HandoverSignal::~HandoverSignal() {
  ::close(read_);
  ::close(write_);
}

void HandoverSignal::signal() {
  // Writing fails only if the pipe is full, which is a signal already.
  while (::write(write_, "", 1) < 0 && errno == EINTR) continue;
}

bool HandoverSignal::poll(int milliseconds) {
  pollfd ready{read_, POLLIN, 0};
  if (::poll(&ready, 1, milliseconds) <= 0) return false;
  std::array<char, 64> signals{};
  while (::read(read_, signals.data(), signals.size()) == static_cast<ssize_t>(signals.size())) continue;
  return true;
}

bool HandoverSignal::wait(std::chrono::milliseconds limit) {
  return poll(static_cast<int>(limit.count()));
}

void HandoverSignal::wait() {
  while (!poll(-1)) continue;
}

}  // namespace robotlink
