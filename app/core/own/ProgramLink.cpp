// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/ProgramLink.h"

#include <google/protobuf/message.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

namespace app {
namespace {

constexpr std::size_t kHeadBytes = 4;
/// A limit above the size of any package; a longer one is invalid.
constexpr std::size_t kMaxBytes = std::size_t{1} << 30U;

std::size_t lengthIn(const std::string& head) {
  std::size_t length = 0;
  for (std::size_t i = kHeadBytes; i-- > 0;) length = length << 8U | static_cast<unsigned char>(head[i]);
  return length;
}

}  // namespace

ProgramLink::ProgramLink(int socket) : socket_(socket) {}

ProgramLink::~ProgramLink() {
  if (socket_ >= 0) ::close(socket_);
}

ProgramLink::ProgramLink(ProgramLink&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      out_(std::move(other.out_)),
      sent_(std::exchange(other.sent_, 0)),
      in_(std::move(other.in_)) {}

ProgramLink& ProgramLink::operator=(ProgramLink&& other) noexcept {
  if (this == &other) return *this;
  if (socket_ >= 0) ::close(socket_);
  socket_ = std::exchange(other.socket_, -1);
  out_ = std::move(other.out_);
  sent_ = std::exchange(other.sent_, 0);
  in_ = std::move(other.in_);
  return *this;
}

ProgramLink::Outcome ProgramLink::wait(short events, Time end) const {
  for (;;) {
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    pollfd look{socket_, events, 0};
    const int ready = ::poll(&look, 1, static_cast<int>(std::clamp<std::int64_t>(left, 0, 3'600'000)));
    if (ready > 0) return Outcome::kDone;
    if (ready == 0 && std::chrono::steady_clock::now() >= end) return Outcome::kTimeout;
    if (ready == 0) continue;  // poll() does not wait forever
    if (errno != EINTR) return Outcome::kEnded;
  }
}

ProgramLink::Outcome ProgramLink::send(const google::protobuf::Message& message,
                                       std::chrono::milliseconds limit) {
  if (sent_ == out_.size()) {
    out_.clear();
    sent_ = 0;
  }
  const std::size_t length = message.ByteSizeLong();
  if (length > kMaxBytes) return Outcome::kEnded;
  for (std::size_t i = 0; i < kHeadBytes; ++i) out_.push_back(static_cast<char>(length >> (8 * i)));
  message.AppendToString(&out_);
  return flush(std::chrono::steady_clock::now() + limit);
}

ProgramLink::Outcome ProgramLink::flush(Time end) {
  while (sent_ < out_.size()) {
    const ssize_t written =
        ::send(socket_, out_.data() + sent_, out_.size() - sent_, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (written > 0) {
      sent_ += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (const Outcome waited = wait(POLLOUT, end); waited != Outcome::kDone) return waited;
    } else if (errno != EINTR) {
      return Outcome::kEnded;
    }
  }
  return Outcome::kDone;
}

ProgramLink::Outcome ProgramLink::fill(std::size_t size, Time end) {
  while (in_.size() < size) {
    std::array<char, 65536> part;
    const ssize_t read = ::recv(socket_, part.data(), std::min(part.size(), size - in_.size()), MSG_DONTWAIT);
    if (read > 0) {
      in_.append(part.data(), static_cast<std::size_t>(read));
    } else if (read < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      if (const Outcome waited = wait(POLLIN, end); waited != Outcome::kDone) return waited;
    } else if (read == 0 || errno != EINTR) {
      return Outcome::kEnded;
    }
  }
  return Outcome::kDone;
}

ProgramLink::Outcome ProgramLink::receive(google::protobuf::Message& message,
                                          std::chrono::milliseconds limit) {
  const Time end = std::chrono::steady_clock::now() + limit;
  if (const Outcome sent = flush(end); sent != Outcome::kDone) return sent;
  if (const Outcome head = fill(kHeadBytes, end); head != Outcome::kDone) return head;
  const std::size_t length = lengthIn(in_);
  if (length > kMaxBytes) return Outcome::kEnded;
  if (const Outcome body = fill(kHeadBytes + length, end); body != Outcome::kDone) return body;
  const bool parsed = message.ParseFromArray(in_.data() + kHeadBytes, static_cast<int>(length));
  in_.clear();
  return parsed ? Outcome::kDone : Outcome::kEnded;
}

void ProgramLink::finish() {
  if (socket_ >= 0) ::shutdown(socket_, SHUT_WR);
}

}  // namespace app
