// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/ConnectionGraph.h"

#include <algorithm>

namespace robotlink::websocket {
namespace {

using Ids = ConnectionGraphUpdate::Ids;

constexpr std::size_t kMaxNames = 10'000, kMaxIds = 100;

/// The names whose ids have changed; those that are gone have none.
Ids changes(const Ids& before, const Ids& now) {
  Ids changed;
  for (const auto& [name, ids] : now) {
    const auto known = before.find(name);
    if (known == before.end() || known->second != ids) changed.emplace(name, ids);
  }
  for (const auto& [name, ids] : before)
    if (!now.contains(name)) changed.emplace(name, std::vector<std::string>());
  return changed;
}

void replace(const Ids& changed, Ids& known) {
  for (const auto& [name, ids] : changed) {
    if (ids.empty())
      known.erase(name);
    else if (known.size() < kMaxNames || known.contains(name))
      known[name] = {ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(std::min(ids.size(), kMaxIds))};
  }
}

/// Removing a topic removes it from both lists, so it must no longer be in either.
void moveRemoved(Ids& changed, const Ids& now, const Ids& others, std::vector<std::string>& removed) {
  std::erase_if(changed, [&](const auto& entry) {
    const std::string& name = entry.first;
    if (now.contains(name) || others.contains(name)) return false;
    if (std::ranges::find(removed, name) == removed.end()) removed.push_back(name);
    return true;
  });
}

}  // namespace

ConnectionGraphUpdate difference(const ConnectionGraph& before, const ConnectionGraph& now) {
  ConnectionGraphUpdate update;
  update.publishedTopics = changes(before.publishedTopics, now.publishedTopics);
  update.subscribedTopics = changes(before.subscribedTopics, now.subscribedTopics);
  update.advertisedServices = changes(before.advertisedServices, now.advertisedServices);
  moveRemoved(update.publishedTopics, now.publishedTopics, now.subscribedTopics, update.removedTopics);
  moveRemoved(update.subscribedTopics, now.subscribedTopics, now.publishedTopics, update.removedTopics);
  moveRemoved(update.advertisedServices, now.advertisedServices, {}, update.removedServices);
  return update;
}

void apply(const ConnectionGraphUpdate& update, ConnectionGraph& graph) {
  replace(update.publishedTopics, graph.publishedTopics);
  replace(update.subscribedTopics, graph.subscribedTopics);
  replace(update.advertisedServices, graph.advertisedServices);
  for (const std::string& topic : update.removedTopics) {
    graph.publishedTopics.erase(topic);
    graph.subscribedTopics.erase(topic);
  }
  for (const std::string& service : update.removedServices) graph.advertisedServices.erase(service);
}

}  // namespace robotlink::websocket
