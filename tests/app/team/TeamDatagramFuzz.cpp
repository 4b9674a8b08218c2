// SPDX-License-Identifier: GPL-3.0-or-later
// Datagrams in which robots of a team tell each other what they know.
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/core/team/TeamDatagram.h"
#include "robotcontrol/Game.pb.h"
#include "tests/fuzz/FuzzTarget.h"

using namespace app;

namespace {

void demandOfTeam(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto message = teamMessageIn({data, size});
  if (!message) {
    demandOfTeam(!message.error().text.empty(), "a refusal has a reason");
    return 0;
  }
  demandOfTeam(!(*message)->sender().empty(), "who has sent it is known");
  demandOfTeam(std::isfinite((*message)->ball_deviation()), "numbers are finite");
  const auto again = teamDatagram(**message);
  demandOfTeam(!again || teamMessageIn(*again).has_value(), "what was read can be sent again");
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
