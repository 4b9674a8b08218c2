// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "robotlink/foxglove/security/Certificate.h"

namespace robotlink::websocket {

// Settings of TLS for both ends: 1.2 at least, no renegotiation, no compression. For sources that use Asio.

/// A server's, with its certificate.
Result<std::shared_ptr<boost::asio::ssl::context>> makeServerTls(const Certificate& certificate);
/// A client's. Certificates are not checked: no one vouches for a robot. Compare the fingerprint of the one
/// that the server shows, after the handshake, with the known one (KnownServers).
Result<std::shared_ptr<boost::asio::ssl::context>> makeClientTls();

/// The fingerprint of the certificate that the other end of a connection showed; empty without one.
std::string peerFingerprint(SSL* connection);

}  // namespace robotlink::websocket
