// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/body/BodyQuestion.h"

#include <utility>

#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"

namespace app {

namespace websocket = robotlink::websocket;

void BodyQuestion::begin(const PlatformOpening& opening) {
  asked_.reset();
  withToken_ = opening.withToken;
  const std::string url = opening.sources.empty() ? std::string() : opening.sources.front();
  if (std::exchange(url_, url) == url) return;
  token_.clear();
  remembers_ = false;
}

bool BodyQuestion::ask(const robotlink::Errors& errors) {
  auto question = questionIn(errors);
  if (!question || question->url != url_ || !withToken_) return false;
  // A wrong token is not remembered.
  if (question->objection.kind == websocket::ServerObjection::Kind::kToken) {
    token_.clear();
    remembers_ = false;
  }
  asked_ = std::move(question);
  return true;
}

robotlink::Result<void> BodyQuestion::finish(const std::vector<std::string>& sources) {
  if (sources.empty() || sources.front() != url_) return {};
  asked_.reset();
  const std::string token = std::exchange(token_, {});
  if (!std::exchange(remembers_, false) || token.empty()) return {};
  return websocket::RememberedTokens().add(url_, token);
}

robotlink::Result<PlatformOpening> BodyQuestion::trust(const std::string& fingerprint) {
  if (!asked_ || asked_->objection.fingerprint.empty() || asked_->objection.fingerprint != fingerprint)
    return robotlink::failure("remote.fingerprint",
                              "the robot at " + url_ + " does not ask to be trusted by " + fingerprint, {},
                              {url_, fingerprint});
  if (const auto added = websocket::KnownServers().add(asked_->objection.server, fingerprint); !added)
    return tl::unexpected(added.error());
  return withToken_({});
}

PlatformOpening BodyQuestion::show(const std::string& token) {
  token_ = token;
  remembers_ = false;
  return withToken_(token);
}

}  // namespace app
