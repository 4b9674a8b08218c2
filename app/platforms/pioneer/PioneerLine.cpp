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
    : clock_(clock),
      events_(kMaxEvents),
      outgoing_(kMaxOutgoing),
      url_(std::move(url)),
      thread_({.due = [this] { return due(); }, .step = [this] { step(); }}) {}

PioneerLine::~PioneerLine() {
  close();
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
    wanted_ = true;
  }
  thread_.wake();
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

std::optional<robotlink::PacedThread::Clock::time_point> PioneerLine::due() {
  if (!wanted()) return std::nullopt;
  return robotlink::PacedThread::Clock::time_point();
}

std::optional<std::string> PioneerLine::beginUse() {
  const std::lock_guard lock(mutex_);
  if (!wanted_) return std::nullopt;
  busy_ = true;
  return url_;
}

bool PioneerLine::wanted() {
  const std::lock_guard lock(mutex_);
  return wanted_;
}

void PioneerLine::step() {
  const auto url = beginUse();
  if (!url) return;
  if (auto stream = arcos::open(*url, kOpeningLimit)) {
    outgoing_.drain();
    open_ = true;
    report(Opened{});
    serve(**stream);
    open_ = false;
  } else {
    lose(stream.error());
  }
  const std::lock_guard lock(mutex_);
  busy_ = false;
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
