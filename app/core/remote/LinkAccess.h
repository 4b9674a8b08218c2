// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/foxglove/client/Connector.h"

namespace app {

// The way in which all programs of this user connect to remote robots.

/// Decides whether a robot that was never seen is the intended one, see Connector::Options::isTrusted.
using TrustRule = std::function<bool(const std::string& server, const std::string& fingerprint)>;
/// Returns the rule that trusts no unknown robot: the user is asked, see LinkQuestion.
TrustRule askWhomToTrust();
/// Returns the rule that trusts each unknown robot and prints its fingerprint; for commands, which cannot ask
/// a user.
TrustRule trustAndPrint(std::ostream& out);

/// The options of a connection, in the name of this user. Without a token, neither here nor in the URL, the
/// one that is remembered for this URL is shown. Fails if the URL makes no sense.
robotlink::Result<robotlink::websocket::Connector::Options> linkOptions(const std::string& url,
                                                                        const std::string& token,
                                                                        TrustRule isTrusted);

/// An objection of a remote robot, as long as a person can resolve it. A plain value.
struct LinkQuestion {
  /// The URL as toString(ServerUrl) returns it.
  std::string url;
  robotlink::websocket::ServerObjection objection;
  bool operator==(const LinkQuestion&) const = default;
};

/// Returns why there is no connection, as an error from which questionIn() reads the question to the user.
robotlink::Error refusalOf(const std::string& url, const robotlink::websocket::ConnectionState& state);
/// Returns the question in these errors; unset if they are about something else.
std::optional<LinkQuestion> questionIn(const robotlink::Errors& errors);

}  // namespace app
