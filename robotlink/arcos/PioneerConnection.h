// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <mutex>

#include "robotlink/arcos/MotionGoal.h"
#include "robotlink/arcos/PioneerClient.h"
#include "robotlink/arcos/stream/OpenStream.h"

namespace robotlink::arcos {

/// The implementation of PioneerRobot: the line, the client on it, and the received data. Thread-safe.
///
/// The mutexes are locked in the order of their declaration. No thread blocks on the line while it holds
/// `mutex_`, so getters return immediately.
class PioneerConnection final : private PioneerClient::Listener {
 public:
  /// `clock` must advance while the line waits for bytes.
  PioneerConnection(StreamOpener opener, std::shared_ptr<const Clock> clock);
  ~PioneerConnection() override { end(); }
  PioneerConnection(const PioneerConnection&) = delete;
  PioneerConnection& operator=(const PioneerConnection&) = delete;

  /// Opens the line and performs the handshake; replaces an existing connection.
  Result<void> begin(Duration timeLimit);
  /// Says goodbye to the robot and closes the line.
  void end();
  /// Processes what has arrived; waits at most `timeout` for a new state. Returns true if there is one.
  Result<bool> read(Duration timeout);

  /// Sends a Command or a Packet. Does not advance the session's time: after a pause without read(), the
  /// session would take the robot for lost.
  template <typename Message>
  Result<void> send(const Message& message) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto sent = client_.send(message, clock_->now()); !sent) return notSent(sent.error());
    }
    return flush();
  }
  /// Sends what `act(client, now)` gives to the client, a command or several.
  template <typename Act>
  Result<void> sendBy(Act act) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto sent = act(client_, clock_->now()); !sent) return notSent(sent.error());
    }
    return flush();
  }
  /// Sends a command whose end waitForMotion() detects; `goalFor(state, now)` returns its goal.
  template <typename GoalFor>
  Result<void> beginMotion(const Command& command, GoalFor goalFor) {
    {
      const std::lock_guard lock(mutex_);
      goal_ = goalFor(client_.state(), clock_->now());
      ended_.reset();
    }
    return send(command);
  }
  /// Reads until the goal of beginMotion() is decided.
  Result<MotionEnd> waitForMotion(Duration timeLimit);

  /// Returns get(*this) under the lock, so that nothing changes meanwhile.
  template <typename Get>
  auto inspect(Get get) const {
    const std::lock_guard lock(mutex_);
    return get(*this);
  }
  // For inspect() only.
  const PioneerClient& client() const { return client_; }
  const std::map<std::uint8_t, Packet>& latest() const { return latest_; }
  const std::string& problem() const { return problem_; }

 private:
  /// Whether the last pump() received bytes.
  enum class Line { kSilent, kBusy };
  /// Reads once, processes the bytes, writes what the session wants to send. The caller holds reading_.
  Result<Line> pump(Duration timeout);
  /// Processes everything that has already arrived.
  Result<void> drain();
  void takeBytes(std::span<const std::uint8_t> bytes, Duration waited);
  void packetPassed(Direction direction, const Packet& packet, std::span<const std::uint8_t> frame,
                    Instant now) override;
  void stateCame(const StandardInformation& information, Instant now) override;
  /// Writes the client's outgoing bytes.
  Result<void> flush();
  /// Pumps until the session is connected.
  Result<void> greet(const ByteStream& line, Duration timeLimit);
  std::shared_ptr<ByteStream> stream() const;
  /// Closes the line because of an error, unless another one has replaced it.
  tl::unexpected<Error> lose(const ByteStream& line, const Error& why);
  /// The error for a robot that hung up before the handshake.
  tl::unexpected<Error> refused(Error why);
  tl::unexpected<Error> notSent(const Error& why) const;

  const StreamOpener opener_;
  const std::shared_ptr<const Clock> clock_;

  /// Held while bytes are read from the line or a line is opened.
  std::mutex reading_;
  /// Held while bytes are written, so that packets stay whole and in order.
  std::mutex writing_;
  /// Protects everything below.
  mutable std::mutex mutex_;
  std::shared_ptr<ByteStream> stream_;
  PioneerClient client_;
  /// Keyed by packet id, at most 256.
  std::map<std::uint8_t, Packet> latest_;
  /// Whether a state has arrived that no read() has reported yet.
  bool fresh_ = false;
  /// How long no bytes came while waiting for them.
  Duration silence_{};
  /// Goal of the latest command that ends by itself.
  std::optional<MotionGoal> goal_;
  /// How the motion ended; empty while it is in progress.
  std::optional<MotionEnd> ended_;
  /// The last error for users; empty if there is none.
  std::string problem_;
};

}  // namespace robotlink::arcos
