// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <mutex>

#include "robotlink/arcos/ClientSession.h"
#include "robotlink/arcos/MotionGoal.h"
#include "robotlink/arcos/StateDecoder.h"
#include "robotlink/arcos/codec/RangeScan.h"
#include "robotlink/arcos/stream/OpenStream.h"

namespace robotlink::arcos {

/// What is behind a PioneerRobot: the line, the session on it, and what it told; locked as is fit.
/// Thread-safe.
///
/// Locks are taken in the order of their declaration. Nobody waits for bytes, or for a line to take bytes,
/// while he holds `mutex_`, so that getters return at once.
class PioneerConnection {
 public:
  PioneerConnection(StreamOpener opener, std::shared_ptr<const Clock> clock);
  ~PioneerConnection() { end(); }
  PioneerConnection(const PioneerConnection&) = delete;
  PioneerConnection& operator=(const PioneerConnection&) = delete;

  Result<void> begin(Duration timeLimit);
  void end();
  Result<bool> read(Duration timeout);

  /// Sends a Command or a Packet. The session's time does not go on: while nobody reads it would take the
  /// robot for lost.
  template <typename Message>
  Result<void> send(const Message& message) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto sent = session_.send(message, clock_->now()); !sent) return notSent(sent.error());
    }
    return flush();
  }
  Result<void> resetOdometry();
  /// Sends a command whose end waitForMotion() waits for; `goalFor` says where it shall end.
  template <typename GoalFor>
  Result<void> beginMotion(const Command& command, GoalFor goalFor) {
    {
      const std::lock_guard lock(mutex_);
      goal_ = goalFor(decoder_.state(), clock_->now());
      ended_.reset();
    }
    return send(command);
  }
  Result<MotionEnd> waitForMotion(Duration timeLimit);
  void forgetScan();

  /// What `get` returns, who sees nothing change meanwhile.
  template <typename Get>
  auto inspect(Get get) const {
    const std::lock_guard lock(mutex_);
    return get(*this);
  }
  // For inspect() only.
  const ClientSession& session() const { return session_; }
  const StateDecoder& decoder() const { return decoder_; }
  const PacketParser& parser() const { return parser_; }
  const std::optional<RangeScan>& scan() const { return scan_; }
  const std::map<std::uint8_t, Packet>& latest() const { return latest_; }
  const std::string& problem() const { return problem_; }

 private:
  enum class Line { kSilent, kBusy };
  Result<Line> pump(Duration timeout);
  Result<void> drain();
  void takeBytes(std::span<const std::uint8_t> bytes, Duration waited);
  void takeFound(const PacketParser::Found& found, Instant now);
  Result<void> flush();
  Result<void> greet(const ByteStream& line, Duration timeLimit);
  std::shared_ptr<ByteStream> stream() const;
  tl::unexpected<Error> lose(const ByteStream& line, const Error& why);
  tl::unexpected<Error> refused(Error why);
  tl::unexpected<Error> notSent(const Error& why) const;

  const StreamOpener opener_;
  const std::shared_ptr<const Clock> clock_;

  std::mutex reading_;        // held by who takes bytes from the line, or opens it
  std::mutex writing_;        // held by who sends, so that packets stay whole and in their order
  mutable std::mutex mutex_;  // protects all that follows
  std::shared_ptr<ByteStream> stream_;
  PacketParser parser_;
  ClientSession session_;
  StateDecoder decoder_;
  std::optional<RangeScan> scan_;
  std::map<std::uint8_t, Packet> latest_;  // by number, of which there are 256
  bool fresh_ = false;                     // there is a state that no read() has told of
  Duration silence_{};                     // how long nothing came although one waited
  std::optional<MotionGoal> goal_;         // of the latest command that ends by itself
  std::optional<MotionEnd> ended_;
  std::string problem_;
};

}  // namespace robotlink::arcos
