// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/DescriptorStream.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace robotlink::arcos {
namespace {

bool isTemporary(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

DescriptorStream::DescriptorStream(int descriptor, std::string address)
    : descriptor_(descriptor), wake_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)), address_(std::move(address)) {
  ::fcntl(descriptor_, F_SETFL, ::fcntl(descriptor_, F_GETFL) | O_NONBLOCK);
  ::fcntl(descriptor_, F_SETFD, FD_CLOEXEC);
}

DescriptorStream::~DescriptorStream() {
  ::close(descriptor_);
  if (wake_ >= 0) ::close(wake_);
}

DescriptorStream::Wait DescriptorStream::waitFor(short events, Duration timeout) const {
  using SteadyTime = std::chrono::steady_clock;
  const auto deadline = SteadyTime::now() + std::max(timeout, Duration::zero());
  std::array<pollfd, 2> polled = {{{descriptor_, events, 0}, {wake_, POLLIN, 0}}};
  for (;;) {
    if (closed_) return Wait::kClosed;
    const auto left =
        std::max(Duration::zero(), std::chrono::duration_cast<Duration>(deadline - SteadyTime::now()));
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
    const timespec limit{whole.count(), (left - whole).count()};
    const int ready = ::ppoll(polled.data(), polled.size(), &limit, nullptr);
    if (ready == 0) return Wait::kTimedOut;
    // A line that was hung up is ready, too: the next read or write returns the reason.
    if (ready > 0 && polled[0].revents != 0) return Wait::kReady;
  }
}

tl::unexpected<Error> DescriptorStream::closedHere() const {
  return failure("stream.closed", "the line to " + address_ + " was closed by this program", {}, {address_});
}

tl::unexpected<Error> DescriptorStream::failed(int error) const {
  if (closed_) return closedHere();
  return failure("stream.lost", describeLoss(error), {}, {address_});
}

Result<std::size_t> DescriptorStream::read(std::span<std::uint8_t> bytes, Duration timeout) {
  if (bytes.empty()) return std::size_t{0};
  for (bool waited = false;; waited = true) {
    if (closed_) return closedHere();
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count > 0) return static_cast<std::size_t>(count);
    if (count == 0) return failed(0);
    if (!isTemporary(errno)) return failed(errno);
    if (waited) return std::size_t{0};
    switch (waitFor(POLLIN, timeout)) {
      case Wait::kReady:
        break;
      case Wait::kTimedOut:
        return std::size_t{0};
      case Wait::kClosed:
        return closedHere();
    }
  }
}

Result<void> DescriptorStream::write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    if (closed_) return closedHere();
    const ssize_t count = writeSome(bytes);
    if (count >= 0) {
      bytes = bytes.subspan(static_cast<std::size_t>(count));
      continue;
    }
    if (!isTemporary(errno)) return failed(errno);
    switch (waitFor(POLLOUT, kWriteLimit)) {
      case Wait::kReady:
        break;
      case Wait::kTimedOut:
        return failure(
            "stream.busy",
            address_ + " accepts no more bytes; is it still switched on? Close the line and connect again",
            {}, {address_});
      case Wait::kClosed:
        return closedHere();
    }
  }
  return {};
}

void DescriptorStream::close() {
  closed_ = true;
  const std::uint64_t one = 1;
  // Fails only if the counter is at its maximum; then the waiting thread is awake already.
  [[maybe_unused]] const auto written = ::write(wake_, &one, sizeof one);
}

}  // namespace robotlink::arcos
