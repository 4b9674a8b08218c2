// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/NarrowLines.h"

#include <algorithm>
#include <cmath>

namespace robotlink::websocket {
namespace {

constexpr Duration kNarrowWindow = std::chrono::seconds(1);
/// The number of images below which nothing can be concluded.
constexpr std::uint64_t kFewImages = 3;

/// "3 of 25".
std::string shareText(std::uint64_t sent, std::uint64_t thinned, Duration time) {
  const auto rate = [&](std::uint64_t count) {
    return std::to_string(std::lround(static_cast<double>(count) / seconds(time)));
  };
  return rate(sent) + " of " + rate(sent + thinned);
}

}  // namespace

std::vector<NarrowLines::Finding> NarrowLines::look(const std::vector<ClientState>& clients,
                                                    const std::set<std::string>& topics, Instant now) {
  std::vector<Finding> found;
  std::set<Key> present;
  for (const ClientState& client : clients) {
    for (const auto& [topic, counters] : client.streams) {
      // At a rate that the client has chosen most are left out.
      if (!topics.contains(topic) || client.rates.contains(topic)) continue;
      const Key key{client.info.id, topic};
      present.insert(key);
      const auto [entry, isNew] = counts_.try_emplace(key, Count{now, counters.sent, counters.thinned});
      Count& count = entry->second;
      if (isNew || count.isFound || now - count.since < kNarrowWindow) continue;
      const std::uint64_t sent = counters.sent - count.sent, thinned = counters.thinned - count.thinned;
      const std::string share = shareText(sent, thinned, now - count.since);
      count.since = now;
      count.sent = counters.sent;
      count.thinned = counters.thinned;
      const bool isNarrow = thinned >= kFewImages && thinned >= 2 * sent;
      count.narrow = isNarrow ? count.narrow + 1 : 0;
      // A long line takes a moment until it is as fast as it can be.
      if (count.narrow < 2 && !(isNarrow && thinned >= 5 * sent)) continue;
      count.isFound = true;
      found.push_back({client.info.id, topic,
                       "the link carries " + share + " raw images a second of " + topic +
                           "; as JPEG they are a tenth as large"});
    }
  }
  std::erase_if(counts_, [&](const auto& entry) { return !present.contains(entry.first); });
  return found;
}

}  // namespace robotlink::websocket
