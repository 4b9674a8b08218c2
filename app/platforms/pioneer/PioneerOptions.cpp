// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerOptions.h"

#include "app/platforms/pioneer/PioneerPlatform.h"

namespace app {

RealRobotOptions pioneerOptions(std::string url, bool motorsOn) {
  // Normalized, so that the same robot always has the same address.
  const auto parsed = PioneerAddress::parse(url);
  if (parsed) url = parsed->text();
  const std::string kind = parsed ? parsed->kind : PioneerAddress().kind;
  const auto platform = [url, motorsOn](
                            const robotlink::Clock& clock, const std::string& robot,
                            const robotlink::RobotDescription& description) -> RealRobotOptions::Platform {
    const auto address = PioneerAddress::parse(url);
    if (!address) return tl::unexpected(address.error());
    const std::string line = robotlink::arcos::toString(address->line);
    return std::make_unique<PioneerPlatform>(
        clock, robot, description, PioneerDriver::Options{.address = line, .motorsOn = motorsOn}, *address);
  };
  return {.adapter = kPioneerAdapter, .url = url, .robot = kind + "1", .kind = kind, .platform = platform};
}

}  // namespace app
