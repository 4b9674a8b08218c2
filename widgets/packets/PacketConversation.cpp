// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/packets/PacketConversation.h"

#include <QObject>
#include <algorithm>

#include "widgets/packets/PacketModel.h"

namespace widgets {
namespace {

namespace arcos = robotlink::arcos;
using robotlink::Duration;
using robotlink::Instant;

constexpr Duration kLongestTick = std::chrono::milliseconds(250);
constexpr int kOpen = 1, kClose = 2;  // SYNC1 and SYNC2 have the same numbers

arcos::Conversation::Event marker(arcos::Conversation::Kind kind, Duration at) {
  arcos::Conversation::Event event;
  event.kind = kind;
  event.at = at;
  return event;
}

PacketEntry markerEntry(PacketEntry::Kind kind, Instant time) {
  PacketEntry entry;
  entry.kind = kind;
  entry.time = time;
  entry.name =
      kind == PacketEntry::Kind::kClosed ? QObject::tr("connection closed") : QObject::tr("new connection");
  return entry;
}

}  // namespace

arcos::Conversation conversationOf(const PacketModel& model) {
  using Kind = arcos::Conversation::Kind;
  arcos::Conversation conversation;
  if (model.rowCount() == 0) return conversation;
  Instant start = model.entry(0).time;
  if (model.entry(0).kind != PacketEntry::Kind::kNewConnection)
    conversation.events.push_back(marker(Kind::kNewConnection, {}));
  for (int row = 0; row < model.rowCount(); ++row) {
    const PacketEntry& entry = model.entry(row);
    if (entry.kind == PacketEntry::Kind::kNewConnection) {
      start = entry.time;
      conversation.events.push_back(marker(Kind::kNewConnection, {}));
      continue;
    }
    auto event = marker(entry.kind == PacketEntry::Kind::kClosed ? Kind::kClosed : Kind::kPacket,
                        std::max(Duration(0), entry.time - start));
    event.direction = entry.fromRobot ? arcos::Direction::kFromRobot : arcos::Direction::kFromClient;
    event.bytes.assign(entry.bytes.begin(), entry.bytes.end());
    conversation.events.push_back(std::move(event));
  }
  return conversation;
}

std::vector<PacketEntry> entriesOf(const arcos::Conversation& conversation) {
  std::vector<PacketEntry> entries;
  entries.reserve(conversation.events.size());
  // Times of each connection count from its beginning; in one list the connections follow each other.
  Instant start, last;
  for (const auto& event : conversation.events) {
    if (event.kind == arcos::Conversation::Kind::kNewConnection) {
      start = last;
      entries.push_back(markerEntry(PacketEntry::Kind::kNewConnection, start));
      continue;
    }
    last = std::max(last, start + event.at);
    if (event.kind == arcos::Conversation::Kind::kClosed) {
      entries.push_back(markerEntry(PacketEntry::Kind::kClosed, last));
      continue;
    }
    const bool fromRobot = event.direction == arcos::Direction::kFromRobot;
    entries.push_back(
        packetEntry(start + event.at, fromRobot, std::string(event.bytes.begin(), event.bytes.end())));
  }
  return entries;
}

ClientHalf clientHalf(const PacketModel& model) {
  ClientHalf half;
  std::optional<Instant> first;
  for (int row = 0; row < model.rowCount(); ++row) {
    const PacketEntry& entry = model.entry(row);
    if (entry.kind != PacketEntry::Kind::kPacket || entry.fromRobot) continue;
    const int id = packetId(entry);
    if (id == kOpen || id == kClose) {
      ++half.leftOut;
      continue;
    }
    if (!first) first = entry.time;
    half.packets.push_back({std::max(Duration(0), entry.time - *first), entry.bytes});
  }
  return half;
}

void ConversationReplay::begin(ClientHalf half, bool stepping) {
  half_ = std::move(half);
  next_ = 0;
  reached_ = Duration(0);
  last_.reset();
  state_ = half_.packets.empty() ? State::kIdle : stepping ? State::kStepping : State::kRunning;
}

void ConversationReplay::setStepping(bool stepping) {
  if (state_ == State::kIdle) return;
  state_ = stepping ? State::kStepping : State::kRunning;
  last_.reset();
  if (next_ < half_.packets.size()) reached_ = half_.packets[next_].at;
}

std::vector<std::string> ConversationReplay::tick(Instant now) {
  std::vector<std::string> due;
  if (state_ != State::kRunning) return due;
  if (last_) reached_ += std::clamp(now - *last_, Duration(0), kLongestTick);
  last_ = now;
  while (next_ < half_.packets.size() && half_.packets[next_].at <= reached_)
    due.push_back(half_.packets[next_++].bytes);
  if (next_ == half_.packets.size()) state_ = State::kIdle;
  return due;
}

std::string ConversationReplay::step() {
  if (state_ != State::kStepping || next_ >= half_.packets.size()) return {};
  std::string bytes = half_.packets[next_++].bytes;
  if (next_ == half_.packets.size()) state_ = State::kIdle;
  return bytes;
}

}  // namespace widgets
