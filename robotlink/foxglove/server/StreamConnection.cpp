// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/StreamConnection.h"

#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>

namespace robotlink::websocket {

ConnectionPtr makePlainConnection(ListenerPort& port, ListenerSocket socket, bool isRefused) {
  return std::make_shared<StreamConnection<ListenerSocket>>(port, isRefused, std::move(socket));
}

ConnectionPtr makeTlsConnection(ListenerPort& port, ListenerSocket socket, asio::ssl::context& tls) {
  using Secured = StreamConnection<beast::ssl_stream<ListenerSocket>>;
  return std::make_shared<Secured>(port, false, std::move(socket), tls);
}

}  // namespace robotlink::websocket
