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
    return "nothing is listening there: is the robot's program running, with --listen and this port?";
  if (error == asioError::host_unreachable || error == asioError::network_unreachable)
    return "that machine cannot be reached: is it switched on, and on this network?";
  if (error == asioError::timed_out)
    return "nothing answers there; is the robot switched on, and on this network?";
  return "it cannot connect: " + error.message();
}

std::string whyNotSecured(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset ||
      error == boost::asio::ssl::error::stream_truncated)
    return "the connection was closed before it was encrypted; is this the robot's port? If it does not "
           "encrypt, "
           "use ws://";
  return "the encryption there is not a robot's: use ws:// if the robot does not encrypt (" +
         error.message() + ")";
}

std::string whyNoHandshake(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset)
    return "the connection was closed before it began; is this the robot's port?";
  return "that is not a WebSocket server; is this the robot's port? (" + error.message() + ")";
}

std::string whyRefused(unsigned status, const std::string& text, ShownToken shown) {
  const std::string theirs = shortened(text);
  const std::string http = "HTTP " + std::to_string(status) + (theirs.empty() ? "" : ": " + theirs);
  switch (status) {
    case 401:
      return std::string(shown == ShownToken::kOne ? "the robot requires a different token"
                                                   : "the robot requires a token") +
             ": use the one that it printed when it created it (" + http + ")";
    case 403:
      return "the robot does not accept this program (" + http + ")";
    case 404:
      return "the robot has nothing at this path: leave out what follows the port (" + http + ")";
    case 503:
      return "the robot has too many clients: disconnect one (" + http + ")";
    default:
      return "the robot refused the connection (" + http + ")";
  }
}

std::string whyOtherProtocol(const std::string& protocol) {
  return "the server there speaks " +
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
         " MiB, which are not accepted";
}

std::string whyNoToken(const std::string& token) {
  const bool isWord = std::ranges::all_of(token, [](char c) { return c > ' ' && c <= '~'; });
  return isWord
             ? ""
             : "the token is one word, without spaces and line breaks; give the one that the robot printed";
}

std::string whyTooLongForThem() {
  return "the robot ended the connection, because a message to it was longer than it accepts";
}

std::string whyBroken(const error_code& error) {
  if (error == asioError::eof || error == asioError::connection_reset || error == asioError::broken_pipe)
    return "the robot's program ended, or the connection was cut";
  return "the connection broke: " + error.message();
}

}  // namespace robotlink::websocket
