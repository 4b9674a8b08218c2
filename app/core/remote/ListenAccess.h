// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/server/Listener.h"

namespace app {

/// The conditions under which clients may connect to offered robots. A plain value.
struct AccessOptions {
  /// Whether encryption and tokens are off, also at addresses that others reach.
  bool isInsecure = false;
  /// Encryption and tokens at every address; otherwise at those that other machines reach.
  bool isSecure = false;
  /// The file of the tokens, which is made if there is none; empty: "tokens" in stateDirectory(). Naming one
  /// demands tokens at every address.
  std::filesystem::path tokenFile = {};
  /// The same for the certificate; empty: "certificate.pem" there.
  std::filesystem::path certificateFile = {};
  /// Web pages that may connect: "https://example.org", or "*" for all.
  std::vector<std::string> origins = {};
};

/// The way in which a port is to be opened, and the notes for the person who opens it.
struct ListenAccess {
  robotlink::websocket::Listener::Options listening;
  /// Sentences: tokens that were made just now, where they are, the fingerprint, what is not secure.
  std::vector<std::string> notes;

  /// "ws" or "wss".
  std::string scheme() const { return listening.certificate ? "wss" : "ws"; }
};

/// Makes or reads certificate and tokens where they are needed.
robotlink::Result<ListenAccess> listenAccess(const robotlink::websocket::ListenAddress& address,
                                             const AccessOptions& options);

}  // namespace app
