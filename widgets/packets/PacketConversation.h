// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/arcos/codec/Conversation.h"
#include "widgets/packets/PacketEntry.h"

// Conversion between tables of packets and recorded conversations (robotlink/arcos/ARCOS.md), and replay of
// the client's part of one. Times of a conversation count from the beginning of each connection.
namespace widgets {

class PacketModel;

/// Converts all rows. If they do not begin with a new connection, one is added at the first row.
robotlink::arcos::Conversation conversationOf(const PacketModel& model);
/// Connections follow each other in time; the first begins at instant 0.
std::vector<PacketEntry> entriesOf(const robotlink::arcos::Conversation& conversation);

/// The packets that a client sent, for sending them again to a robot that is connected already. OPEN and
/// CLOSE, and so SYNC1 and SYNC2, which have the same numbers, are left out, since they would end that
/// connection. SYNC0 has the number of PULSE and is kept.
struct ClientHalf {
  /// A packet with header and checksum.
  struct Said {
    /// Time since the first packet.
    robotlink::Duration at;
    std::string bytes;
  };
  std::vector<Said> packets;
  /// Number of packets that were left out.
  int leftOut = 0;
};
/// Collects the client's packets of all rows.
ClientHalf clientHalf(const PacketModel& model);

/// Replays a client's packets, at their times or one by one. A state machine that is fed with the time of the
/// robot's platform; it sends nothing itself. Not thread-safe.
class ConversationReplay {
 public:
  /// kIdle: not begun, or at the end; kRunning: by time; kStepping: by step().
  enum class State : std::uint8_t { kIdle, kRunning, kStepping };

  /// Starts from the first packet; remains idle if there is none.
  void begin(ClientHalf half, bool stepping);
  void cancel() { state_ = State::kIdle; }
  /// Switches between single steps and the packets' times; ignored while idle.
  void setStepping(bool stepping);

  /// Returns the packets that are due. At most 250 ms pass per call, so that after a pause (a hidden view, a
  /// clock that was set) packets do not come in a burst. Idle after the last packet.
  std::vector<std::string> tick(robotlink::Instant now);
  /// Returns the next packet whatever its time; empty unless kStepping.
  std::string step();

  State state() const { return state_; }
  /// Number of packets that were returned.
  std::size_t done() const { return next_; }
  /// Number of all packets.
  std::size_t count() const { return half_.packets.size(); }
  int leftOut() const { return half_.leftOut; }

 private:
  ClientHalf half_;
  State state_ = State::kIdle;
  std::size_t next_ = 0;
  /// Time within the conversation.
  robotlink::Duration reached_{0};
  /// Time of the last tick; unset before the first one after begin().
  std::optional<robotlink::Instant> last_;
};

}  // namespace widgets
