// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/foxglove/client/Connector.h"

namespace CLI {
class App;
}

namespace app {

/// The options of all commands that connect to a robot: its URL and its token.
struct LinkOptions {
  std::string url, token;

  void addTo(CLI::App& command);
  robotlink::Result<robotlink::websocket::Connector::Options> connection() const;
};

}  // namespace app
