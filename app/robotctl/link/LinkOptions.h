// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/foxglove/client/Connector.h"

namespace CLI {
class App;
}

namespace app {

/// What all commands need that connect with a robot: where it is, and its token.
struct LinkOptions {
  std::string url, token;

  void addTo(CLI::App& command);
  robotlink::Result<robotlink::websocket::Connector::Options> connection() const;
};

}  // namespace app
