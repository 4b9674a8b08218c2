// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Refusals.h"

#include <algorithm>
#include <boost/asio/error.hpp>
#include <boost/asio/ssl/error.hpp>

#include "robotlink/base/Printable.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

using boost::system::error_code;
namespace asioError = boost::asio::error;

/// A foreign text as a part of a sentence: one line, not too long.
std::string shortened(const std::string& text) {
  constexpr std::size_t kMaxText = 300;
  std::string result = printable(text.substr(0, kMaxText));
  while (!result.empty() && (result.back() == ' ' || result.back() == '.')) result.pop_back();
  return result;
}

}  // namespace

std::string whyNotReached(const error_code& error) {
  if (error == asioError::connection_refused)
    return "nobody listens there: is the robot's program running, with --listen and this port?";
  if (error == asioError::host_unreachable || error == asioError::network_unreachable)
    return "there is no way to that machine: is it switched on, and in this network?";
  if (error == asioError::timed_out)
    return "nothing answers there; is the robot switched on, and in this network?";
  return "it cannot be connected: " + error.message();
}

std::string whyNotSecured(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset ||
      error == boost::asio::ssl::error::stream_truncated)
    return "the connection was closed before it was encrypted; is this the robot's port? If it does not "
           "encrypt, "
           "use ws://";
  return "what listens there does not encrypt as robots do: use ws:// if it does not encrypt at all (" +
         error.message() + ")";
}

std::string whyNoHandshake(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset)
    return "the connection was closed before it began; is this the robot's port?";
  return "what listens there is no WebSocket server; is this the robot's port? (" + error.message() + ")";
}

std::string whyRefused(unsigned status, const std::string& text, ShownToken shown) {
  const std::string theirs = shortened(text);
  const std::string http = "HTTP " + std::to_string(status) + (theirs.empty() ? "" : ": " + theirs);
  switch (status) {
    case 401:
      return std::string(shown == ShownToken::kOne ? "the robot wants another token"
                                                   : "the robot wants a token") +
             ": give the one that it printed when it was made (" + http + ")";
    case 403:
      return "the robot does not let this program in (" + http + ")";
    case 404:
      return "the robot has nothing at this address: leave out what follows the port (" + http + ")";
    case 503:
      return "the robot has too many clients: disconnect one (" + http + ")";
    default:
      return "the robot refused the connection (" + http + ")";
  }
}

std::string whyOtherProtocol(const std::string& protocol) {
  return "what listens there speaks " +
         (protocol.empty() ? "no sub-protocol" : "the sub-protocol '" + shortened(protocol) + "'") +
         ", but not " + kSdkProtocol + " or " + kWebSocketProtocol +
         ": is this the port of a Foxglove WebSocket server?";
}

std::string whyClosed(const std::string& reason) {
  const std::string theirs = shortened(reason);
  return theirs.empty() ? "the robot ended the connection" : "the robot ended the connection: " + theirs;
}

std::string whyTooLong(std::size_t maxBytes) {
  return "the robot sends messages of more than " + std::to_string(maxBytes >> 20U) +
         " MiB, which are not taken";
}

std::string whyNoToken(const std::string& token) {
  const bool isWord = std::ranges::all_of(token, [](char c) { return c > ' ' && c <= '~'; });
  return isWord
             ? ""
             : "the token is one word, without spaces and line breaks; give the one that the robot printed";
}

std::string whyTooLongForThem() {
  return "the robot ended the connection, because what was sent to it was longer than it takes";
}

std::string whyBroken(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset || error == asioError::broken_pipe)
    return "the robot's program ended, or the connection was cut";
  return "the connection broke: " + error.message();
}

}  // namespace robotlink::websocket
