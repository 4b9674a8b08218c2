// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/beast/ssl/ssl_stream.hpp>
#include <boost/beast/websocket/ssl.hpp>

#include "robotlink/foxglove/server/StreamConnection.h"

namespace robotlink::websocket {

ConnectionPtr makeTlsConnection(ListenerPort& port, ListenerSocket socket, asio::ssl::context& tls) {
  using Secured = StreamConnection<beast::ssl_stream<ListenerSocket>>;
  return std::make_shared<Secured>(port, false, std::move(socket), tls);
}

}  // namespace robotlink::websocket
