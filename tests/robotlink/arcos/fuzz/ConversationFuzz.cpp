// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/Conversation.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/arcos/fuzz/ArcosSeeds.h"

namespace arcos_conversation_fuzz {

using namespace robotlink::arcos;

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto conversation = readConversation({reinterpret_cast<const char*>(data), size}, "input");
  if (!conversation) {
    require(conversation.error().where.line > 0, "an error has its line");
    return 0;
  }
  // Times are kept to 0.1 ms, so only what was written once is written alike.
  const std::string text = writeConversation(*conversation);
  const auto again = readConversation(text, "text");
  require(again.has_value(), "what is written can be read");
  require(again->events.size() == conversation->events.size(), "every event is written");
  require(writeConversation(*again) == text, "what was read is written alike");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  Conversation all;
  all.events.push_back({Conversation::Kind::kNewConnection, {}, {}, {}});
  std::vector<std::string> seeds;
  for (const Packet& packet : arcosSeedPackets()) {
    const auto at = std::chrono::milliseconds(17 * all.events.size());
    all.events.push_back({Conversation::Kind::kPacket, at, Direction::kFromRobot, encode(packet)});
    seeds.push_back(writeEvent(all.events.back()));
  }
  all.events.push_back({Conversation::Kind::kPacket, {}, Direction::kFromClient, {1, 2, 3}});
  all.events.push_back({Conversation::Kind::kClosed, std::chrono::hours(3), {}, {}});
  seeds.push_back(writeConversation(all));
  seeds.push_back("# a remark\n\n=== new connection\r\n  -5.05 client closed");
  return seeds;
}

const FuzzRegistration kTarget({"arcos_conversation", &fuzzSeeds, &runInput});

}  // namespace arcos_conversation_fuzz
