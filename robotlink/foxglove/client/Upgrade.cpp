// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Upgrade.h"

#include <boost/beast/http/field.hpp>
#include <boost/beast/http/status.hpp>

#include "robotlink/foxglove/client/Refusals.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

using Field = boost::beast::http::field;
using RequestDecorator = boost::beast::websocket::stream_base::decorator;

ShownToken shownToken(const UpgradeRequest& request) {
  const bool isShown = !request.token.empty() || request.url.target.find("token=") != std::string::npos;
  return isShown ? ShownToken::kOne : ShownToken::kNone;
}

}  // namespace

void prepareUpgrade(ClientSocket& socket, const UpgradeRequest& request) {
  socket.auto_fragment(false);
  socket.read_message_max(request.messageBytes);
  // The server decides whether what it sends is compressed; what is sent to it is short.
  boost::beast::websocket::permessage_deflate compression;
  compression.client_enable = true;
  socket.set_option(compression);
  socket.compress(false);
  socket.set_option(RequestDecorator(
      [name = request.name, token = request.token](boost::beast::websocket::request_type& asked) {
        asked.set(Field::sec_websocket_protocol, std::string(kSdkProtocol) + ", " + kWebSocketProtocol);
        asked.set(Field::user_agent, name);
        if (!token.empty()) asked.set(Field::authorization, "Bearer " + token);
      }));
}

std::optional<UpgradeProblem> problemWith(const boost::beast::websocket::response_type& response,
                                          const error_code& error, const UpgradeRequest& request) {
  using Failure = LinkWatch::Failure;
  if (error == boost::beast::websocket::error::upgrade_declined) {
    UpgradeProblem problem{Failure::kRefused,
                           whyRefused(response.result_int(), response.body(), shownToken(request))};
    if (response.result() == boost::beast::http::status::unauthorized)
      problem.objection.kind = ServerObjection::Kind::kToken;
    return problem;
  }
  if (error) return UpgradeProblem{Failure::kEnded, whyNoHandshake(error)};
  const std::string protocol(response[Field::sec_websocket_protocol]);
  if (protocol != kSdkProtocol && protocol != kWebSocketProtocol)
    return UpgradeProblem{Failure::kRefused, whyOtherProtocol(protocol)};
  return std::nullopt;
}

}  // namespace robotlink::websocket
