// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/ClientSession.h"

#include <algorithm>

#include "robotlink/arcos/CommandTable.h"

namespace robotlink::arcos {
namespace {

using State = ClientSession::State;

/// What an owner may leave unwritten before commands are refused.
constexpr std::size_t kMaximumOutgoing = 64U << 10U;
constexpr Duration kGapWindow = std::chrono::seconds(5);
constexpr std::size_t kMaximumGaps = 256;
/// A robot that answers some SYNCs but never all of them is given up after so many times as many tries.
constexpr int kRounds = 4;

/// A controller that restarts says so with these.
bool isControllerReset(std::uint8_t id) {
  return id >= 0xFE;
}

bool isInformation(std::uint8_t id) {
  return id == StandardInformation::kStandingId || id == StandardInformation::kMovingId;
}

Error error(const char* id, std::string text) {
  return {id, std::move(text), {}, {}};
}

}  // namespace

const char* nameOf(State state) {
  switch (state) {
    case State::kClosed:
      return "closed";
    case State::kPausing:
      return "pausing";
    case State::kWaitingForLink:
      return "waiting for the line";
    case State::kSynchronizing:
      return "synchronizing";
    case State::kResynchronizing:
      return "resynchronizing";
    case State::kOpening:
      return "opening";
    case State::kConnected:
      return "connected";
    case State::kFailed:
      return "failed";
  }
  return "";
}

void ClientSession::enter(State state, Instant now) {
  state_ = state;
  since_ = now;
}

void ClientSession::post(const Packet& packet, Instant now) {
  if (outgoing_.size() > kMaximumOutgoing) return;
  append(packet, outgoing_);
  sentAt_ = now;
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

void ClientSession::close(Instant now) {
  if (state_ == State::kConnected) post(CommandId::kEnable, 0, now);
  if (state_ == State::kConnected || state_ == State::kOpening) {
    post(CommandId::kClose, 1, now);
  } else {
    outgoing_.clear();
  }
  problem_.reset();
  enter(State::kClosed, now);
}

bool ClientSession::wantsLink() const {
  return state_ == State::kWaitingForLink || state_ == State::kSynchronizing ||
         state_ == State::kResynchronizing || state_ == State::kOpening || state_ == State::kConnected;
}

void ClientSession::linkOpened(Instant now) {
  if (state_ != State::kWaitingForLink) return;
  outgoing_.clear();
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
  outgoing_.clear();
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

/// Counts a try that failed. False if it was the last one: then the line is given up.
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
  // A robot that is silent may be in the connection of somebody who is gone. It is told to close that one
  // only now and then, because one that awaits SYNC2 takes CLOSE for it: they have the same number.
  if (state_ == State::kSynchronizing && tries_ == 1) {
    sendSync(sync_, now);
  } else if (state_ == State::kSynchronizing && sync_ < 2 && tries_ % 2 == 1) {
    sendSync(0, now);
  } else {
    resynchronize(now);
  }
}

/// The robot's controller restarts: what it says meanwhile means nothing.
void ClientSession::restart(Instant now) {
  if (mayTryAgain(error("arcos.controller-reset", "the robot's controller restarts"), now)) {
    enter(State::kResynchronizing, now);
  }
}

Error ClientSession::silence() const {
  if (damages_ > 0 && !heard_) {
    return error(
        "arcos.only-damage",
        "bytes come from the robot, but no packet is whole: set the serial line to the robot's rate (9600 "
        "usually), and check that this is a robot");
  }
  if (state_ == State::kOpening) {
    return error("arcos.no-information", "the robot answers, but sends no standard information after OPEN");
  }
  return error("arcos.no-answer",
               "no answer to SYNC" + std::to_string(sync_) +
                   ": check that the robot is turned on and connected, that the address is right, "
                   "and that no other client drives it");
}

void ClientSession::take(const PacketParser::Found& found, Instant now) {
  std::visit([&](const auto& value) { take(value, now); }, found);
}

void ClientSession::take(const Damage&, Instant) {
  ++damages_;
}

void ClientSession::take(const Packet& packet, Instant now) {
  if (!wantsLink() || state_ == State::kWaitingForLink) return;
  ++statistics_.packets;
  heard_ = true;
  packetAt_ = now;
  if (state_ == State::kSynchronizing) {
    takeInHandshake(packet, now);
  } else if (state_ != State::kResynchronizing) {
    takeInConnection(packet, now);
  }
}

void ClientSession::takeInHandshake(const Packet& packet, Instant now) {
  if (packet.id == sync_ && sync_ < 2) {
    tries_ = 0;
    sendSync(sync_ + 1, now);
  } else if (packet.id == sync_) {
    auto identity = decodeIdentity(packet);
    if (!identity) {
      ++statistics_.undecodable;
      return;
    }
    identity_ = std::move(*identity);
    tries_ = 0;
    opened_ = informed_ = configured_ = false;
    askedAt_.reset();
    enter(State::kOpening, now);
  } else if (isControllerReset(packet.id)) {
    restart(now);
  } else if (packet.id > 2) {
    // The answer to an earlier SYNC comes late; anything else is from a connection that was never closed.
    const Error why = error("arcos.busy", "the robot is in another connection, and does not close it");
    if (mayTryAgain(why, now)) resynchronize(now);
  }
}

void ClientSession::takeInConnection(const Packet& packet, Instant now) {
  if (isInformation(packet.id)) {
    takeInformation(packet, now);
  } else if (packet.id == Configuration::kId) {
    takeConfiguration(packet, now);
  } else if (packet.id == LaserPacket::kPlainId || packet.id == LaserPacket::kExtendedId) {
    takeLaser(packet, now);
  } else if (isControllerReset(packet.id)) {
    // The line is good, so the handshake begins again on it.
    if (state_ == State::kConnected) {
      ++statistics_.losses;
      tries_ = unanswered_ = 0;
    }
    restart(now);
  }
}

void ClientSession::takeInformation(const Packet& packet, Instant now) {
  auto information = decodeStandardInformation(packet);
  if (!information) {
    ++statistics_.undecodable;
    return;
  }
  if (informed_) {
    gaps_.push_back({now, now - informationAt_});
    if (gaps_.size() > kMaximumGaps) gaps_.pop_front();
  }
  information_ = std::move(*information);
  informationAt_ = now;
  informed_ = true;
  ++statistics_.information;
  if (state_ == State::kOpening && configured_) becomeConnected(now);
}

void ClientSession::takeConfiguration(const Packet& packet, Instant now) {
  auto configuration = decodeConfiguration(packet);
  if (!configuration) {
    ++statistics_.undecodable;
    return;
  }
  configuration_ = std::move(*configuration);
  if (askedAt_ && !askedTwice_) statistics_.roundTrip = now - *askedAt_;
  askedAt_.reset();
  configured_ = true;
  if (state_ == State::kOpening && informed_) becomeConnected(now);
}

void ClientSession::takeLaser(const Packet& packet, Instant now) {
  const auto part = decodeLaser(packet);
  if (!part) {
    ++statistics_.undecodable;
    return;
  }
  auto scan = assembler_.take(*part, informed_ ? &*information_ : nullptr, now);
  statistics_.incompleteScans = assembler_.incompleteScans();
  if (!scan) return;
  scan_ = std::move(*scan);
  ++statistics_.scans;
}

void ClientSession::askConfiguration(Instant now) {
  askedTwice_ = askedAt_.has_value();
  askedAt_ = lastAsked_ = now;
  post(CommandId::kConfig, 1, now);
}

void ClientSession::becomeConnected(Instant now) {
  gaps_.clear();
  problem_.reset();
  failures_ = tries_ = unanswered_ = 0;
  ++statistics_.connections;
  enter(State::kConnected, now);
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

void ClientSession::tickOpening(Instant now) {
  if (!opened_) {
    if (now - since_ < options_.openDelay) return;
    opened_ = true;
    openedAt_ = openSentAt_ = now;
    post(CommandId::kOpen, 1, now);
    askConfiguration(now);
    return;
  }
  const bool mayStillCome = now - openedAt_ < options_.configTimeout;
  if (informed_ && !configured_ && !mayStillCome) {
    becomeConnected(now);
  } else if (!informed_ && now - openedAt_ >= options_.openTimeout) {
    retry(silence(), now);
  } else if (!informed_ && now - openSentAt_ >= options_.syncTimeout) {
    openSentAt_ = now;
    post(CommandId::kOpen, 1, now);
  } else if (!configured_ && mayStillCome && now - lastAsked_ >= options_.configInterval) {
    askConfiguration(now);
  }
}

void ClientSession::tickConnected(Instant now) {
  const std::string limit =
      std::to_string(std::chrono::duration_cast<std::chrono::seconds>(options_.linkTimeout).count());
  if (now - packetAt_ >= options_.linkTimeout) {
    lose(error("arcos.lost", "nothing came from the robot for " + limit + " s"), now);
    return;
  }
  if (now - informationAt_ >= options_.linkTimeout) {
    lose(error("arcos.lost-information",
               "packets come from the robot, but no standard information for " + limit + " s"),
         now);
    return;
  }
  if (now - sentAt_ >= options_.pulseInterval) post(CommandId::kPulse, now);
  if (options_.roundTripInterval > Duration::zero() && now - lastAsked_ >= options_.roundTripInterval) {
    askedAt_.reset();
    askConfiguration(now);
  }
  while (!gaps_.empty() && now - gaps_.front().at > kGapWindow) gaps_.pop_front();
  statistics_.longestGap = std::max(now - informationAt_, Duration::zero());
  for (const Gap& gap : gaps_) statistics_.longestGap = std::max(statistics_.longestGap, gap.length);
}

Bytes ClientSession::takeOutgoing() {
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
  if (packet.count() > kMaximumSentCount) {
    return failure("arcos.long-command", nameOf(packet.id) + " has " + std::to_string(packet.data.size()) +
                                             " bytes of data; robots take at most " +
                                             std::to_string(kMaximumSentData));
  }
  if (outgoing_.size() > kMaximumOutgoing) {
    return failure("arcos.line-full", nameOf(packet.id) + " cannot be sent: the line takes no more bytes");
  }
  post(packet, now);
  return {};
}

std::string ClientSession::describe() const {
  const std::string after = problem_ ? " (" + problem_->text + ")" : "";
  switch (state_) {
    case State::kClosed:
      return "closed";
    case State::kPausing:
      return "waits " + std::to_string(std::chrono::duration_cast<std::chrono::seconds>(pause_).count()) +
             " s before it connects again" + after;
    case State::kWaitingForLink:
      return "opens the line" + after;
    case State::kSynchronizing:
      return "sent SYNC" + std::to_string(sync_) + ", try " + std::to_string(tries_ + 1) + " of " +
             std::to_string(options_.syncTries) + after;
    case State::kResynchronizing:
      return "waits until the robot is silent" + after;
    case State::kOpening:
      return "waits for the robot's configuration and standard information";
    case State::kConnected:
      return "connected to " + identity_->name + " (" + identity_->robotClass + ", " + identity_->subclass +
             ")" + (configured_ ? "" : "; the robot has not told its configuration");
    case State::kFailed:
      return "has given up" + after;
  }
  return "";
}

}  // namespace robotlink::arcos
