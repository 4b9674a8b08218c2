// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/StreamConnection.h"

namespace robotlink::websocket {

ConnectionPtr makePlainConnection(ListenerPort& port, ListenerSocket socket, bool isRefused) {
  return std::make_shared<StreamConnection<ListenerSocket>>(port, isRefused, std::move(socket));
}

}  // namespace robotlink::websocket
