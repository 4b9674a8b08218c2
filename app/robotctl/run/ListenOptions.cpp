// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/run/ListenOptions.h"

#include <CLI/CLI.hpp>

#include "robotlink/foxglove/protocol/Codec.h"

namespace app {

using robotlink::websocket::ListenAddress;

void ListenOptions::addTo(CLI::App& command) {
  option_ = command
                .add_option("--listen", text_,
                            "Lets clients of the Foxglove WebSocket protocol watch and steer the robots, at "
                            "[ADDRESS:]PORT (127.0.0.1:8765); until Ctrl-C unless --seconds is given")
                ->expected(0, 1)
                ->type_name("[ADDRESS:]PORT");
}

bool ListenOptions::given() const {
  return option_ != nullptr && option_->count() > 0;
}

robotlink::Result<ListenAddress> ListenOptions::address() const {
  auto address = robotlink::websocket::parseListenAddress(
      text_.empty() ? std::to_string(robotlink::websocket::kDefaultPort) : text_);
  if (address && !address->address.starts_with("127.") && address->address != "::1") {
    return robotlink::failure(
        "listen.address",
        "--listen takes addresses of this machine only, since there is no encryption yet: "
        "listen at 127.0.0.1, and forward the port with ssh -L");
  }
  return address;
}

}  // namespace app
