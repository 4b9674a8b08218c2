// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/system/error_code.hpp>
#include <string>

namespace robotlink::websocket {

// Sentences that tell the user why a connection failed and what to do.

/// The sentence for a malformed token; empty if it is well-formed or not given.
std::string whyNoToken(const std::string& token);
/// The sentence for a failed TCP connection.
std::string whyNotReached(const boost::system::error_code& error);
/// The sentence for a failed TLS handshake.
std::string whyNotSecured(const boost::system::error_code& error);
/// The sentence for an address that is not served by a WebSocket server.
std::string whyNoHandshake(const boost::system::error_code& error);
/// Whether the client presented a token to the server.
enum class ShownToken : bool { kNone, kOne };
/// The sentence for an HTTP status other than 101, with the server's text.
std::string whyRefused(unsigned status, const std::string& text, ShownToken shown);
/// The sentence for a server that chose an unsupported subprotocol.
std::string whyOtherProtocol(const std::string& protocol);
/// The sentence for a connection that the server closed with a reason, which may be empty.
std::string whyClosed(const std::string& reason);
/// The sentence for a message from the server that exceeds `maxBytes`.
std::string whyTooLong(std::size_t maxBytes);
/// The sentence for a connection that the server closed because a message of this client was too large.
std::string whyTooLongForThem();
/// The sentence for a connection that was lost.
std::string whyBroken(const boost::system::error_code& error);

}  // namespace robotlink::websocket
