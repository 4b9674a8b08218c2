// SPDX-License-Identifier: GPL-3.0-or-later
// A client's session fed with anything at any time. The input is a script of steps, each a letter and what it
// needs.

#include "robotlink/arcos/ClientSession.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/arcos/fuzz/ArcosSeeds.h"

namespace arcos_client_session_fuzz {

using namespace robotlink;
using namespace robotlink::arcos;

namespace {

using State = ClientSession::State;

/// The script; at its end all is 0.
class Script {
 public:
  Script(const std::uint8_t* data, std::size_t size) : data_(data, size) {}
  bool ended() const { return data_.empty(); }
  std::uint8_t byte() {
    if (data_.empty()) return 0;
    const std::uint8_t value = data_[0];
    data_ = data_.subspan(1);
    return value;
  }
  Bytes bytes(std::size_t count) {
    const auto taken = data_.first(std::min(count, data_.size()));
    data_ = data_.subspan(taken.size());
    return {taken.begin(), taken.end()};
  }

 private:
  std::span<const std::uint8_t> data_;
};

/// From a millisecond to weeks; back, too.
Duration someTime(std::uint8_t byte) {
  const auto forwards = std::chrono::milliseconds(std::int64_t{1} << (byte % 32U)) * (1 + byte / 64);
  return byte == 255 ? -forwards : forwards;
}

void checkOutgoing(ClientSession& session) {
  const Bytes bytes = session.takeOutgoing();
  require(bytes.size() < 100000, "what goes out is bounded");
  PacketParser parser;
  parser.push(bytes);
  while (const auto found = parser.next()) {
    const auto* packet = std::get_if<Packet>(&*found);
    require(packet && packet->count() <= kMaxSentCount, "whole packets go out, that robots take");
  }
  require(!parser.isPartial(), "what goes out ends with a packet");
}

void checkState(const ClientSession& session) {
  require(!session.describe().empty(), "it says what it does");
  if (session.isConnected()) {
    require(session.identity() && session.information(), "a robot that is connected is known");
    require(!session.problem(), "there is no problem while it is connected");
    require(session.wantsLink(), "a connection needs its line");
  }
  if (session.state() == State::kPausing || session.state() == State::kFailed) {
    require(session.problem().has_value(), "it says why there is no connection");
  }
  if (session.laserScan()) {
    require(session.laserScan()->rangesMm.size() == session.laserScan()->reflectances.size(),
            "scans are whole");
  }
}

void obey(Script& script, ClientSession& session, PacketParser& parser, Instant& now) {
  switch (script.byte()) {
    case 'o':
      return session.open(now);
    case 'l':
      return session.linkOpened(now);
    case 'x':
      return session.linkClosed({"x", "broken", {}, {}}, now);
    case 'c':
      return session.close(now);
    case 'p': {
      const std::uint8_t id = script.byte();
      session.take(Packet{id, script.bytes(script.byte())}, now);
      return;
    }
    case 'b': {
      parser.push(script.bytes(script.byte()));
      while (const auto found = parser.next()) session.take(*found, now);
      return;
    }
    case 's': {
      const std::uint8_t id = script.byte();
      static_cast<void>(session.send(Packet{id, script.bytes(script.byte())}, now));
      return;
    }
    case 'v':
      static_cast<void>(session.send(command(CommandId::kVel, (script.byte() - 128) * 1000), now));
      return;
    case 'w':
      return checkOutgoing(session);
    default:
      now += someTime(script.byte());
      session.tick(now);
  }
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  Script script(data, size);
  ClientSession::Options options;
  options.reconnect = script.byte() % 2 == 0;
  ClientSession session(options);
  PacketParser parser;
  Instant now{};
  while (!script.ended()) {
    obey(script, session, parser, now);
    checkState(session);
  }
  checkOutgoing(session);
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const auto packet = [](const Packet& value) {
    std::string text = {'p', static_cast<char>(value.id), static_cast<char>(value.data.size())};
    text.append(value.data.begin(), value.data.end());
    return text;
  };
  const std::string handshake = std::string("\0ol", 3) + packet({0, {}}) + packet({1, {}}) +
                                packet(toPacket(Identity{})) + "t\x07w" + packet(toPacket(Configuration{})) +
                                packet(toPacket(StandardInformation{}));
  std::string everything = handshake;
  for (const Packet& seed : arcosSeedPackets()) everything += packet(seed) + "t\x06";
  std::string busy = std::string("\0ol", 3);
  for (int i = 0; i < 10; ++i) busy += packet(toPacket(StandardInformation{})) + "t\x09";
  return {handshake,
          everything,
          busy,
          handshake + "v\xF0t\x0Ct\x0Ct\x0Ctl",
          handshake + "c" + handshake,
          handshake + packet({0xFF, {}}) + "t\x09t\x09t\x09t\x09t\x09",
          handshake + "xt\x0Al"};
}

const FuzzRegistration kTarget({"arcos_client_session", &fuzzSeeds, &runInput});

}  // namespace arcos_client_session_fuzz
