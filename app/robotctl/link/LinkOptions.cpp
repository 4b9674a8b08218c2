// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/link/LinkOptions.h"

#include <CLI/CLI.hpp>

namespace app {

void LinkOptions::addTo(CLI::App& command) {
  command.add_option("url", url, "Where the robot is: ws://HOST:PORT")->required()->type_name("URL");
  command.add_option("--token", token, "The robot's token, which it printed when it was made")
      ->envname("ROBOTCONTROL_TOKEN");
}

robotlink::Result<robotlink::websocket::Connector::Options> LinkOptions::connection() const {
  auto parsed = robotlink::websocket::parseServerUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  robotlink::websocket::Connector::Options options;
  options.url = *std::move(parsed);
  options.token = token;
  options.name = "robotctl";
  return options;
}

}  // namespace app
