// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/system/error_code.hpp>
#include <string>

namespace robotlink::websocket {

// Why there is no connection, as sentences that say what to do.

/// The token cannot be one of a robot; empty: it may be, or none was given.
std::string whyNoToken(const std::string& token);
/// TCP could not be connected.
std::string whyNotReached(const boost::system::error_code& error);
/// Encryption could not be agreed on.
std::string whyNotSecured(const boost::system::error_code& error);
/// What listens did not answer as a WebSocket server does.
std::string whyNoHandshake(const boost::system::error_code& error);
/// Whether a token was shown to it.
enum class ShownToken : bool { kNone, kOne };
/// It answered with another HTTP status than 101, and this text.
std::string whyRefused(unsigned status, const std::string& text, ShownToken shown);
/// It chose this sub-protocol.
std::string whyOtherProtocol(const std::string& protocol);
/// It ended the connection with this reason, which may be empty.
std::string whyClosed(const std::string& reason);
/// It sent a message of more than `maxBytes`.
std::string whyTooLong(std::size_t maxBytes);
/// It ended the connection because of a message that was sent to it.
std::string whyTooLongForThem();
/// The connection broke.
std::string whyBroken(const boost::system::error_code& error);

}  // namespace robotlink::websocket
