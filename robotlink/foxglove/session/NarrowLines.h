// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/foxglove/server/ServerOptions.h"

namespace robotlink::websocket {

/// Finds the clients whose lines do not carry the raw images that they subscribed to, by what was sent to
/// each of them and what was thinned. One thread; the time is passed in.
class NarrowLines {
 public:
  /// A client and a topic, for the first time.
  struct Finding {
    std::uint64_t client = 0;
    std::string topic;
    /// A sentence for the user.
    std::string text;
  };
  /// Call this from time to time; `topics` are those of raw images.
  std::vector<Finding> look(const std::vector<ClientState>& clients, const std::set<std::string>& topics,
                            Instant now);

 private:
  struct Count {
    Instant since;
    std::uint64_t sent = 0, thinned = 0;
    /// How often in a row it was too narrow; and whether that was found.
    int narrow = 0;
    bool isFound = false;
  };
  using Key = std::pair<std::uint64_t, std::string>;

  std::map<Key, Count> counts_;
};

}  // namespace robotlink::websocket
