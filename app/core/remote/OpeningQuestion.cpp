// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OpeningQuestion.h"

#include <utility>

#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"

namespace app {

namespace websocket = robotlink::websocket;

void OpeningQuestion::begin(const PlatformOpening& opening) {
  asked_.reset();
  const std::string before =
      std::exchange(wanted_, {opening.sources.empty() ? std::string() : opening.sources.front(),
                              opening.withToken, opening.refusal})
          .url;
  if (before == wanted_.url) return;
  token_.clear();
  remembers_ = false;
}

bool OpeningQuestion::ask(const robotlink::Errors& errors) {
  auto question = questionIn(errors);
  if (!question || question->url != wanted_.url || !wanted_.withToken) return false;
  // A wrong token is not remembered.
  if (question->objection.kind == websocket::ServerObjection::Kind::kToken) {
    token_.clear();
    remembers_ = false;
  }
  asked_ = std::move(question);
  isOpen_ = false;
  return true;
}

robotlink::Result<void> OpeningQuestion::finish(const std::vector<std::string>& sources) {
  const bool isWanted = !sources.empty() && sources.front() == wanted_.url;
  open_ = isWanted ? wanted_ : Body();
  answered_.reset();
  if (!isWanted) return {};
  asked_.reset();
  const std::string token = std::exchange(token_, {});
  if (!std::exchange(remembers_, false) || token.empty()) return {};
  return websocket::RememberedTokens().add(wanted_.url, token);
}

void OpeningQuestion::follow() {
  // A question of the body that is being opened is answered first.
  if (!open_.refusal || (asked_ && !isOpen_)) return;
  asked_ = questionIn(open_.refusal());
  isOpen_ = asked_.has_value();
  if (asked_ && asked_ == answered_) {
    asked_.reset();
  } else {
    answered_.reset();
  }
}

robotlink::Result<std::optional<PlatformOpening>> OpeningQuestion::trust(const std::string& fingerprint) {
  if (!asked_ || asked_->objection.fingerprint.empty() || asked_->objection.fingerprint != fingerprint)
    return robotlink::failure("remote.fingerprint",
                              "the robot at " + wanted_.url + " does not ask to be trusted by " + fingerprint,
                              {}, {wanted_.url, fingerprint});
  if (const auto added = websocket::KnownServers().add(asked_->objection.server, fingerprint); !added)
    return tl::unexpected(added.error());
  if (!isOpen_) return wanted_.withToken({});
  answered_ = std::exchange(asked_, {});
  return std::nullopt;
}

PlatformOpening OpeningQuestion::show(const std::string& token) {
  if (isOpen_) wanted_ = open_;
  token_ = token;
  remembers_ = false;
  return wanted_.withToken(token);
}

bool OpeningQuestion::drop() {
  asked_.reset();
  return std::exchange(isOpen_, false);
}

}  // namespace app
