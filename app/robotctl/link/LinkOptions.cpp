// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/link/LinkOptions.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "app/core/remote/LinkAccess.h"

namespace app {

void LinkOptions::addTo(CLI::App& command) {
  command.add_option("url", url, "The robot's URL: ws://HOST:PORT, or wss:// for encryption")
      ->required()
      ->type_name("URL");
  command.add_option("--token", token, "The robot's token, as printed when it was created")
      ->envname("ROBOTCONTROL_TOKEN");
}

robotlink::Result<robotlink::websocket::Connector::Options> LinkOptions::connection() const {
  auto options = linkOptions(url, token, trustAndPrint(std::cerr));
  if (options) options->name = "robotctl";
  return options;
}

}  // namespace app
