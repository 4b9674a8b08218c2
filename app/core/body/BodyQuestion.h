// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/remote/LinkAccess.h"

namespace app {

/// What a body elsewhere objects to that is to be opened with its program here, until the user has answered:
/// then it is opened again. At most one. One thread.
class BodyQuestion {
 public:
  /// A platform is going to be opened; what was asked before is not asked any more.
  void begin(const PlatformOpening& opening);
  /// It could not be. Returns whether the user can do something about it, and so is asked.
  bool ask(const robotlink::Errors& errors);
  /// A platform with these sources is open. If it is the one: remembers the token if the user wanted that.
  robotlink::Result<void> finish(const std::vector<std::string>& sources);

  const std::optional<LinkQuestion>& asked() const { return asked_; }
  bool isAbout(const std::string& url) const { return asked_ && asked_->url == url; }
  /// The user has compared the fingerprint: it is remembered. Returns what is to be opened again. Fails if it
  /// is not the one that was asked about.
  robotlink::Result<PlatformOpening> trust(const std::string& fingerprint);
  /// The user has entered a token. Returns what is to be opened again.
  PlatformOpening show(const std::string& token);
  /// The token that was entered is to be remembered, if the body accepts it.
  void rememberToken() { remembers_ = true; }
  /// Whether it is being opened with a token that was entered.
  bool isShowing(const std::string& url) const { return !token_.empty() && url_ == url; }
  /// The user does not want it any more.
  void drop() { asked_.reset(); }

 private:
  std::optional<LinkQuestion> asked_;
  /// Opens it again.
  std::function<PlatformOpening(const std::string& token)> withToken_;
  std::string url_;
  /// That the user has entered, and whether it is to be remembered.
  std::string token_;
  bool remembers_ = false;
};

}  // namespace app
