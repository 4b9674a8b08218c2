// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Distrust.h"

#include "robotlink/foxglove/security/KnownServers.h"

namespace robotlink::websocket {

std::string hostOf(const ServerUrl& url) {
  const std::string host = url.host.find(':') == std::string::npos ? url.host : "[" + url.host + "]";
  return host + ":" + std::to_string(url.port);
}

Distrust whyNotTrusted(const std::string& server, const std::string& fingerprint,
                       const std::filesystem::path& knownServers,
                       const std::function<bool(const std::string&, const std::string&)>& isTrusted) {
  using Kind = ServerObjection::Kind;
  const KnownServers known(knownServers.empty() ? KnownServers::defaultFile() : knownServers);
  const auto isKnown = known.isKnown(server, fingerprint);
  if (!isKnown) {
    const auto& error = isKnown.error();
    // "known.changed" names server, fingerprint, the known one, and the file.
    const bool isChanged = error.id == "known.changed" && error.arguments.size() >= 3;
    if (!isChanged) return {error.describe()};
    return {error.describe(), {Kind::kOtherCertificate, server, fingerprint, error.arguments[2]}};
  }
  if (*isKnown) return {};
  if (isTrusted && !isTrusted(server, fingerprint))
    return {"the robot at " + server + " was never seen before; its fingerprint is " + fingerprint +
                ": compare it with the one that the robot printed",
            {Kind::kNewCertificate, server, fingerprint, {}}};
  const auto added = known.add(server, fingerprint);
  return {added ? "" : "the robot's fingerprint cannot be saved: " + added.error().describe()};
}

}  // namespace robotlink::websocket
