// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/pioneer/PioneerOptions.h"

#include "app/core/pioneer/PioneerPlatform.h"
#include "robotlink/arcos/stream/StreamUrl.h"

namespace app {

RealRobotOptions pioneerOptions(std::string url, bool motorsOn) {
  // Normalized, so that the same robot always has the same address.
  const auto parsed = robotlink::arcos::parseUrl(url);
  if (parsed) url = robotlink::arcos::toString(*parsed);
  const auto platform = [url, motorsOn](
                            const robotlink::Clock& clock, const std::string& robot,
                            const robotlink::RobotDescription& description) -> RealRobotOptions::Platform {
    if (const auto address = robotlink::arcos::parseUrl(url); !address)
      return tl::unexpected(address.error());
    return std::make_unique<PioneerPlatform>(clock, robot, description,
                                             PioneerDriver::Options{.address = url, .motorsOn = motorsOn});
  };
  return {.adapter = kPioneerAdapter, .url = url, .robot = "p3at1", .kind = "p3at", .platform = platform};
}

}  // namespace app
