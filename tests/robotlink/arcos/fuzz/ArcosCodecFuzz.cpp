// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes from a line, and packets with any number and data, both ways.

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketDescription.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/codec/SimulatorCommands.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/arcos/fuzz/ArcosSeeds.h"

namespace arcos_codec_fuzz {

using namespace robotlink::arcos;

namespace {

void checkCommand(const Packet& packet) {
  const auto command = toCommand(packet);
  if (!command) return;
  const Packet back = toPacket(*command);
  require(back.data.size() <= kMaxData, "a command fits into a frame");
  const auto again = toCommand(back);
  require(again && *again == *command, "a command that is written is read as the same");
  static_cast<void>(check(*command));
  static_cast<void>(truePoseOf(*command));
  if (const auto control = simulatorControlOf(*command)) {
    require(simulatorControlOf(simulatorControl(*control)) == control, "a control is read as it was written");
  }
}

void checkServerPacket(const Packet& packet) {
  const auto decoded = decodeServerPacket(packet);
  if (decoded) require(toPacket(*decoded) == packet, "what is decoded is written back byte for byte");
}

void checkPacket(const Packet& packet) {
  checkCommand(packet);
  checkServerPacket(packet);
  for (const Direction direction : {Direction::kFromClient, Direction::kFromRobot}) {
    const PacketDescription description = describe(packet, direction);
    require(!description.name.empty() && !description.line().empty(), "every packet has a description");
    require(description.fields.size() <= 4 * kMaxData + 16, "descriptions are bounded");
  }
}

/// The whole input through a parser, in pieces whose lengths depend on the input.
void checkStream(const std::uint8_t* data, std::size_t size) {
  PacketParser parser;
  Bytes back;
  const auto drain = [&] {
    while (const auto found = parser.next()) {
      if (const auto* packet = std::get_if<Packet>(&*found)) {
        append(*packet, back);
        checkPacket(*packet);
      } else {
        const Bytes& bytes = std::get<DamagedBytes>(*found).bytes;
        require(!bytes.empty() && bytes.size() <= 256, "damage has a few bytes");
        back.insert(back.end(), bytes.begin(), bytes.end());
      }
    }
  };
  for (std::size_t at = 0; at < size;) {
    const std::size_t count = std::min<std::size_t>(1 + data[at] % 61, size - at);
    parser.push({data + at, count});
    if (data[at] % 3 != 0) drain();
    if (data[at] % 17 == 0) parser.dropPartial();
    at += count;
  }
  drain();
  parser.dropPartial();
  drain();
  require(size > PacketParser::kMaxBuffered || back == Bytes(data, data + size),
          "every byte is in one packet or damage");
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  checkStream(data, size);
  if (size > 0) checkPacket({data[0], Bytes(data + 1, data + std::min(size, kMaxData + 1))});
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  std::string all;
  for (const Packet& packet : arcosSeedPackets()) {
    const Bytes framed = encode(packet);
    seeds.emplace_back(framed.begin(), framed.end());
    all += seeds.back();
    seeds.emplace_back(framed.begin() + 3, framed.end() - 2);
  }
  seeds.push_back(all);
  return seeds;
}

const FuzzRegistration kTarget({"arcos_codec", &fuzzSeeds, &runInput});

}  // namespace arcos_codec_fuzz
