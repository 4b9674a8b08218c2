// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/PioneerConnection.h"

#include <algorithm>
#include <array>

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

// How often the session gets a chance to act while waiting for bytes.
constexpr Duration kTurn = 20ms;
// The number of bytes read at once, and the number of such reads before read() returns, so that a line that
// floods cannot block it.
constexpr std::size_t kPiece = 4096;
constexpr int kMaxPieces = 64;

// No automatic reconnection: the program may not expect the robot to stand elsewhere with its motors off. It
// calls begin() when it is ready.
ClientSession::Options sessionOptions() {
  ClientSession::Options options;
  options.reconnect = false;
  return options;
}

}  // namespace

PioneerConnection::PioneerConnection(StreamOpener opener, std::shared_ptr<const Clock> clock)
    : opener_(std::move(opener)), clock_(std::move(clock)), client_(*this, sessionOptions()) {}

std::shared_ptr<ByteStream> PioneerConnection::stream() const {
  const std::lock_guard lock(mutex_);
  return stream_;
}

/// No effect if another line has replaced this one meanwhile.
tl::unexpected<Error> PioneerConnection::lose(const ByteStream& line, const Error& why) {
  const std::lock_guard lock(mutex_);
  if (stream_.get() == &line) {
    client_.linkClosed(why, clock_->now());
    stream_->close();
    stream_.reset();
    problem_ = why.text;
  }
  return tl::unexpected(why);
}

tl::unexpected<Error> PioneerConnection::notSent(const Error& why) const {
  if (stream_) return tl::unexpected(why);
  return failure("pioneer.not-connected", "the robot is not connected" +
                                              (problem_.empty() ? std::string() : " (" + problem_ + ")") +
                                              ": call begin() first");
}

Result<void> PioneerConnection::begin(Duration timeLimit) {
  end();
  const std::lock_guard reader(reading_);
  auto opened = opener_();
  if (!opened) {
    const std::lock_guard lock(mutex_);
    problem_ = opened.error().text;
    return tl::unexpected(opened.error());
  }
  const std::shared_ptr<ByteStream> line = std::move(*opened);
  {
    const std::lock_guard lock(mutex_);
    const Instant now = clock_->now();
    stream_ = line;
    client_.reset();
    latest_.clear();
    goal_.reset();
    ended_.reset();
    fresh_ = false;
    silence_ = {};
    problem_.clear();
    client_.open(now);
    client_.linkOpened(now);
  }
  return greet(*line, timeLimit);
}

Result<void> PioneerConnection::greet(const ByteStream& line, Duration timeLimit) {
  const Instant limit = clock_->now() + timeLimit;
  while (!inspect([](const auto& c) { return c.client_.isConnected(); })) {
    if (clock_->now() >= limit) {
      return lose(line, {"pioneer.no-robot",
                         "the line is open, but no robot answered in time: is it switched on, and does the "
                         "baud rate match?",
                         {},
                         {}});
    }
    const auto pumped = pump(kTurn);
    if (pumped) continue;
    if (pumped.error().id == "stream.lost") return refused(pumped.error());
    return tl::unexpected(pumped.error());
  }
  return {};
}

/// A robot serves one program; a simulator hangs up on a second one without explanation.
tl::unexpected<Error> PioneerConnection::refused(Error why) {
  why.id = "pioneer.refused";
  why.text += ". It closed the connection before the handshake: is another program driving this robot?";
  const std::lock_guard lock(mutex_);
  problem_ = why.text;
  return tl::unexpected(std::move(why));
}

void PioneerConnection::end() {
  {
    const std::lock_guard lock(mutex_);
    if (!stream_) return;
    client_.close(clock_->now());
  }
  // If this does not reach the robot, its watchdog stops it.
  flush();
  const std::lock_guard lock(mutex_);
  if (stream_) stream_->close();
  stream_.reset();
}

Result<bool> PioneerConnection::read(Duration timeout) {
  const std::lock_guard reader(reading_);
  const Instant limit = clock_->now() + timeout;
  const auto takeFresh = [this] {
    const std::lock_guard lock(mutex_);
    return std::exchange(fresh_, false);
  };
  for (;;) {
    if (const auto drained = drain(); !drained) return tl::unexpected(drained.error());
    if (takeFresh()) return true;
    const Duration left = limit - clock_->now();
    if (left <= Duration::zero()) return false;
    if (const auto pumped = pump(std::min(left, kTurn)); !pumped) return tl::unexpected(pumped.error());
  }
}

Result<MotionEnd> PioneerConnection::waitForMotion(Duration timeLimit) {
  if (!inspect([](const auto& c) { return c.goal_.has_value(); })) {
    return failure("pioneer.no-motion",
                   "there is nothing to wait for: call move(), turn() or turnTo() first");
  }
  const Instant limit = clock_->now() + timeLimit;
  for (;;) {
    if (const auto ended = inspect([](const auto& c) { return c.ended_; })) return *ended;
    const Duration left = limit - clock_->now();
    if (left <= Duration::zero()) return MotionEnd::kTimeout;
    if (const auto took = read(std::min<Duration>(left, 200ms)); !took) return tl::unexpected(took.error());
  }
}

/// Processes everything that has already arrived.
Result<void> PioneerConnection::drain() {
  for (int piece = 0; piece < kMaxPieces; ++piece) {
    const auto pumped = pump(Duration::zero());
    if (!pumped) return tl::unexpected(pumped.error());
    if (*pumped == Line::kSilent) break;
  }
  return {};
}

/// Does one turn: passes the bytes that arrive within `timeout` to the session and writes its outgoing bytes.
/// The caller holds reading_.
Result<PioneerConnection::Line> PioneerConnection::pump(Duration timeout) {
  const auto line = stream();
  if (!line) {
    const std::lock_guard lock(mutex_);
    return notSent({});
  }
  std::array<std::uint8_t, kPiece> bytes;
  const Instant before = clock_->now();
  const auto count = line->read(bytes, timeout);
  if (!count) return lose(*line, count.error());
  takeBytes(std::span(bytes).first(*count), clock_->now() - before);
  if (const auto flushed = flush(); !flushed) return tl::unexpected(flushed.error());
  const auto problem = inspect([](const auto& c) -> std::optional<Error> {
    return c.client_.wantsLink() ? std::nullopt : c.client_.session().problem();
  });
  if (problem) return lose(*line, *problem);
  return *count > 0 ? Line::kBusy : Line::kSilent;
}

void PioneerConnection::takeBytes(std::span<const std::uint8_t> bytes, Duration waited) {
  const std::lock_guard lock(mutex_);
  const Instant now = clock_->now();
  // Only time spent waiting counts: the bytes may have been there while the program did something else.
  silence_ = bytes.empty() ? silence_ + waited : Duration::zero();
  client_.lineSilent(silence_);
  client_.take(bytes, now);
  client_.tick(now);
}

void PioneerConnection::packetPassed(Direction direction, const Packet& packet, std::span<const std::uint8_t>,
                                     Instant) {
  if (direction == Direction::kFromRobot) latest_[packet.id] = packet;
}

void PioneerConnection::stateCame(const StandardInformation&, Instant) {
  fresh_ = true;
  if (goal_ && !ended_) ended_ = goal_->take(client_.state());
}

Result<void> PioneerConnection::flush() {
  const std::lock_guard writer(writing_);
  Bytes bytes;
  std::shared_ptr<ByteStream> line;
  {
    const std::lock_guard lock(mutex_);
    for (const Bytes& frame : client_.takeOutgoingFrames(clock_->now()))
      bytes.insert(bytes.end(), frame.begin(), frame.end());
    line = stream_;
  }
  if (!line || bytes.empty()) return {};
  if (const auto written = line->write(bytes); !written) return lose(*line, written.error());
  return {};
}

}  // namespace robotlink::arcos
