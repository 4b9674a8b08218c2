// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/foxglove/protocol/ServerMessages.h"

namespace robotlink::websocket {

/// The ids of processes that publish topics, subscribe to them, or provide services, by their names.
struct ConnectionGraph {
  ConnectionGraphUpdate::Ids publishedTopics, subscribedTopics, advertisedServices;
};

/// Returns the update for a client that knows `before`.
ConnectionGraphUpdate difference(const ConnectionGraph& before, const ConnectionGraph& now);

/// Applies an update to a client's graph. A server may invent names: 10,000 of each kind are kept, with
/// 100 ids each.
void apply(const ConnectionGraphUpdate& update, ConnectionGraph& graph);

}  // namespace robotlink::websocket
