// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/arcos/codec/Conversation.h"
#include "widgets/models/PacketEntry.h"

namespace widgets {

class PacketModel;

// Between tables of packets and recorded conversations. Times of a conversation count from the beginning of
// its connection.

/// All rows. Where no connection begins in them, one begins at the first.
robotlink::arcos::Conversation conversationOf(const PacketModel& model);
std::vector<PacketEntry> entriesOf(const robotlink::arcos::Conversation& conversation);

/// What a client said, to be said again to a robot whose connection is already made: what makes and ends a
/// connection (SYNC, OPEN, CLOSE) is left out, as it would end that one.
struct ClientHalf {
  struct Said {
    robotlink::Duration at;  ///< since the first
    std::string bytes;
  };
  std::vector<Said> packets;
  int leftOut = 0;
};
ClientHalf clientHalf(const PacketModel& model);

/// Says a client's half again, at its times or one by one. A state machine that is fed with the time of the
/// robot's platform; one thread.
class ConversationReplay {
 public:
  enum class State : std::uint8_t { kIdle, kRunning, kStepping };

  /// Begins anew.
  void begin(ClientHalf half, bool stepping);
  void cancel() { state_ = State::kIdle; }
  /// From single steps to its own times, and back.
  void setStepping(bool stepping);

  /// What is due. If nobody asked for long (the view was hidden, the clock was set) it goes on where it was,
  /// without haste. After the last packet it is idle.
  std::vector<std::string> tick(robotlink::Instant now);
  /// The next one, whatever its time; empty after the last.
  std::string step();

  State state() const { return state_; }
  std::size_t done() const { return next_; }
  std::size_t count() const { return half_.packets.size(); }
  int leftOut() const { return half_.leftOut; }

 private:
  ClientHalf half_;
  State state_ = State::kIdle;
  std::size_t next_ = 0;
  robotlink::Duration reached_{0};  ///< of the conversation
  std::optional<robotlink::Instant> last_;
};

}  // namespace widgets
