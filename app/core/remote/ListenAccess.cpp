// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/ListenAccess.h"

#include "robotlink/foxglove/security/SecretFile.h"
#include "robotlink/foxglove/security/Tokens.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using robotlink::websocket::KeptTokens;

std::string noteOf(const KeptTokens& kept, const fs::path& file) {
  if (!kept.isNew) return "Clients need a token; " + file.string() + " has it";
  return "Clients need a token. Two were made, and are printed only this time; " + file.string() +
         " keeps them.\n  to control: " + kept.tokens.control + "\n  to watch:   " + kept.tokens.watch;
}

robotlink::Result<void> addTokens(ListenAccess& access, const fs::path& file) {
  auto kept = robotlink::websocket::loadOrMakeTokens(file);
  if (!kept) return tl::unexpected(kept.error());
  access.listening.admission.token = kept->tokens.control;
  access.listening.admission.watchToken = kept->tokens.watch;
  access.notes.push_back(noteOf(*kept, file));
  return {};
}

robotlink::Result<void> addCertificate(ListenAccess& access, const fs::path& file) {
  auto certificate = robotlink::websocket::loadOrMakeCertificate(file);
  if (!certificate) return tl::unexpected(certificate.error());
  access.notes.push_back(
      "Connections are encrypted. Whoever connects for the first time is shown this fingerprint: " +
      certificate->fingerprint);
  access.listening.certificate = *std::move(certificate);
  return {};
}

}  // namespace

robotlink::Result<ListenAccess> listenAccess(const robotlink::websocket::ListenAddress& address,
                                             const AccessOptions& options) {
  ListenAccess access;
  access.listening.address = address;
  access.listening.admission.origins = options.origins;
  const bool isOpenToOthers = !isLoopback(address);
  if (options.isInsecure) {
    if (isOpenToOthers)
      access.notes.push_back(
          "Connections are not secure (--insecure): anyone who can reach " + toString(address) +
          " can watch and steer the robots, and read and change what is sent; use this only in a network "
          "whose users you all trust");
    return access;
  }
  const fs::path state = robotlink::websocket::stateDirectory();
  if (isOpenToOthers || options.isSecure || !options.tokenFile.empty()) {
    const auto added = addTokens(access, options.tokenFile.empty() ? state / "tokens" : options.tokenFile);
    if (!added) return tl::unexpected(added.error());
  }
  if (isOpenToOthers || options.isSecure) {
    const auto added = addCertificate(
        access, options.certificateFile.empty() ? state / "certificate.pem" : options.certificateFile);
    if (!added) return tl::unexpected(added.error());
  }
  return access;
}

}  // namespace app
