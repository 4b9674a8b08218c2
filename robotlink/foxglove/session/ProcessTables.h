// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/foxglove/server/ConnectionGraph.h"

namespace robotlink::websocket {

// Tables of processes as connection graphs of the protocol, and back.

/// The processes of a robot, with ids such as "red1/cognition", and their packages as topics,
/// "red1/models/ball".
ConnectionGraph graphOf(const std::string& robot, const robotcontrol::ProcessTable& table);

/// The nodes of a foreign server as processes, and its topics as packages. `types` has those of the topics,
/// as far as they are known. How often a node runs, and how much it sends, the protocol does not say. Bounded
/// to 500 processes and 10,000 links.
robotcontrol::ProcessTable tableOf(const ConnectionGraph& graph,
                                   const std::map<std::string, std::string>& types);

}  // namespace robotlink::websocket
