// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/spread/SpreadProgram.h"

#include "app/core/program/InsideProgram.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

robotlink::Result<std::unique_ptr<SpreadProgram>> SpreadProgram::open(const SpreadOptions& options,
                                                                      const robotlink::Layout& layout,
                                                                      const std::string& robot,
                                                                      const robotlink::Clock& clock,
                                                                      const Report& report) {
  const auto network = spreadNetworkOf(layout, options);
  if (!network) return tl::unexpected(network.error());
  auto node = robotlink::dds::Node::open(network->node);
  if (!node) return tl::unexpected(node.error());
  auto presence = robotlink::dds::ProgramPresence::claim(
      *node, {robot, options.program, robotlink::dds::ProgramPresence::here()}, report);
  if (!presence) return tl::unexpected(presence.error());
  auto source = robotlink::dds::ClockSource::open(*node, robot, clock);
  if (!source) return tl::unexpected(source.error());
  std::unique_ptr<SpreadProgram> made(new SpreadProgram);
  made->program_ = options.program;
  made->net_ = std::make_unique<robotlink::dds::ProgramNet>(
      *node, robotlink::dds::ProgramNet::Identity{robot, options.program}, clock,
      robotlink::dds::ProgramNet::Behavior{{}, report});
  made->clock_ = std::move(*source);
  made->presence_ = std::move(*presence);
  report(network->note);
  return made;
}

HostedProgram::Maker SpreadProgram::maker() {
  return [this](HostedProgram::Parts parts) {
    return InsideProgram::create(std::move(parts), {program_, net_.get()});
  };
}

robotlink::Error SpreadProgram::refusalOfLayout(const std::filesystem::path& file) {
  return {"spread.layout",
          "the layout of a robot whose processes are spread over several programs cannot be changed while "
          "they run; end all of them, and start them with " +
              file.string(),
          {file.string()},
          {}};
}

}  // namespace app
