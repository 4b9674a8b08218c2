// SPDX-License-Identifier: GPL-3.0-or-later
// The other program of tests over DDS: sends the package "ball" a hundred times a second until it is killed.
// Usage: dds_peer DOMAIN [other-version]
#include <cstdlib>
#include <string>
#include <thread>

#include "robotlink/dds/Fingerprint.h"
#include "robotlink/dds/ProgramNet.h"
#include "tests/robotlink/process/TestProcess.h"

using namespace robotlink;

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const bool isOther = argc > 2 && std::string(argv[2]) == "other-version";
  const auto node = dds::Node::open({.domain = static_cast<std::uint32_t>(std::atoi(argv[1])),
                                     .address = {},
                                     .peers = {},
                                     .multicast = false});
  if (!node) return 1;
  const SteadyClock clock;
  dds::ProgramNet::Behavior behavior;
  if (isOther) behavior.fingerprint = [](const auto& type) { return dds::fingerprintOf(type) + 1; };
  dds::ProgramNet net(*node, {"robot", "vision"}, clock, behavior);
  test::TestProcess process("from", clock);
  Sender<test::Ball> sender(process, "ball", Blocking::kNo);
  if (!net.link(sender, "from")) return 1;
  for (int i = 1;; ++i) {
    sender.send(test::ball(i));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}
