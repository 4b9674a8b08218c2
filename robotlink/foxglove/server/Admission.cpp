// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Admission.h"

#include <algorithm>
#include <string_view>

#include "robotlink/base/Printable.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {
namespace {

/// The limit of machines that are remembered; each is forgotten when its time is over.
constexpr std::size_t kMaxWaiting = 1024;
/// The limit for showing a page's origin, which may be any text.
constexpr std::size_t kMaxOrigin = 200;

/// Takes the same time wherever the texts differ.
bool isSame(std::string_view a, std::string_view b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  return difference == 0;
}

/// The value of ?token=... in the target of a request.
std::string_view tokenIn(std::string_view target) {
  constexpr std::string_view kName = "token=";
  const std::size_t question = target.find('?');
  if (question == std::string_view::npos) return {};
  for (std::string_view query = target.substr(question + 1); !query.empty();) {
    const std::string_view part = query.substr(0, query.find('&'));
    if (part.starts_with(kName)) return part.substr(kName.size());
    query.remove_prefix(std::min(part.size() + 1, query.size()));
  }
  return {};
}

/// Whether a comma-separated list has the word.
bool lists(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    std::string_view item = list.substr(0, list.find(','));
    list.remove_prefix(std::min(item.size() + 1, list.size()));
    while (!item.empty() && item.front() == ' ') item.remove_prefix(1);
    while (!item.empty() && item.back() == ' ') item.remove_suffix(1);
    if (item == word) return true;
  }
  return false;
}

/// Describes the problem with the token of a request, for its client and for the robot's log.
std::string sentenceOnToken(const Knock& knock) {
  const bool isShown = !knock.authorization.empty() || !tokenIn(knock.target).empty();
  return std::string(isShown ? "The token is not one of this robot's." : "No token was sent.") +
         " This robot requires its token as 'Authorization: Bearer TOKEN' or as '?token=TOKEN' after the "
         "URL; it printed the token when it created it, and prints at each start which file has it.";
}

}  // namespace

Instant Admission::decidableAt(const std::string& address) const {
  const auto found = waiting_.find(address);
  return found == waiting_.end() ? Instant::min() : found->second;
}

bool Admission::showsToken(const Knock& knock, const std::string& token) const {
  constexpr std::string_view kBearer = "Bearer ";
  const std::string_view header = knock.authorization;
  const bool inHeader = header.starts_with(kBearer) && isSame(header.substr(kBearer.size()), token);
  const bool inTarget = isSame(tokenIn(knock.target), token);
  return !token.empty() && (inHeader || inTarget);
}

std::variant<Admitted, Refusal> Admission::decide(const Knock& knock, Instant now) {
  if (!knock.isWebSocket)
    return Refusal{426,
                   "This is a robot's WebSocket port: connect with RobotControl or any other client of the "
                   "Foxglove WebSocket protocol."};
  const auto allowed = [&](const std::string& origin) { return origin == "*" || origin == knock.origin; };
  if (!knock.origin.empty() && std::ranges::none_of(options_.origins, allowed))
    return Refusal{403, "Web pages of " + printable(knock.origin.substr(0, kMaxOrigin)) +
                            " may not connect to this robot, unless it is told to allow them."};
  std::erase_if(waiting_, [&](const auto& entry) { return entry.second <= now; });
  // Both are compared always, which takes the same time whatever is shown.
  const bool isMaster = showsToken(knock, options_.token), isWatcher = showsToken(knock, options_.watchToken);
  const bool isOpen = options_.token.empty() && options_.watchToken.empty();
  if (!isOpen && !isMaster && !isWatcher) {
    if (waiting_.size() >= kMaxWaiting)
      waiting_.erase(std::ranges::min_element(waiting_, {}, [](const auto& entry) { return entry.second; }));
    waiting_[knock.address] = now + options_.wrongTokenDelay;
    return Refusal{401, sentenceOnToken(knock), true};
  }
  for (const char* protocol : {kSdkProtocol, kWebSocketProtocol})
    if (lists(knock.protocols, protocol)) return Admitted{protocol, isWatcher && !isMaster};
  return Refusal{400, std::string("This robot speaks the sub-protocols ") + kSdkProtocol + " and " +
                          kWebSocketProtocol + ": offer one of them as Sec-WebSocket-Protocol."};
}

}  // namespace robotlink::websocket
