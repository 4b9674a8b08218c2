// SPDX-License-Identifier: GPL-3.0-or-later
// For the sources of a SessionServer only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace robotlink::websocket {

class SessionServer;

/// Filled by the link's thread, emptied by tick(); outlives the SessionServer with the server's handlers.
struct PostedWork {
  using Work = std::function<void(SessionServer&)>;

  void add(Work work) {
    const std::lock_guard lock(mutex);
    waiting.push_back(std::move(work));
  }
  /// Before everything that is not urgent.
  void addUrgent(Work work) {
    const std::lock_guard lock(mutex);
    urgent.push_back(std::move(work));
  }
  /// Takes the place of what waits of the same client and topic.
  void addNewest(std::uint64_t client, const std::string& topic, Work work) {
    const std::lock_guard lock(mutex);
    newest[{client, topic}] = std::move(work);
  }
  std::vector<Work> take() {
    const std::lock_guard lock(mutex);
    std::vector<Work> all = std::exchange(urgent, {});
    std::ranges::move(std::exchange(waiting, {}), std::back_inserter(all));
    for (auto& [from, work] : std::exchange(newest, {})) all.push_back(std::move(work));
    return all;
  }
  void clear() { static_cast<void>(take()); }

  std::mutex mutex;
  std::vector<Work> urgent, waiting;
  std::map<std::pair<std::uint64_t, std::string>, Work> newest;
};

}  // namespace robotlink::websocket
