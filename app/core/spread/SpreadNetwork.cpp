// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/spread/SpreadNetwork.h"

#include "robotlink/base/Spelling.h"
#include "robotlink/dds/LocalAddresses.h"

namespace app {
namespace {

bool isOnLoopback(const std::string& address) {
  return address.starts_with("127.");
}

std::string noteOf(const SpreadOptions& options, const robotlink::dds::NodeOptions& node) {
  const std::string domain = " (DDS domain " + std::to_string(options.domain) + ")";
  if (node.address.empty()) {
    return "Packages between programs go over the loopback interface" + domain +
           "; every user of this machine can read and send them.";
  }
  return "Packages between programs go over the network of " + node.address + domain +
         ", neither encrypted nor protected: anyone in it can read them and command the robot. Use this only "
         "in networks that you trust.";
}

}  // namespace

robotlink::Result<SpreadNetwork> spreadNetworkOf(const robotlink::Layout& layout,
                                                 const SpreadOptions& options) {
  const robotlink::Layout::Program* program = layout.findProgram(options.program);
  if (program == nullptr) {
    std::vector<std::string> names;
    for (const auto& one : layout.programs) names.push_back(one.name);
    return robotlink::failure(
        "spread.program",
        names.empty() ? "layout " + layout.name + " names no programs; add 'programs:', or omit --program"
                      : "layout " + layout.name + " has no program '" + options.program + "'" +
                            robotlink::suggestion(options.program, names),
        {layout.file, 0, 0}, {layout.name, options.program});
  }
  SpreadNetwork network;
  network.node.domain = options.domain;
  if (!program->host.empty() && !options.local) {
    const std::string address = robotlink::dds::addressOf(program->host);
    const std::string why = robotlink::dds::whyNotUsable(address, robotlink::dds::localInterfaces());
    if (!why.empty()) {
      return robotlink::failure("spread.host",
                                "program " + program->name + " belongs to " + program->host + ": " + why +
                                    "; start it there, or all programs here with --local",
                                program->where, {program->name, program->host});
    }
    if (!isOnLoopback(address)) network.node.address = address;
    for (const auto& other : layout.programs) network.node.peers.push_back(other.host);
  }
  network.note = noteOf(options, network.node);
  return network;
}

}  // namespace app
