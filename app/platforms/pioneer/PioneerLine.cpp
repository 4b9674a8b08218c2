// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerLine.h"

#include <array>

#include "robotlink/arcos/stream/OpenStream.h"

namespace app {
namespace {

namespace arcos = robotlink::arcos;
using robotlink::Duration;

constexpr std::size_t kMaxEvents = 4096, kMaxOutgoing = 1024;
constexpr Duration kReadTimeout = std::chrono::milliseconds(5);
constexpr Duration kOpeningLimit = std::chrono::seconds(3);

}  // namespace

PioneerLine::PioneerLine(std::string url, const robotlink::Clock& clock)
    : clock_(clock), events_(kMaxEvents), outgoing_(kMaxOutgoing), url_(std::move(url)), thread_([this] {
        run();
      }) {}

PioneerLine::~PioneerLine() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
    wanted_ = false;
  }
  wakeUp_.notify_all();
  thread_.join();
}

void PioneerLine::send(Bytes bytes) {
  if (open_) outgoing_.push(std::move(bytes));
}

void PioneerLine::sendUrgent(Bytes bytes) {
  if (open_) outgoing_.pushAlways(std::move(bytes));
}

void PioneerLine::report(std::variant<Opened, Bytes, Lost> what) {
  Event event{std::move(what), clock_.now()};
  if (std::holds_alternative<Bytes>(event.what)) {
    events_.push(std::move(event));
  } else {
    // Each follows an open(), and the robot's driver would wait for it forever.
    events_.pushAlways(std::move(event));
  }
}

void PioneerLine::open() {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = !quit_;
  }
  wakeUp_.notify_all();
}

void PioneerLine::open(std::string url) {
  {
    const std::lock_guard lock(mutex_);
    url_ = std::move(url);
  }
  open();
}

bool PioneerLine::isIdle() {
  const std::lock_guard lock(mutex_);
  return !wanted_ && !busy_;
}

void PioneerLine::close() {
  const std::lock_guard lock(mutex_);
  wanted_ = false;
}

std::optional<std::string> PioneerLine::waitUntilWanted() {
  std::unique_lock lock(mutex_);
  busy_ = false;
  wakeUp_.wait(lock, [this] { return wanted_ || quit_; });
  if (quit_) return std::nullopt;
  busy_ = true;
  return url_;
}

bool PioneerLine::wanted() {
  const std::lock_guard lock(mutex_);
  return wanted_;
}

void PioneerLine::run() {
  while (const auto url = waitUntilWanted()) {
    if (auto stream = arcos::open(*url, kOpeningLimit)) {
      outgoing_.drain();
      open_ = true;
      report(Opened{});
      serve(**stream);
      open_ = false;
    } else {
      lose(stream.error());
    }
  }
}

void PioneerLine::serve(arcos::ByteStream& stream) {
  std::array<std::uint8_t, 4096> buffer{};
  while (wanted()) {
    const auto count = stream.read(buffer, kReadTimeout);
    if (!count) return lose(count.error());
    if (*count > 0) report(Bytes(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(*count)));
    if (!writeWaiting(stream)) return;
  }
  // Send what ends the connection properly.
  writeWaiting(stream);
}

void PioneerLine::lose(const robotlink::Error& why) {
  close();
  report(Lost{why});
}

bool PioneerLine::writeWaiting(arcos::ByteStream& stream) {
  for (const Bytes& bytes : outgoing_.drain()) {
    if (const auto written = stream.write(bytes); !written) {
      lose(written.error());
      return false;
    }
  }
  return true;
}

}  // namespace app
