// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/ClientSession.h"

#include <algorithm>

#include "robotlink/arcos/codec/ArcosCommandCatalog.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

using State = ClientSession::State;

/// The limit of unwritten bytes; beyond it commands are refused.
constexpr std::size_t kMaxOutgoing = 64U << 10U;
/// A robot that answers some SYNCs but never completes the handshake is given up after this many times the
/// number of tries.
constexpr int kRounds = 4;

/// A restarting controller sends packets with ids from this one on.
constexpr std::uint8_t kFirstControllerReset = 0xFE;

}  // namespace

void ClientSession::enter(State state, Instant now) {
  state_ = state;
  since_ = now;
}

void ClientSession::post(const Packet& packet, Instant now) {
  if (outgoingBytes_ > kMaxOutgoing) return;
  outgoing_.push_back(packet);
  outgoingBytes_ += packet.frameSize();
  sentAt_ = now;
}

void ClientSession::dropOutgoing() {
  outgoing_.clear();
  outgoingBytes_ = 0;
}

void ClientSession::post(CommandId id, Instant now) {
  post(toPacket(command(id)), now);
}

void ClientSession::post(CommandId id, int argument, Instant now) {
  post(toPacket(command(id, argument)), now);
}

void ClientSession::open(Instant now) {
  if (state_ != State::kClosed && state_ != State::kFailed) return;
  problem_.reset();
  failures_ = 0;
  enter(State::kWaitingForLink, now);
}

void ClientSession::connectNow(Instant now) {
  failures_ = 0;
  if (state_ == State::kPausing) enter(State::kWaitingForLink, now);
  if (state_ == State::kFailed) open(now);
}

void ClientSession::close(Instant now) {
  if (state_ == State::kConnected) post(CommandId::kEnable, 0, now);
  if (state_ == State::kConnected || state_ == State::kOpening) {
    post(CommandId::kClose, 1, now);
  } else {
    dropOutgoing();
  }
  problem_.reset();
  askedAt_.reset();
  enter(State::kClosed, now);
}

bool ClientSession::wantsLink() const {
  return state_ == State::kWaitingForLink || state_ == State::kSynchronizing ||
         state_ == State::kResynchronizing || state_ == State::kOpening || state_ == State::kConnected;
}

void ClientSession::linkOpened(Instant now) {
  if (state_ != State::kWaitingForLink) return;
  dropOutgoing();
  tries_ = unanswered_ = 0;
  damages_ = 0;
  heard_ = false;
  sendSync(0, now);
}

void ClientSession::linkClosed(const Error& why, Instant now) {
  if (!wantsLink()) return;
  if (state_ == State::kConnected) ++statistics_.losses;
  giveUpLine(why, now);
}

void ClientSession::giveUpLine(Error why, Instant now) {
  problem_ = std::move(why);
  dropOutgoing();
  pause_ = options_.firstPause;
  for (int i = 0; i < failures_ && pause_ < options_.longestPause; ++i) pause_ *= 2;
  pause_ = std::min(pause_, options_.longestPause);
  ++failures_;
  enter(options_.reconnect ? State::kPausing : State::kFailed, now);
}

void ClientSession::lose(Error why, Instant now) {
  ++statistics_.losses;
  giveUpLine(std::move(why), now);
}

void ClientSession::sendSync(int number, Instant now) {
  sync_ = number;
  enter(State::kSynchronizing, now);
  post(static_cast<CommandId>(number), now);
}

void ClientSession::resynchronize(Instant now) {
  post(CommandId::kClose, 1, now);
  enter(State::kResynchronizing, now);
}

/// Counts a failed try. Returns false if it was the last one; the line is then given up.
bool ClientSession::mayTryAgain(Error why, Instant now) {
  ++tries_;
  ++unanswered_;
  if (tries_ >= options_.syncTries || unanswered_ >= kRounds * options_.syncTries) {
    giveUpLine(std::move(why), now);
    return false;
  }
  problem_ = std::move(why);
  return true;
}

void ClientSession::retry(Error why, Instant now) {
  if (!mayTryAgain(std::move(why), now)) return;
  // A silent robot may still be in a connection of a client that is gone. It is sent a CLOSE only now and
  // then, because a robot that awaits SYNC2 would take it for that: both have the same id.
  if (state_ == State::kSynchronizing && tries_ == 1) {
    sendSync(sync_, now);
  } else if (state_ == State::kSynchronizing && sync_ < 2 && tries_ % 2 == 1) {
    sendSync(0, now);
  } else {
    resynchronize(now);
  }
}

/// The robot's controller restarts; its packets mean nothing meanwhile. The line is good, so the handshake
/// begins again on it.
void ClientSession::restart(Instant now) {
  if (state_ == State::kConnected) {
    ++statistics_.losses;
    tries_ = unanswered_ = 0;
  }
  if (mayTryAgain({"arcos.controller-reset", "the robot's controller restarts", {}, {}}, now)) {
    enter(State::kResynchronizing, now);
  }
}

void ClientSession::take(const PacketParser::Found& found, Instant now) {
  std::visit([&](const auto& value) { (void)take(value, now); }, found);
}

void ClientSession::take(const DamagedBytes&, Instant) {
  ++damages_;
}

ClientSession::News ClientSession::take(const Packet& packet, Instant now) {
  if (!wantsLink() || state_ == State::kWaitingForLink) return News::kNothing;
  ++statistics_.packets;
  heard_ = true;
  packetAt_ = now;
  if (state_ == State::kResynchronizing) return News::kNothing;
  if (packet.id >= kFirstControllerReset) {
    restart(now);
    return News::kNothing;
  }
  return state_ == State::kSynchronizing ? applyHandshake(packet, now) : applyConnection(packet, now);
}

ClientSession::News ClientSession::overhear(const Packet& packet, Instant now) {
  return packet.id == Identity::kId ? takeIdentity(packet) : applyConnection(packet, now);
}

ClientSession::News ClientSession::takeIdentity(const Packet& packet) {
  auto identity = decode<Identity>(packet);
  if (!identity) {
    ++statistics_.undecodable;
    return News::kNothing;
  }
  identity_ = std::move(*identity);
  return News::kIdentity;
}

ClientSession::News ClientSession::applyHandshake(const Packet& packet, Instant now) {
  if (packet.id == sync_ && sync_ < 2) {
    tries_ = 0;
    sendSync(sync_ + 1, now);
  } else if (packet.id == sync_) {
    if (takeIdentity(packet) == News::kNothing) return News::kNothing;
    tries_ = 0;
    opened_ = informed_ = configured_ = false;
    askedAt_.reset();
    enter(State::kOpening, now);
    return News::kIdentity;
  } else if (packet.id > 2) {
    // A late reply to an earlier SYNC is ignored; any other packet belongs to a connection that was never
    // closed.
    const Error why{"arcos.busy",
                    "the robot is in another connection, which it does not close; end the other client",
                    {},
                    {}};
    if (mayTryAgain(why, now)) resynchronize(now);
  }
  return News::kNothing;
}

void ClientSession::tick(Instant now) {
  switch (state_) {
    case State::kPausing:
      if (now - since_ >= pause_) enter(State::kWaitingForLink, now);
      break;
    case State::kSynchronizing:
      if (now - since_ >= options_.syncTimeout) retry(silence(), now);
      break;
    case State::kResynchronizing:
      if (now - since_ >= options_.closePause) sendSync(0, now);
      break;
    case State::kOpening:
      tickOpening(now);
      break;
    case State::kConnected:
      tickConnected(now);
      break;
    case State::kClosed:
    case State::kWaitingForLink:
    case State::kFailed:
      break;
  }
}

Bytes ClientSession::takeOutgoing() {
  Bytes bytes;
  bytes.reserve(outgoingBytes_);
  for (const Packet& packet : takePackets()) append(packet, bytes);
  return bytes;
}

std::vector<Packet> ClientSession::takePackets() {
  outgoingBytes_ = 0;
  return std::exchange(outgoing_, {});
}

Result<void> ClientSession::send(const Command& command, Instant now) {
  if (auto fits = check(command); !fits) return fits;
  return send(toPacket(command), now);
}

Result<void> ClientSession::send(const Packet& packet, Instant now) {
  if (state_ != State::kConnected) {
    return failure(
        "arcos.not-connected",
        nameOf(packet.id) + " cannot be sent: there is no connection to the robot (" + describe() + ")");
  }
  if (packet.count() > kMaxSentCount) {
    return failure("arcos.long-command", nameOf(packet.id) + " has " + std::to_string(packet.data.size()) +
                                             " bytes of data; robots take at most " +
                                             std::to_string(kMaxSentData));
  }
  if (outgoingBytes_ > kMaxOutgoing) {
    return failure("arcos.line-full", nameOf(packet.id) + " cannot be sent: the line takes no more bytes");
  }
  post(packet, now);
  return {};
}

}  // namespace robotlink::arcos
