// SPDX-License-Identifier: GPL-3.0-or-later
// A robot's side of ARCOS, fed with what a client may send and with time that passes between the packets.
#include <cmath>
#include <cstdlib>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/arcos/IdealRobot.h"

namespace server_session_fuzz {

using namespace robotlink;
using namespace robotlink::arcos;

namespace {

void check(IdealRobot& robot) {
  constexpr double kFastest = 1.5 + 0.588 / 2 * radians(300.0) + 1e-9;
  require(std::abs(robot.wheels.command.left) <= kFastest, "the left wheels are limited");
  require(std::abs(robot.wheels.command.right) <= kFastest, "the right wheels are limited");
  for (const Packet& packet : robot.received) {
    require(packet.id < 0xFE, "no reserved numbers go out");
    require(packet.count() <= kMaxSentCount, "what goes out is short");
  }
  const bool waiting = robot.session.state() == ServerSession::State::kWaiting;
  require(!waiting || !robot.session.motion().motorsOn(), "it waits with its motors off");
  robot.forget();
}

}  // namespace

/// Bytes of the stream; 0xFF 0xFE n between them lets n steps pass.
int runInput(const std::uint8_t* data, std::size_t size) {
  IdealRobot robot;
  robot.connect();
  PacketParser parser;
  for (std::size_t i = 0; i < size; ++i) {
    if (i + 2 < size && data[i] == 0xFF && data[i + 1] == 0xFE) {
      for (int step = 0; step < data[i + 2]; ++step) robot.step();
      i += 2;
    } else {
      parser.push({data + i, 1});
    }
    while (const auto found = parser.next()) {
      if (const auto* packet = std::get_if<Packet>(&*found)) robot.send(*packet);
    }
    check(robot);
  }
  require(robot.session.takeRequests().size() <= 64, "requests are few");
  robot.session.clientGone(robot.now);
  robot.step();
  require(!robot.wheels.command.motorsOn, "without a client the motors are off");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  const auto text = [](std::initializer_list<Command> commands) {
    Bytes bytes;
    for (const Command& command : commands) {
      append(toPacket(command), bytes);
      bytes.insert(bytes.end(), {0xFF, 0xFE, 30});
    }
    return std::string(bytes.begin(), bytes.end());
  };
  return {
      text({command(CommandId::kEnable, 1), command(CommandId::kVel, 300), command(CommandId::kHead, -90),
            command(CommandId::kStop)}),
      text({command(CommandId::kLegacyLaserStart, -90), command(CommandId::kLegacyLaserEnd, 90),
            command(CommandId::kLegacyLaserEnable, 2), command(CommandId::kSimStat, 2)}),
      text({command(CommandId::kPolling, "\x01\x10\x03"), command(CommandId::kSonarCycle, 2),
            command(CommandId::kIoRequest, 2), command(CommandId::kGyro, 2), command(CommandId::kClose),
            command(CommandId::kSync0), command(CommandId::kSync1), command(CommandId::kSync2),
            command(CommandId::kOpen)}),
      text({{224, {}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}},
            {236, {}, {0x2B, 1, 0, 3, 0, 'a', 'b', 'c'}},
            command(CommandId::kSimMessage, "hello"),
            command(CommandId::kMove, -65535),
            command(CommandId::kVel2, joined({-128, 127}))}),
  };
}

const FuzzRegistration kTarget({"server_session", &fuzzSeeds, &runInput});

}  // namespace server_session_fuzz
