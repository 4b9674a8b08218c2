// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/LinkAccess.h"

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <string_view>

#include "robotlink/foxglove/security/RememberedTokens.h"

namespace app {
namespace {

namespace websocket = robotlink::websocket;
using Objection = websocket::ServerObjection;
using ObjectionKind = Objection::Kind;

constexpr char kRefused[] = "link.refused", kWantsToken[] = "link.token",
               kNewCertificate[] = "link.certificate.new", kOtherCertificate[] = "link.certificate.other";

std::string idOf(ObjectionKind kind) {
  switch (kind) {
    case ObjectionKind::kNone:
      break;
    case ObjectionKind::kToken:
      return kWantsToken;
    case ObjectionKind::kNewCertificate:
      return kNewCertificate;
    case ObjectionKind::kOtherCertificate:
      return kOtherCertificate;
  }
  return kRefused;
}

/// The name that others see when this program steers.
std::string nameOfThisProgram() {
  for (const char* variable : {"USER", "LOGNAME"}) {
    const char* user = std::getenv(variable);
    if (user != nullptr && *user != '\0') return std::string("RobotControl of ") + user;
  }
  return "RobotControl";
}

/// The one in "/?token=TOKEN&..."; empty: none.
std::string tokenIn(const std::string& target) {
  constexpr std::string_view kParameter = "token=";
  const std::size_t at = target.find(kParameter, std::min(target.find('?'), target.size()));
  if (at == std::string::npos) return {};
  const std::string rest = target.substr(at + kParameter.size());
  return rest.substr(0, rest.find('&'));
}

}  // namespace

TrustRule askWhomToTrust() {
  return [](const std::string&, const std::string&) { return false; };
}

TrustRule trustAndPrint(std::ostream& out) {
  return [&out](const std::string& server, const std::string& fingerprint) {
    out << "The robot at " << server << " is new here; its fingerprint is remembered: " << fingerprint
        << ": compare it with the one that the robot printed" << std::endl;
    return true;
  };
}

robotlink::Result<websocket::Connector::Options> linkOptions(const std::string& url, const std::string& token,
                                                             TrustRule isTrusted) {
  auto parsed = websocket::parseServerUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  websocket::Connector::Options options;
  options.url = *std::move(parsed);
  // A token in the URL takes precedence over the remembered one.
  options.token = token.empty() ? tokenIn(options.url.target) : token;
  if (options.token.empty())
    options.token = websocket::RememberedTokens().find(toString(options.url)).value_or(std::string());
  options.name = nameOfThisProgram();
  options.isTrusted = std::move(isTrusted);
  return options;
}

robotlink::Error refusalOf(const std::string& url, const websocket::ConnectionState& state) {
  const Objection& objection = state.objection;
  return {idOf(objection.kind),
          url + ": " + state.reason,
          {url, objection.server, objection.fingerprint, objection.knownFingerprint},
          {}};
}

std::optional<LinkQuestion> questionIn(const robotlink::Errors& errors) {
  for (const robotlink::Error& error : errors) {
    for (const ObjectionKind kind :
         {ObjectionKind::kToken, ObjectionKind::kNewCertificate, ObjectionKind::kOtherCertificate}) {
      if (error.id != idOf(kind) || error.arguments.size() != 4) continue;
      return LinkQuestion{error.arguments[0],
                          {kind, error.arguments[1], error.arguments[2], error.arguments[3]}};
    }
  }
  return std::nullopt;
}

}  // namespace app
