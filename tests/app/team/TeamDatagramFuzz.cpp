// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams in which robots of a team tell each other what they know.
#include <cmath>

#include "app/core/team/TeamDatagram.h"
#include "robotcontrol/Game.pb.h"
#include "tests/fuzz/FuzzTarget.h"

namespace team_datagram_fuzz {

using namespace app;

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto message = teamMessageIn({data, size});
  if (!message) {
    require(!message.error().text.empty(), "a refusal has a reason");
    return 0;
  }
  require(!(*message)->sender().empty(), "who has sent it is known");
  require(std::isfinite((*message)->ball_deviation()), "numbers are finite");
  const auto again = teamDatagram(**message);
  require(!again || teamMessageIn(*again).has_value(), "what was read can be sent again");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  for (const char* sender : {"red1", "blue2"}) {
    robotcontrol::TeamMessage message;
    message.set_sender(sender);
    message.set_team("red");
    message.mutable_pose_in_field()->set_x(1.5);
    message.set_ball_known(true);
    message.set_state("striker");
    const auto datagram = teamDatagram(message).value();
    seeds.emplace_back(datagram.begin(), datagram.end());
  }
  return seeds;
}

const FuzzRegistration kTarget({"team_datagram", &fuzzSeeds, &runInput});

}  // namespace team_datagram_fuzz
