// SPDX-License-Identifier: GPL-3.0-or-later
// Files of tokens, known robots and certificates, and what an HTTP request shows as a token.
#include "robotlink/foxglove/security/Certificate.h"
#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "robotlink/foxglove/security/Tokens.h"
#include "robotlink/foxglove/server/Admission.h"
#include "robotlink/foxglove/server/ListenAddress.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/robotlink/foxglove/Demand.h"

namespace foxglove_secrets_fuzz {

using namespace robotlink;
using namespace robotlink::websocket;
using robotlink::websocket::test::demand;

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const auto tokens = parseTokens(text, "f")) {
    demand(parseTokens(toText(*tokens), "f") == *tokens, "tokens are written as they are read");
    Admission admission({.token = tokens->control, .watchToken = tokens->watch});
    const auto decided = admission.decide({true, "a", "foxglove.sdk.v1", {}, "Bearer ", "/"}, Instant());
    demand(std::holds_alternative<Refusal>(decided), "no token is a wrong one");
  }
  if (const auto known = KnownServers::parse(text, "f")) {
    for (const auto& [server, fingerprint] : *known)
      demand(!server.empty() && fingerprint.starts_with("SHA256:"), "lines of known robots are whole");
  }
  if (const auto remembered = RememberedTokens::parse(text, "f")) {
    for (const auto& [url, token] : *remembered)
      demand(!url.empty() && !token.empty(), "lines of remembered tokens are whole");
  }
  static_cast<void>(parseCertificate(text, "f"));
  Admission admission({.token = "0123456789abcdef", .watchToken = "fedcba9876543210"});
  const auto decided = admission.decide({true, "a", text, {}, text, text}, Instant());
  const auto* refusal = std::get_if<Refusal>(&decided);
  const bool isShown =
      text.find("0123456789abcdef") != text.npos || text.find("fedcba9876543210") != text.npos;
  demand(isShown || (refusal != nullptr && refusal->isWrongToken), "who shows no token is refused");
  if (const auto address = parseListenAddress(text))
    demand(parseListenAddress(toString(*address)) == *address, "addresses are written as they are read");
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  return {"robotcontrol-tokens 1\n# x\ncontrol 0123456789abcdef\nwatch fedcba9876543210\n",
          "robotcontrol-known-robots 1\nred1:8765 SHA256:abc\n[::1]:1 SHA256:d\n",
          "robotcontrol-robot-tokens 1\nwss://red1:8765 0123456789abcdef\n",
          "/?a=b&token=fedcba9876543210",
          "Bearer 0123456789abcdef",
          "[::1]:8765",
          "-----BEGIN PRIVATE KEY-----\nMIGHAgEAMBMGByqGSM49AgEGCCqGSM49AwEHBG0wawIBAQ==\n-----END PRIVATE "
          "KEY-----\n"};
}

const FuzzRegistration kTarget({"foxglove_secrets", &fuzzSeeds, &runInput});

}  // namespace foxglove_secrets_fuzz
