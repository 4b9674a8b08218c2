// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ClientSession that runs after the handshake.
#include <algorithm>

#include "robotlink/arcos/ClientSession.h"
#include "robotlink/arcos/codec/ServerPackets.h"

namespace robotlink::arcos {
namespace {

using State = ClientSession::State;

constexpr Duration kGapWindow = std::chrono::seconds(5);
constexpr std::size_t kMaxGaps = 256;

bool isInformation(std::uint8_t id) {
  return id == StandardInformation::kStandingId || id == StandardInformation::kMovingId;
}

}  // namespace

ClientSession::News ClientSession::applyConnection(const Packet& packet, Instant now) {
  if (isInformation(packet.id)) return takeInformation(packet, now);
  if (packet.id == Configuration::kId) return takeConfiguration(packet, now);
  if (packet.id == LaserPacket::kPlainId || packet.id == LaserPacket::kExtendedId)
    return takeLaser(packet, now);
  return News::kNothing;
}

ClientSession::News ClientSession::takeInformation(const Packet& packet, Instant now) {
  auto information = decode<StandardInformation>(packet);
  if (!information) {
    ++statistics_.undecodable;
    return News::kNothing;
  }
  if (informed_) {
    gaps_.push_back({now, now - informationAt_});
    if (gaps_.size() > kMaxGaps) gaps_.pop_front();
  }
  information_ = std::move(*information);
  informationAt_ = now;
  informed_ = true;
  ++statistics_.information;
  if (state_ == State::kOpening && configured_) becomeConnected(now);
  return News::kInformation;
}

ClientSession::News ClientSession::takeConfiguration(const Packet& packet, Instant now) {
  auto configuration = decode<Configuration>(packet);
  if (!configuration) {
    ++statistics_.undecodable;
    return News::kNothing;
  }
  configuration_ = std::move(*configuration);
  if (askedAt_ && !askedTwice_) statistics_.roundTrip = now - *askedAt_;
  askedAt_.reset();
  configured_ = true;
  if (state_ == State::kOpening && informed_) becomeConnected(now);
  return News::kConfiguration;
}

ClientSession::News ClientSession::takeLaser(const Packet& packet, Instant now) {
  const auto part = decode<LaserPacket>(packet);
  if (!part) {
    ++statistics_.undecodable;
    return News::kNothing;
  }
  auto scan = assembler_.take(*part, informed_ ? &*information_ : nullptr, now);
  statistics_.incompleteScans = assembler_.incompleteScans();
  if (!scan) return News::kNothing;
  scan_ = std::move(*scan);
  ++statistics_.scans;
  return News::kScan;
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
    lose({"arcos.lost", "nothing was received from the robot for " + limit + " s", {}, {}}, now);
    return;
  }
  if (now - informationAt_ >= options_.linkTimeout) {
    lose({"arcos.lost-information",
          "the robot sends packets, but no standard information packet for " + limit + " s",
          {},
          {}},
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

}  // namespace robotlink::arcos
