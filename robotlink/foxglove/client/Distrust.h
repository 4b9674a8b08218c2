// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "robotlink/foxglove/client/ConnectionState.h"
#include "robotlink/foxglove/client/ServerUrl.h"

namespace robotlink::websocket {

/// A reason to refuse a server, with what a person can do about it.
struct Distrust {
  /// A sentence; empty: the server is trusted.
  std::string why;
  ServerObjection objection = {};
};

/// The host and port of a URL, with brackets for IPv6.
std::string hostOf(const ServerUrl& url);

/// Why the certificate with this fingerprint is not that of the robot that is meant. `isTrusted` is asked
/// about a server that is not in the file `knownServers` (empty: the user's), and believed if it is empty;
/// one that is believed is remembered there. For any thread.
Distrust whyNotTrusted(const std::string& server, const std::string& fingerprint,
                       const std::filesystem::path& knownServers,
                       const std::function<bool(const std::string&, const std::string&)>& isTrusted);

}  // namespace robotlink::websocket
