// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/remote/LinkAccess.h"

namespace app {

/// Keeps the objection (certificate, token) of a remote body whose program runs or is to run here, until the
/// user has answered. At most one question at a time. One thread.
class OpeningQuestion {
 public:
  /// Call this when a platform is going to be opened; earlier questions are dropped.
  void begin(const PlatformOpening& opening);
  /// Call this when opening failed. Returns whether the user can resolve the failure, and is therefore asked.
  bool ask(const robotlink::Errors& errors);
  /// A platform with these sources is open. If it is the one: remembers the token if the user wanted that.
  robotlink::Result<void> finish(const std::vector<std::string>& sources);
  /// Asks what the body that is open objects to now. Call this often, while no platform is being opened.
  void follow();

  const std::optional<LinkQuestion>& asked() const { return asked_; }
  bool isAbout(const std::string& url) const { return asked_ && asked_->url == url; }
  /// The user has compared the fingerprint: it is remembered. Returns the opening to repeat; unset if
  /// it is open, since its connection is tried again all the time. Fails if it is not the fingerprint in the
  /// question.
  robotlink::Result<std::optional<PlatformOpening>> trust(const std::string& fingerprint);
  /// The user has entered a token. Returns what is to be opened again.
  PlatformOpening show(const std::string& token);
  /// The token that was entered is to be remembered, if the body accepts it.
  void rememberToken() { remembers_ = true; }
  /// Whether it is being opened with a token that was entered.
  bool isShowing(const std::string& url) const { return !token_.empty() && wanted_.url == url; }
  /// Gives up opening, since the user no longer wants it. Returns whether it is open.
  bool drop();

 private:
  /// A body, as its PlatformOpening says.
  struct Body {
    std::string url;
    std::function<PlatformOpening(const std::string& token)> withToken;
    std::function<robotlink::Errors()> refusal;
  };

  /// The one that is, or was, to be opened, and the one that is open.
  Body wanted_, open_;
  std::optional<LinkQuestion> asked_;
  /// Whether that is about open_.
  bool isOpen_ = false;
  /// The question that the user has answered while the connection was not tried again yet.
  std::optional<LinkQuestion> answered_;
  /// The token that the user has entered, and whether to remember it.
  std::string token_;
  bool remembers_ = false;
};

}  // namespace app
