// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/link/LinkOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "robotlink/foxglove/security/RememberedTokens.h"

namespace app {

void LinkOptions::addTo(CLI::App& command) {
  command.add_option("url", url, "Where the robot is: ws://HOST:PORT, or wss:// if it encrypts")
      ->required()
      ->type_name("URL");
  command.add_option("--token", token, "The robot's token, which it printed when it was made")
      ->envname("ROBOTCONTROL_TOKEN");
}

robotlink::Result<robotlink::websocket::Connector::Options> LinkOptions::connection() const {
  auto parsed = robotlink::websocket::parseServerUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  robotlink::websocket::Connector::Options options;
  options.url = *std::move(parsed);
  // One in the URL is what the user wants.
  const bool isGiven = !token.empty() || options.url.target.find("token=") != std::string::npos;
  options.token =
      isGiven ? token : robotlink::websocket::RememberedTokens().find(toString(options.url)).value_or("");
  options.name = "robotctl";
  options.isTrusted = [](const std::string& server, const std::string& fingerprint) {
    std::cerr << "The robot at " << server << " is new here, and remembered by its fingerprint "
              << fingerprint << ": compare it with the one that the robot printed" << std::endl;
    return true;
  };
  return options;
}

}  // namespace app
